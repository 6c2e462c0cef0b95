"""RAPID: text to tokens to a syntax tree with spans, and an interpreter that runs it into flat motions."""
