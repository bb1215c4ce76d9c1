"""Where the package's program and data are, and what is read of them once for a process."""

import functools
import os
import tempfile
from pathlib import Path

from unietp import _native

#: The program: part of the wheel, or of the build that the package stands in.
PROGRAM = Path(__file__).parent / "bin" / "unietp"


def data_folder() -> Path:
    """The folder with data/ and templates/: UNIETP_DATA, that of the wheel, or the source checkout."""
    return _native.find_data_folder(PROGRAM, os.environ.get("UNIETP_DATA", ""))


def cache_folder() -> Path:
    """Where compiled knowledge is kept, as the program has it."""
    if cache := os.environ.get("XDG_CACHE_HOME"):
        return Path(cache) / "unietp"
    if home := os.environ.get("HOME"):
        return Path(home) / ".cache" / "unietp"
    return Path(tempfile.gettempdir()) / "unietp-cache"


@functools.cache
def catalog(extended: bool = False) -> _native.Catalog:
    """Knowledge and profiles of the simulators, shared by all environments of the process."""
    return _native.Catalog.load(data_folder(), cache_folder(), extended)
