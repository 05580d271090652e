"""Runs the work of the wizard: one session, one cell, one job at a time; in a process of its own beside the screen."""
