"""The nouns between the engines: the plant, plans and their bounds, and the judge's findings."""
