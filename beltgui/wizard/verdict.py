"""What the banner says of a step."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from beltgui.app.language import sentence
from beltgui.steps.state import StepState
from beltgui.viewmodel.step import Action, StepContent, StepView
from beltgui.widgets.banner import BannerKind

Said = tuple[BannerKind | None, str, tuple[str, ...], tuple[str, ...]]


def verdict_of(view: StepView) -> Said:
    """Kind, headline, lines, and what is shown on demand only, in the language of the screen."""
    translate = QCoreApplication.translate
    content = view.content
    why = tuple(sentence(text) for text in view.why)
    if content is None:
        return BannerKind.INFO, translate("Verdict", "The session is being restored."), why, ()
    judged = Action.ACCEPT in view.actions and content.ok is True
    if view.state is StepState.STALE and not judged:
        return BannerKind.STALE, translate("Verdict", "Stale because:"), why or _reasons(content), ()
    if view.state is StepState.ACCEPTED and not judged:
        return BannerKind.ACCEPTED, _headline(view), (), _remarks(content)
    if not content.rows and view.why and Action.ACQUIRE not in view.actions:
        return BannerKind.BLOCKED, "", why, ()
    if content.ok is None:
        return _without_result(view, content, why)
    if content.provisional:
        so_far = translate("Verdict", "so far good") if content.ok else translate("Verdict", "so far not good enough")
        headline = f"{so_far}: {_headline(view)}" if _headline(view) else so_far
        return BannerKind.PROVISIONAL, headline, _reasons(content), _remarks(content)
    if content.ok:
        return BannerKind.OK, _headline(view), (), _remarks(content)
    return BannerKind.REJECTED, _headline(view), _reasons(content), _remarks(content)


def _without_result(view: StepView, content: StepContent, why: tuple[str, ...]) -> Said:
    translate = QCoreApplication.translate
    reasons = _reasons(content)
    if view.state is StepState.FAILED:
        return BannerKind.FAILED, "", tuple(dict.fromkeys((*why, *reasons))), ()
    if not content.rows and not reasons and not why:
        return None, "", (), ()
    headline = "" if reasons or why else translate("Verdict", "More samples are needed.")
    return BannerKind.MISSING, headline, tuple(dict.fromkeys((*reasons, *why))), ()


def _headline(view: StepView) -> str:
    content = view.content
    return sentence((content.headline if content is not None else "") or view.headline)


def _reasons(content: StepContent) -> tuple[str, ...]:
    return tuple(sentence(reason.message) for reason in content.reasons)


def _remarks(content: StepContent) -> tuple[str, ...]:
    return tuple(sentence(text) for text in content.remarks)
