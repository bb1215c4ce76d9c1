"""Runs the program `unietp`, which is part of the package."""

import json
import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from unietp.places import PROGRAM


class ProgramError(RuntimeError):
    """The program refused its input (exit code 2) or was interrupted; the message is what it wrote to stderr."""


def main() -> None:
    """The command `unietp` of the installed package."""
    os.execv(PROGRAM, ["unietp", *sys.argv[1:]])


def run_program(*arguments: str | os.PathLike[str], accepted: Sequence[int] = (0,)) -> str:
    """Runs `unietp ARGUMENTS` and returns what it printed.

    Raises:
        ProgramError: the exit code is none of `accepted`.
    """
    run = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False)
    if run.returncode not in accepted:
        raise ProgramError(run.stderr.strip() or f"unietp ended with exit code {run.returncode}")
    return run.stdout


def _options(given: dict[str, Any]) -> list[str]:
    """`splits=["atomic", "logical"], resume=True` as `--splits atomic,logical --resume`."""
    words: list[str] = []
    for name, value in given.items():
        option = "--" + name.replace("_", "-")
        if value is True:
            words.append(option)
        elif isinstance(value, (list, tuple)):
            words += [option, ",".join(map(str, value))]
        elif value is not None and value is not False:
            words += [option, str(value)]
    return words


def generate(out: str | os.PathLike[str], **options: Any) -> dict[str, Any]:
    """Makes a data set, as `unietp generate` does, with the same options and the same bytes.

    Args:
        out: the folder to make.
        options: those of the program, with `_` for `-`: `count=40, seed=1, splits=["atomic"], modes=["M1", "M2"]`.

    Returns:
        `{"tasks", "asked", "candidates", "seconds", "unfilled"}`; fewer tasks than asked for when some could not be made.

    Raises:
        ProgramError: an option or a file is wrong, or the folder exists already.
    """
    return json.loads(run_program("generate", *_options(options), "--out", Path(out), "--json", accepted=(0, 1)))


def validate(folder: str | os.PathLike[str], **options: Any) -> dict[str, Any]:
    """Verifies a data set, as `unietp validate` does.

    Returns:
        `{"tasks", "proven", "demonstrations", "problems", ...}` (docs/files.md); `problems` is empty for a sound data set.

    Raises:
        ProgramError: the folder cannot be read as a data set at all.
    """
    return json.loads(run_program("validate", Path(folder), *_options(options), "--json", accepted=(0, 1)))
