"""What a type checker sees of the package, and of a program that uses it. Needs mypy (python/requirements.txt)."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import unietp

pytest.importorskip("mypy")

AGENT = """
from typing import Any, assert_type

import numpy as np
import unietp

env = unietp.make("out/first-benchmark", mode="M2", picture=False)
assert_type(env, unietp.TaskEnv)
observation, info = env.reset(seed=1)
assert_type(observation, dict[str, np.ndarray])
assert_type(info, dict[str, Any])
assert_type(env.prompt() + env.text(), str)
assert_type(env.expert_steps_left(), int | None)
assert_type(env.privileged()["success"], Any)
batch = unietp.make_vec(8, "out/first-benchmark", "M1", threads=2)
assert_type(batch, unietp.VectorTaskEnv)
dataset = unietp.load_dataset("out/first-benchmark")
assert_type(dataset[0], unietp.TaskLine)
assert_type(dataset[0:2], list[unietp.TaskLine])
assert_type(dataset.demonstration("ai2thor-00001").steps, list[unietp.DemonstrationStep])
"""

WRONG = {
    "unietp.make(3)": "arg-type",
    'unietp.make("folder", maximal_things=3).stepp("stop")': "attr-defined",
    'unietp.make("folder").reset(7)': "call-arg",
    'unietp.load_dataset("folder")[None]': "call-overload",
    'unietp.make_vec("8", "folder")': "arg-type",
    'unietp.make("folder").expert_steps_left() + 1': "operator",
    'unietp._native.complete_settings(3)': "arg-type",
}


def check(folder: Path, *arguments: str) -> tuple[int, str]:
    """The exit code of mypy, and what it says."""
    package = Path(unietp.__file__).parent.parent
    configuration = Path(__file__).parents[2] / "pyproject.toml"
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--config-file", configuration, "--cache-dir", folder / "cache", *arguments],
        env={**os.environ, "MYPYPATH": str(package)}, cwd=folder, capture_output=True, text=True,
    )
    return done.returncode, done.stdout + done.stderr


def test_the_package_agrees_with_its_types(tmp_path):
    code, said = check(tmp_path, "-p", "unietp")
    assert code == 0, said


def test_the_adapters_agree_with_their_types(tmp_path):
    adapters = sorted((Path(__file__).parents[1] / "adapters").glob("*.py"))
    assert adapters
    code, said = check(tmp_path, *map(str, adapters))
    assert code == 0, said


def test_a_program_sees_the_types(tmp_path):
    (tmp_path / "agent.py").write_text(AGENT)
    code, said = check(tmp_path, "agent.py")
    assert code == 0, said


def test_wrong_programs_are_noticed(tmp_path):
    (tmp_path / "agent.py").write_text("import unietp, unietp._native\n" + "\n".join(WRONG) + "\n")
    code, said = check(tmp_path, "agent.py")
    assert code == 1
    for line, kind in enumerate(WRONG.values(), start=2):
        assert any(one.startswith(f"agent.py:{line}: error:") and one.endswith(f"[{kind}]") for one in said.splitlines()), said
