"""What the tests share: a small data set that the program makes once."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import unietp

sys.path.insert(0, str(Path(__file__).parents[1] / "adapters"))  # whose programs import each other

MODES = ("M1", "M2", "M3")


@pytest.fixture(scope="session")
def folder(tmp_path_factory) -> Path:
    """A data set of 24 tasks of all simulators and splits, demonstrated in all modes; or the one that the variable
    UNIETP_DATASET names."""
    if "UNIETP_DATASET" in os.environ:
        return Path(os.environ["UNIETP_DATASET"])
    out = tmp_path_factory.mktemp("data") / "set"
    assert unietp.generate(out, count=24, seed=7, modes=list(MODES))["tasks"] == 24
    return out


@pytest.fixture(scope="session")
def dataset(folder) -> unietp.Dataset:
    return unietp.load_dataset(folder)


@pytest.fixture
def run_python():
    """Runs code in a process of its own, with other variables of the environment; gives what it prints."""

    def run(code: str, *arguments: str, **variables: str) -> str:
        done = subprocess.run(
            [sys.executable, "-c", code, *arguments], env={**os.environ, **variables}, capture_output=True, text=True
        )
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run
