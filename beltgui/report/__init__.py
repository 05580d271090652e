"""The report of a commissioning: one HTML file with everything inside."""

from beltgui.report.page import Figure, Page, Section, Table, render

__all__ = ["Figure", "Page", "Section", "Table", "render"]
