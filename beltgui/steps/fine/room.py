"""Fine workpiece: the room."""

from __future__ import annotations

from typing import Any

from beltgui.jobs import Job
from beltgui.steps.clamping import acquire_blade_scans, common_clamping
from beltgui.steps.context import Context
from beltgui.steps.fine import step
from beltgui.steps.fine.faces import FACES, chosen_faces
from beltgui.steps.fine.remembered import remember_faces, remembered_faces
from beltgui.steps.fine.step import FineOutcome
from beltgui.steps.room import Bench
from beltgui.steps.scans import KIND, scan_of
from beltgui.viewmodel.step import StepContent


class FineRoom:
    """Pose of the blade from its faces; the setting `faces` holds the ids of those to measure on."""

    step = "fine"

    def begin(self, bench: Bench, person: str) -> None:
        """In a new session, choose the faces that were accepted last for this blade type, if others than its own.

        Raises:
            InputError: the user's file of choices cannot be read.
        """
        faces = remembered_faces(bench.blade, bench.model)
        if faces is not None and set(faces) != set(chosen_faces(bench)):
            bench.session.choose(self.step, FACES, list(faces), person)

    def accepted(self, bench: Bench) -> None:
        """Remember the chosen faces for the next session of this blade type.

        Raises:
            InputError: the user's file of choices cannot be read or written.
        """
        remember_faces(bench.blade, bench.model, chosen_faces(bench))

    def acquire(self, bench: Bench, context: Context) -> None:
        """Scan the clamped blade from where there is no scan yet; ask for the blade if something else was mounted."""
        acquire_blade_scans(bench, context, self.step, fresh=False)

    def solve(self, bench: Bench, job: Job) -> FineOutcome:
        """Register the scans on the chosen faces.

        The rough step's scans of the same clamping check that the blade has not slipped since.
        """
        job.report(0.0, "reading the scans")
        samples = bench.session.kept(self.step, KIND)
        clamping = common_clamping(samples)
        before = {sample.data.get("clamping") for sample in bench.session.kept("rough", KIND)}
        start = bench.found["rough"].measure_from_work
        return step.solve(
            [scan_of(bench.session, sample) for sample in samples],
            bench.found["ball"].stage,
            bench.found["base"].fit,
            bench.model,
            bench.blade,
            start,
            unmoved_since=start if before == {clamping} else None,
            face_ids=chosen_faces(bench),
            progress=job.part(0.1, 0.95).report,
        )

    def record(self, outcome: FineOutcome) -> dict[str, Any]:
        """For the session and the report."""
        return step.record(outcome)

    def headline(self, outcome: FineOutcome) -> str:
        """The number that matters."""
        return step.headline(outcome)

    def view(self, bench: Bench, outcome: FineOutcome | None, error: str = "") -> StepContent:
        """What the screen shows."""
        from beltgui.steps.fine.view import content

        return content(bench, outcome, error)
