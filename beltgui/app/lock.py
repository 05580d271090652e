"""Why the export is locked, in the language of the screen."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from beltgui.app.known import Known
from beltgui.app.language import sentence
from beltgui.app.names import state_word
from beltgui.widgets.words import step_word


def export_lock(known: Known) -> tuple[str, ...]:
    """One sentence for each step that is not accepted, in their order; empty if the export is free."""
    lock = []
    for view in known.not_accepted():
        if isinstance(view, str):
            text = QCoreApplication.translate("Lock", "{step}: nothing has been taken yet.")
            lock.append(text.format(step=step_word(view)))
        else:
            why = " ".join(sentence(line) for line in view.why)
            lock.append(f"{step_word(view.step)}: {state_word(view.state)}. {why}".strip())
    return tuple(lock)
