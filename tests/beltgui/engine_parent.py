"""A parent without a guard around its main part, as a program may be: starts an engine, says its number, and waits."""

import sys
import threading

from beltgui.engine.messages import Ready
from beltgui.engine.process import start_engine

ready = threading.Event()
engine = start_engine(lambda event: isinstance(event, Ready) and ready.set(), print)
assert ready.wait(60.0)
sys.stdout.write(f"{engine.pid}\n")
sys.stdout.flush()
sys.stdin.read()
engine.close()
