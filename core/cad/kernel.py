"""The CAD kernel (OpenCASCADE) at arm's length: every other module asks it through here or imports it in a function."""

from __future__ import annotations


def quiet_kernel() -> None:
    """Take away the kernel's own message printers: stdout belongs to the caller's JSON."""
    from OCP.Message import Message

    messenger = Message.DefaultMessenger_s()
    for printer in list(messenger.Printers()):
        messenger.RemovePrinter(printer)
