"""Stylus and tool: its own panel."""
