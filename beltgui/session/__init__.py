"""A session: one folder that holds every sample, setting, result and decision of a commissioning."""

from beltgui.session.store import INPUTS, Sample, Session, StoredResult

__all__ = ["INPUTS", "Sample", "Session", "StoredResult"]
