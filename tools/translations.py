"""Collects what can be seen on the screen, for translation: `.venv/bin/python tools/translations.py [--check]`.

Sentences that come from below the screen are found in the source as templates and written to
`beltgui/app/sentence_templates.py`; then Qt's lupdate brings the .ts file up to date and lrelease makes the .qm file
that the program loads. With `--check` nothing is written; the exit code is 1 if
something is out of date or untranslated.
"""

from __future__ import annotations

import argparse
import ast
import re
import subprocess
import sys
import tomllib
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TEMPLATES = ROOT / "beltgui" / "app" / "sentence_templates.py"
TS = ROOT / "resources" / "translations" / "beltcal_zh_CN.ts"
SCREEN = ("beltgui/app", "beltgui/widgets", "beltgui/wizard")
# Where sentences for the screen come from; what is only for files, the command line or other programs is left out.
SPEAKING = ("core", "devices", "beltgui/steps", "beltgui/engine", "beltgui/session", "beltgui/files.py",
            "beltgui/commissioning.py", "beltgui/viewmodel")
SILENT = ("beltgui/steps/blocks.py", "beltgui/session/schema.py", "core/path/urscript.py")
CONTEXT = "sentence"
FEWEST_LETTERS = 2
# What is handed to these is a key, a format or an option, never speech.
DEAF = {
    "TypeVar", "_at", "_flag", "add_sample", "argsort", "compile", "convolve", "decode", "dtype", "encode",
    "errstate", "float", "get", "get_context", "getattr", "hasattr", "index", "kept", "kron", "listens_for", "minimize",
    "resource_path", "samples", "searchsorted", "setting", "split", "startswith", "strftime", "strptime",
}  # fmt: skip
# The first thing handed to these is the key by which plots, columns and parts of a scene are told apart.
KEYED = {
    "Arrow", "Column", "Frame", "Label", "Lines", "Mesh", "Plot", "Points", "arrows", "cylinder", "disc", "exaggerated",
    "flange", "funnel", "label", "robot_base", "scanner_volume", "segments", "sphere", "spheres", "triads",
}  # fmt: skip
OPTIONS = {"errors", "fit_to", "format", "indexing", "join_style", "method", "mode", "side", "view"}
# Put together in two places, so that no single template shows which word belongs to which.
TOGETHER = ("grinder {0} angle", "grinder {0} force", "{0} and others", "{H {0}}", "{H {0}, by the drawing}")
# Said by the operating system and by the database, and handed on.
SYSTEM = (
    "Directory not empty", "File exists", "File name too long", "Input/output error", "Is a directory",
    "No space left on device", "No such file or directory", "Not a directory", "Operation not permitted",
    "Permission denied", "Read-only file system", "Too many open files", "[Errno {0}] {1}: {2}",
    "attempt to write a readonly database", "database disk image is malformed", "database is locked",
    "disk I/O error", "file is not a database", "no such table: {0}", "unable to open database file",
)  # fmt: skip


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true")
    check = parser.parse_args().check
    text = as_module(templates())
    if check:
        return report(text)
    TEMPLATES.write_text(text, encoding="utf-8")
    files = [str(path) for folder in SCREEN for path in sorted((ROOT / folder).rglob("*.py"))]
    run("pyside6-lupdate", "-no-obsolete", "-locations", "none", *files, "-ts", str(TS))
    made = TS.with_suffix(".qm.part")
    run("pyside6-lrelease", str(TS), "-qm", str(made))
    made.replace(TS.with_suffix(".qm"))  # a program that runs has the old file mapped into its memory
    print(f"{len(unfinished())} of {len(list(ElementTree.parse(TS).iter('message')))} texts are untranslated")
    print("".join(f"  {source}\n" for source in unfinished()), end="")
    return 0


def report(text: str) -> int:
    """What is out of date or missing, in words."""
    problems = [f"untranslated: {source}" for source in unfinished()]
    problems += [f"lupdate found no class that says: {source}" for source in homeless()]
    if not TEMPLATES.is_file() or TEMPLATES.read_text(encoding="utf-8") != text:
        problems.append(f"{TEMPLATES.name} is out of date: run tools/translations.py")
    print("\n".join(problems) or "every text is translated")
    return 1 if problems else 0


def run(tool: str, *arguments: str) -> None:
    subprocess.run([str(Path(sys.executable).with_name(tool)), *arguments], check=True, stdout=subprocess.DEVNULL)


def unfinished() -> list[str]:
    """Sources without a finished translation."""
    found = []
    for message in ElementTree.parse(TS).iter("message"):
        translation = message.find("translation")
        if translation is None or translation.get("type") is not None or not (translation.text or "").strip():
            found.append(message.findtext("source") or "")
    return found


def homeless() -> list[str]:
    """Sources whose context is the name of a variable, so that nobody would find the translation."""
    homes = f"[A-Z].*|{CONTEXT}"
    lost = [one for one in ElementTree.parse(TS).iter("context") if not re.fullmatch(homes, one.findtext("name") or "")]
    return [message.findtext("source") or "" for one in lost for message in one.iter("message")]


def as_module(found: list[str]) -> str:
    """The templates as Python that lupdate reads."""
    lines = [f'    QT_TRANSLATE_NOOP("sentence", {quoted(text)}),' for text in found]
    return "\n".join([
        '"""Sentences from below the screen, collected by tools/translations.py; not edited by hand."""', "",
        "from PySide6.QtCore import QT_TRANSLATE_NOOP", "", "# fmt: off", "TEMPLATES = (", *lines, ")", "",
    ])  # fmt: skip


def quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    return f'"{escaped}"'


def templates() -> list[str]:
    """All templates, sorted."""
    found = {*SYSTEM, *TOGETHER}
    for file in sorted((ROOT / "resources" / "blades").glob("*.toml")):
        found.add(tomllib.loads(file.read_text(encoding="utf-8"))["blade"]["description"])
    for file in sorted((ROOT / "resources" / "cells").glob("*.toml")):
        found.update(re.findall(r'\bname = "([^"]+)"', file.read_text(encoding="utf-8")))
    for place in SPEAKING:
        path = ROOT / place
        for file in sorted(path.rglob("*.py")) if path.is_dir() else [path]:
            if str(file.relative_to(ROOT)) not in SILENT:
                found.update(in_module(ast.parse(file.read_text(encoding="utf-8"))))
    return sorted(found)


def in_module(tree: ast.Module) -> Iterator[str]:
    skipped = docstrings(tree) | not_for_people(tree)
    inside = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr)
              for part in ast.walk(node) if isinstance(part, ast.Constant) and part in node.values}  # fmt: skip
    for node in ast.walk(tree):
        if id(node) in skipped or id(node) in inside:
            continue
        if isinstance(node, ast.JoinedStr):
            text = template_of(node)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            text = node.value
        else:
            continue
        text = text.strip()
        if is_speech(text):
            yield text


def template_of(node: ast.JoinedStr) -> str:
    pieces, places = [], 0
    for value in node.values:
        if isinstance(value, ast.Constant):
            pieces.append(str(value.value))
        else:
            pieces.append(f"{{{places}}}")
            places += 1
    return "".join(pieces)


def docstrings(tree: ast.Module) -> set[int]:
    """Strings that stand alone as a statement."""
    return {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}


def not_for_people(tree: ast.Module) -> set[int]:
    """Type annotations, subscripts, dictionary keys, comparisons and names of attributes are no speech."""
    found: set[int] = set()
    for node in ast.walk(tree):
        parts: list[ast.AST | None] = []
        if isinstance(node, ast.Subscript):
            parts = [node.slice]
        elif isinstance(node, ast.Dict):
            parts = list(node.keys)
        elif isinstance(node, ast.Compare):
            parts = [node.left, *node.comparators]
        elif isinstance(node, ast.Assign) and any(isinstance(t, ast.Name) and t.id == "__all__" for t in node.targets):
            parts = [node.value]
        elif isinstance(node, ast.arg | ast.AnnAssign):
            parts = [node.annotation]
        elif isinstance(node, ast.FunctionDef):
            parts = [node.returns]
        elif isinstance(node, ast.Call):
            parts = keys_of(node)
        for part in parts:
            if part is not None:
                found.update(id(inner) for inner in ast.walk(part))
    return found


def keys_of(call: ast.Call) -> list[ast.AST | None]:
    """What is handed to a call and is no speech."""
    name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
    options: list[ast.AST | None] = [word.value for word in call.keywords if word.arg in OPTIONS]
    if name in DEAF:
        return [*call.args, *(word.value for word in call.keywords)]
    return [*call.args[:1], *options] if name in KEYED else options


def is_speech(text: str) -> bool:
    """True for what a person may read: words, not identifiers, keys or formats."""
    bare = re.sub(r"\{\d+\}", "", text)
    if sum(letter.isalpha() for letter in bare) < FEWEST_LETTERS:
        return False
    if re.fullmatch(r"[a-z0-9_.\-/:{}*%µ]+", text) and not re.fullmatch(r"[a-z]{3,}", text):
        return False  # identifiers, file names, formats, units
    if re.fullmatch(r"[A-Z0-9_]+|([A-Z][a-z0-9]+){2,}", text) or re.search(r"->|[\\|]|%[A-Z]|^[<.^]", text):
        return False  # codes, names of classes, sums of products, patterns, formats
    return not re.search(r"\b(SELECT|INSERT|UPDATE|CREATE|PRAGMA|DELETE|BEGIN) ", text)


if __name__ == "__main__":
    sys.exit(main())
