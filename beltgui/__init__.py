"""Commissioning, daily check and offline work on a belt grinding cell; above `devices` and `core`."""

__version__ = "0.2.0"
