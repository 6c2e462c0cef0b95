"""What a RAPID program computes with: types, values, names, predefined data."""
