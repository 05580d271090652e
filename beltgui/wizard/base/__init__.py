"""Base: its own panel."""
