"""Fine workpiece: its own panel."""
