"""The strip at the bottom: each device's state as shape, word and since when; who works on which blade type."""

from __future__ import annotations

from datetime import datetime

from PySide6.QtCore import QEvent
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QWidget

from beltgui.app.elided import ElidedLabel
from beltgui.app.language import sentence
from beltgui.app.names import SHAPES, device_name, device_state_word
from beltgui.app.theme import colour, px, theme
from beltgui.engine.messages import DeviceState


class DeviceStrip(QWidget):
    """All devices in one line."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("device_strip")
        self._devices: tuple[DeviceState, ...] = ()
        self._since: dict[str, datetime] = {}
        self._labels: dict[str, QLabel] = {}
        self._who = ("", "", "")
        self._layout = QHBoxLayout(self)
        self._layout.addStretch(1)
        self._sentence = ElidedLabel(1, self)
        self._sentence.setObjectName("who_works")
        self._sentence.setProperty("tone", "muted")
        self._sentence.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        self._layout.addWidget(self._sentence)
        theme().changed.connect(self._write)
        self._write()

    def show_devices(self, devices: tuple[DeviceState, ...]) -> None:
        """Show all devices; a state that is new counts from now."""
        before = {device.name: device.state for device in self._devices}
        for device in devices:
            if before.get(device.name) != device.state:
                self._since[device.name] = datetime.now()
        self._devices = devices
        self._write()

    def show_who(self, person: str, blade_type: str, serial: str) -> None:
        """Show who works on which blade; all empty while no session is open."""
        self._who = (person, blade_type, serial)
        self._write()

    def text(self) -> str:
        """What the strip says."""
        return "   ".join(label.text() for label in (*self._labels.values(), self._sentence))

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802  (Qt's name)
        """Follow the language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._write()

    def _write(self) -> None:
        self._layout.setContentsMargins(px(8), px(4), px(8), px(4))
        self._layout.setSpacing(px(14))
        self.setAccessibleName(self.tr("Devices"))
        for device in self._devices:
            label = self._label(device.name)
            label.setStyleSheet(f"color: {colour(device.state)}; font-size: {px(12)}px;")
            label.setToolTip(self._tip(device))
            label.setAccessibleName(f"{self._words(device, with_time=True)}. {label.toolTip()}")
        for name in self._labels.keys() - {device.name for device in self._devices}:
            label = self._labels.pop(name)
            self._layout.removeWidget(label)
            label.deleteLater()
        self._fit()
        person, blade_type, serial = self._who
        text = ""
        if blade_type and serial:
            text = self.tr("{person} works on blade type {blade_type}, serial {serial}")
        elif blade_type:
            text = self.tr("{person} works on blade type {blade_type}")
        self._sentence.setStyleSheet(f"font-size: {px(12)}px;")
        self._sentence.setText(text.format(person=person, blade_type=blade_type, serial=serial))

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802  (Qt's name)
        """Leave out the times where there is no room for them; the tool tips have them."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        needed = sum(
            self._label(device.name).fontMetrics().horizontalAdvance(self._words(device, with_time=True)) + px(16)
            for device in self._devices
        )
        for device in self._devices:
            self._label(device.name).setText(self._words(device, with_time=needed < self.width()))

    def _label(self, name: str) -> QLabel:
        if name not in self._labels:
            label = QLabel(self)
            label.setObjectName("device_" + name.replace(" ", "_"))
            self._layout.insertWidget(len(self._labels), label)
            self._labels[name] = label
        return self._labels[name]

    def _words(self, device: DeviceState, *, with_time: bool) -> str:
        words = f"{SHAPES.get(device.state, '●')} {device_name(device.name)}: {device_state_word(device.state)}"
        return f"{words} {self._since[device.name]:%H:%M}" if with_time else words

    def _tip(self, device: DeviceState) -> str:
        since = self.tr("{state} since {time}").format(
            state=device_state_word(device.state), time=f"{self._since[device.name]:%H:%M:%S}"
        )
        return "\n".join(filter(None, (since, sentence(device.detail))))
