"""A session: one folder that holds every sample, setting, result and decision of a commissioning."""

from beltgui.session.rows import Basis, Decision, Edit, Sample, Snapshot, StepSnapshot, StoredResult
from beltgui.session.store import INPUTS, Session

__all__ = ["INPUTS", "Basis", "Decision", "Edit", "Sample", "Session", "Snapshot", "StepSnapshot", "StoredResult"]
