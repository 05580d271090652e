"""The demonstration: a simulated cell is commissioned from nothing and the results are held against its truth."""

from beltgui.demo.run import DemoResult, run_demo

__all__ = ["DemoResult", "run_demo"]
