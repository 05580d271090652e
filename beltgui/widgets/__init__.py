"""Widgets that also work alone: 3D view, plots, table of samples, numbers, banner, question."""
