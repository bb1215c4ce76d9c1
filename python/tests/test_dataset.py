"""unietp.load_dataset, generate and validate."""

import gzip
import json
import shutil
import subprocess

import pytest
from conftest import MODES

import unietp
from unietp.places import PROGRAM


def test_tasks_are_the_lines_of_the_file(folder, dataset):
    lines = [json.loads(line) for line in (folder / "tasks.jsonl").read_text().splitlines()]
    assert [task.fields for task in dataset] == lines
    assert [dataset[i].id for i in range(len(dataset))] == [line["id"] for line in lines]
    assert dataset[-1].id == lines[-1]["id"] and len(dataset[3:9]) == 6
    assert dataset[lines[4]["id"]] == dataset[4] and dataset.position(lines[4]["id"]) == 4
    assert dataset.modes == list(MODES) and dataset.manifest["counts"]["tasks"] == len(dataset)
    for wrong in ("nobody", 24):
        with pytest.raises((unietp.Error, IndexError)):
            dataset[wrong]


@pytest.mark.parametrize("mode", MODES)
def test_demonstrations_belong_to_their_tasks(dataset, mode):
    for task, shown in zip(dataset, dataset.demonstrations(mode), strict=True):
        assert shown.task == task.id and shown.mode == mode and shown.steps[-1].action == "stop"
        assert dataset.demonstration(task, mode) == shown


def test_starts_are_those_that_the_program_exports(folder, dataset, tmp_path):
    unietp.run_program("export", folder, "--format", "starts", "--out", tmp_path / "starts")
    starts = {}
    for file in (tmp_path / "starts").rglob("*.scene.json.gz"):
        scene = json.loads(gzip.decompress(file.read_bytes()))
        starts[scene["id"]] = scene
    assert len(starts) == len(dataset)
    for task in dataset:
        ours, theirs = dataset.start(task), starts[task.fields["scene"]]
        assert {node["id"]: node for node in ours["nodes"]} == {node["id"]: node for node in theirs["nodes"]}
        assert sorted(map(str, ours["edges"])) == sorted(map(str, theirs["edges"]))


def test_hugging_face_datasets(dataset):
    pytest.importorskip("datasets")
    rows = dataset.to_dataset("M2")
    assert rows.num_rows == len(dataset) and rows[0]["id"] == dataset[0].id
    assert [step["action"] for step in rows[5]["plan"]] == [step.action for step in dataset.demonstration(5, "M2").steps]
    assert json.loads(rows[5]["plan"][0]["args"][0]) == dataset.demonstration(5, "M2").steps[0].args[0]


def test_generate_makes_the_bytes_of_the_program(tmp_path):
    made = unietp.generate(tmp_path / "python", count=4, seed=3, splits=["atomic", "logical"])
    subprocess.run(
        [PROGRAM, "generate", "--count", "4", "--seed", "3", "--splits", "atomic,logical", "--out", tmp_path / "shell"],
        check=True,
        capture_output=True,
    )
    assert made["tasks"] == 4
    for name in ("tasks.jsonl", "demonstrations/M1.jsonl"):
        assert (tmp_path / "python" / name).read_bytes() == (tmp_path / "shell" / name).read_bytes()
    with pytest.raises(unietp.ProgramError):
        unietp.generate(tmp_path / "python", count=4, seed=3)
    with pytest.raises(unietp.ProgramError, match="--splits"):
        unietp.generate(tmp_path / "other", splits=["nonsense"])


def test_validate_finds_a_changed_byte(folder, tmp_path):
    assert unietp.validate(folder)["problems"] == []
    damaged = tmp_path / "set"
    shutil.copytree(folder, damaged)
    lines = (damaged / "demonstrations" / "M1.jsonl").read_text()
    (damaged / "demonstrations" / "M1.jsonl").write_text(lines.replace('"success":true', '"success":false', 1))
    assert unietp.validate(damaged)["problems"]
    with pytest.raises(unietp.ProgramError):
        unietp.validate(tmp_path / "nowhere")


def test_what_is_not_there_is_named(folder, dataset):
    with pytest.raises(IndexError, match=f"{len(dataset)} lines; there is none at 9999"):
        dataset[9999]
    assert dataset[-1] == dataset[len(dataset) - 1]
    with pytest.raises(unietp.Error, match="M1, M2, M3, not of 'M5'"):
        dataset.demonstration(0, "M5")


def test_wrong_files_are_errors(tmp_path):
    with pytest.raises(unietp.Error):
        unietp.load_dataset(tmp_path)
    (tmp_path / "tasks.jsonl").write_text('{"id": 1}\n[]\n')
    broken = unietp.load_dataset(tmp_path)
    for i in range(2):
        with pytest.raises(unietp.Error):
            broken[i]
    with pytest.raises(unietp.Error):
        unietp.make(tmp_path)
