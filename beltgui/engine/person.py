"""The person at the screen: asked for mounting, touching and motions; the work waits for the answer."""

from __future__ import annotations

import threading
from collections import Counter
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from beltgui.engine.messages import Answer, Event, Question, QuestionGone
from beltgui.jobs import Cancelled
from devices.interfaces import (
    MAX_SPEED_MM_S,
    DeadlineExceeded,
    Mount,
    Operator,
    Refused,
    Request,
    RobotPath,
    Stopped,
    TouchCone,
)

MOUNT, TOUCH, MOTION = "mount", "touch", "motion"


class Person:
    """One question at a time.

    Args:
        emit: Shows events; called without any lock held, may answer at once.
        on_motion_answer: Told of the answer to a motion before the work goes on, in the thread of the answer.
    """

    def __init__(self, emit: Callable[[Event], None], on_motion_answer: Callable[[Answer], None]) -> None:
        self._emit, self._on_motion_answer = emit, on_motion_answer
        self._changed = threading.Condition()
        self._number = 0
        self._open: Question | None = None
        self._answer: Answer | None = None
        self._end = ""
        self._done: Counter[str] = Counter()
        self._series: set[str] = set()

    # ---- from the thread that takes commands

    def begin_job(self) -> None:
        """New work: counting and series begin anew."""
        with self._changed:
            self._end = ""
            self._done.clear()
            self._series.clear()

    def answer(self, answer: Answer) -> None:
        """Take an answer; one to a question that is not open any more (a second click) changes nothing."""
        with self._changed:
            question = self._open
            if question is None or answer.question != question.number or self._answer is not None:
                return
            if question.kind == MOTION:
                self._on_motion_answer(answer)
            elif answer.yes and answer.for_series:
                self._series.add(question.kind)
            self._answer = answer
            self._changed.notify_all()

    def interrupt(self, how: str) -> None:
        """End the waiting, `stopped` or `cancelled`; the job under way is not answered any more."""
        with self._changed:
            self._end = how
            self._changed.notify_all()

    # ---- from the thread that does the work

    def ask_motion(self, path: RobotPath, purpose: str) -> bool:
        """Show a path; whether the person wants it (a decision has no deadline: nothing moves meanwhile)."""
        return self._ask(
            MOTION, "motion", f"The robot moves {purpose}.", path=path.base_from_flange, length_mm=path.length_mm,
            duration_s=path.duration_s, speed_mm_s=MAX_SPEED_MM_S,
        )  # fmt: skip

    def ask_request(self, request: Request, deadline_s: float) -> bool:
        """Show an instruction; whether it was done.

        Raises:
            DeadlineExceeded: nobody answered within `deadline_s` seconds.
        """
        if isinstance(request, Mount):
            return self._ask(MOUNT, f"mount {request.item}", request.instruction, deadline_s=deadline_s)
        cone = isinstance(request, TouchCone)
        return self._ask(
            TOUCH, "touch cone" if cone else "touch shaft", request.instruction, deadline_s=deadline_s,
            planned=request.count if isinstance(request, TouchCone) else 0,
        )  # fmt: skip

    def _ask(
        self,
        kind: str,
        picture: str,
        text: str,
        *,
        deadline_s: float | None = None,
        planned: int = 0,
        path: NDArray[np.float64] | None = None,
        length_mm: float = 0.0,
        duration_s: float = 0.0,
        speed_mm_s: float = 0.0,
    ) -> bool:
        with self._changed:
            self._raise_end()
            done = self._done[kind]
            if kind in self._series:
                self._done[kind] += 1
                return True
            self._number += 1
            question = Question(
                self._number, kind, picture, text, path, length_mm, duration_s, speed_mm_s, done, planned
            )
            self._open, self._answer = question, None
        self._emit(question)
        with self._changed:
            self._changed.wait_for(lambda: self._answer is not None or self._end, deadline_s)
            answer, self._open = self._answer, None
        self._emit(QuestionGone(question.number))
        with self._changed:
            self._raise_end()
            if answer is None:
                raise DeadlineExceeded("operator", f"nobody confirmed within {deadline_s:g} s: {text}")
            self._done[kind] += int(answer.yes)
        return answer.yes

    def _raise_end(self) -> None:
        if self._end == "stopped":
            raise Stopped("operator", "stopped by a person. Begin again to go on.")
        if self._end:
            raise Cancelled("The job was cancelled.")


class AskedOperator:
    """An `Operator` who is asked on the screen.

    Args:
        person: At the screen.
        hand: Does in the simulated cell what was confirmed; None where the person does it.
        mounted: What is on the flange at the beginning, if that is known.
    """

    def __init__(self, person: Person, hand: Operator | None, mounted: Mount | None = None) -> None:
        self._person, self._hand, self._mounted = person, hand, mounted

    def perform(self, request: Request, *, deadline_s: float = 600.0) -> None:
        """Ask for something and come back when it is done.

        What was mounted last is not asked for again: the ball stays where it is between two steps. A blade is: whoever
        asks for it wants to know that it is clamped fast, since every clamping is another one.

        Raises:
            Refused: the person declined.
            DeadlineExceeded: nobody confirmed in time.
            Stopped: a person stopped the work.
            Cancelled: a person ended the work.
        """
        if isinstance(request, Mount) and request == self._mounted and request.item != "blade":
            return
        if not self._person.ask_request(request, deadline_s):
            raise Refused("operator", f"it was declined: {request.instruction} Begin again to go on.")
        if isinstance(request, Mount):
            self._mounted = None  # unknown until it is done
        if self._hand is not None:
            self._hand.perform(request, deadline_s=deadline_s)
        if isinstance(request, Mount):
            self._mounted = request
