"""Ball: its own panel."""
