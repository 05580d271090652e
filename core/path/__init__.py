"""Path: contacts on the airfoil, compensation by the error surface, robot poses and the robot program."""

from core.path.contact import AirfoilSurface, contact_frames, presenting_poses, tool_from_contact, work_from_contact
from core.path.job import PathJob, path_job_from_dict
from core.path.pattern import PatternSettings, pattern_lines
from core.path.plan import CellFrames, PathPlan, Stroke, compensate, plan_path
from core.path.reach import Workspace, check_workspace
from core.path.urscript import ProgramProof, ProgramSettings, read_urscript, verify_program, write_urscript

__all__ = [
    "AirfoilSurface",
    "CellFrames",
    "PathJob",
    "PathPlan",
    "PatternSettings",
    "ProgramProof",
    "ProgramSettings",
    "Stroke",
    "Workspace",
    "check_workspace",
    "compensate",
    "contact_frames",
    "path_job_from_dict",
    "pattern_lines",
    "plan_path",
    "presenting_poses",
    "read_urscript",
    "tool_from_contact",
    "verify_program",
    "work_from_contact",
    "write_urscript",
]
