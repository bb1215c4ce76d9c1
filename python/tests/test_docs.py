"""The programs of docs/python.md, as they stand there."""

import os
import re
from pathlib import Path

import pytest

PAGE = Path(__file__).parents[2] / "docs" / "python.md"
BLOCK = re.compile(r"<!-- test: (.*?) -->\n```python\n(.*?)```", re.DOTALL)
PROGRAMS = dict(BLOCK.findall(PAGE.read_text()))


@pytest.fixture
def beside_the_data(folder, tmp_path, monkeypatch):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "first-benchmark").symlink_to(folder)
    monkeypatch.chdir(tmp_path)


def test_ten_lines_run_an_agent(beside_the_data, dataset, capsys):
    def my_agent(chat, picture):
        """Answers with the demonstration of the task that it finds in the chat."""
        assert picture.ndim == 3 and chat[0]["role"] == "system"
        task = next(task for task in dataset if task.instruction in chat[1]["content"])
        step = dataset.demonstration(task, "M2").steps[len(chat) // 2 - 1]
        return f"{step.action}({', '.join(step.args)})"

    program = PROGRAMS["ten lines"]
    assert len([line for line in program.splitlines() if line]) <= 12
    exec(program, {"my_agent": my_agent})
    assert capsys.readouterr().out.endswith(" success\n")


def test_the_program_on_data_runs(beside_the_data):
    exec(PROGRAMS["data"], {})
    assert os.path.islink("out/first-benchmark")


def test_every_program_of_the_page_is_tested():
    assert len(PROGRAMS) == PAGE.read_text().count("```python") == 2
