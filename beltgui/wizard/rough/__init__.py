"""Rough workpiece: its own panel."""
