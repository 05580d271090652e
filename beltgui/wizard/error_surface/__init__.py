"""Error surface: its own panel."""
