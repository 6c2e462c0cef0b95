"""The cell file: which robot stands where, under which limits, and what its program may count on."""
