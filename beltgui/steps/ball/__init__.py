"""Step 1, ball: the scanner on its stage."""
