"""The nouns between the engines: the plant, the problem, what may change, plans and their bounds."""
