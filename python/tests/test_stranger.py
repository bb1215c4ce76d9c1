"""What a stranger's data set can do to `load_dataset`: nothing but be read, or raise an Error that names file and line.
tests/end_to_end/stranger_test.cpp tries the same with the program."""

import gzip
import json
import multiprocessing
import os
import re
import resource
import shutil
from collections.abc import Callable
from multiprocessing.connection import Connection
from pathlib import Path

import pytest

import unietp

#: Each reads a part of a data set.
READERS: dict[str, Callable[[Path], object]] = {
    "tasks.jsonl": lambda folder: unietp.load_dataset(folder)[0],
    "demonstrations/M2.jsonl": lambda folder: unietp.load_dataset(folder).demonstration(0, "M2"),
    "homes/HOME.scene.json.gz": lambda folder: unietp.load_dataset(folder).start(0),
    "manifest.json": lambda folder: unietp.load_dataset(folder).manifest,
}


@pytest.fixture
def stranger(folder, tmp_path) -> Path:
    """A copy of the data set that may be spoiled, in a folder beside a file that it has no business with."""
    shutil.copytree(folder, tmp_path / "theirs" / "set")
    home = unietp.load_dataset(folder).home(0)
    (tmp_path / "outside").mkdir()
    with gzip.open(tmp_path / "outside" / "secret.scene.json.gz", "wt") as file:
        json.dump({**home, "id": "secret"}, file)
    return tmp_path / "theirs" / "set"


def place_of(stranger: Path, name: str) -> Path:
    return stranger / name.replace("HOME", json.loads((stranger / "tasks.jsonl").read_text().split("\n", 1)[0])["layout"])


def change_first(file: Path, **fields) -> None:
    """Other values in the first line."""
    first, others = file.read_text().split("\n", 1)
    file.write_text(json.dumps({**json.loads(first), **fields}) + "\n" + others)


def read_and_tell(read: Callable[[Path], object], folder: Path, answers: Connection) -> None:
    try:
        read(folder)
        text = "was read"
    except unietp.Error as error:
        text = str(error)
    answers.send((text, resource.getrusage(resource.RUSAGE_SELF)))


def said(folder: Path, read: Callable[[Path], object]) -> str:
    """What the error of reading says, or "was read". In a process of its own, which may take 5 s of the processor and a
    GiB, and must not wait for anything."""
    answers, of_child = multiprocessing.Pipe(duplex=False)
    child = multiprocessing.get_context("fork").Process(target=read_and_tell, args=(read, folder, of_child))
    child.start()
    of_child.close()  # so that its end is seen
    answered = answers.poll(120)
    if not answered:
        child.kill()
    child.join()
    assert answered, "still reads after two minutes"
    text, used = answers.recv()
    assert used.ru_utime < 5 and used.ru_maxrss < 2**20, used  # KiB, so a GiB
    return text


@pytest.mark.parametrize("name", ["../../outside/secret", "/etc/passwd", "..", ".hidden", "a/b", "a\x1b[2J", "", "x" * 201])
@pytest.mark.parametrize("field", ["id", "layout", "scene"])
def test_names_are_no_paths(stranger, field, name):
    change_first(stranger / "tasks.jsonl", **{field: name})
    opened = unietp.load_dataset(stranger)
    for read in (lambda: opened[0], lambda: opened.home(0), lambda: opened.start(0), lambda: opened.demonstration(0),
                 lambda: opened.position("x"), lambda: list(opened)):
        with pytest.raises(unietp.Error, match=r"tasks\.jsonl:1.*(letters, digits|not empty)") as raised:
            read()
        assert "\x1b" not in str(raised.value)


def test_a_home_is_read_from_the_folder_only(stranger):
    task = unietp.load_dataset(stranger)[0]
    outside = unietp.TaskLine(**{**vars(task), "layout": "../../outside/secret"})
    with pytest.raises(unietp.Error, match="names no file of a folder"):
        unietp.load_dataset(stranger).home(outside)


@pytest.mark.parametrize("name", [*READERS, "homes", "demonstrations"])
def test_links_are_not_followed(stranger, name):
    place = place_of(stranger, name)
    aside = stranger.parent / "aside"
    place.rename(aside)
    read = READERS.get(name) or next(read for file, read in READERS.items() if file.startswith(name))
    for target in (aside,) if aside.is_dir() else (aside, place, "/dev/zero"):
        place.symlink_to(target)
        assert "is a symbolic link, which is not followed" in said(stranger, read)
        place.unlink()
    aside.rename(place)
    assert said(stranger, read) == "was read"


@pytest.mark.parametrize("name", READERS)
def test_what_is_no_regular_file_is_refused_at_once(stranger, name):
    place = place_of(stranger, name)
    place.rename(stranger.parent / "aside")
    os.mkfifo(place)
    assert said(stranger, READERS[name]).endswith(f"{place}: file error: is a FIFO; expected a file")
    place.unlink()
    place.mkdir()
    assert said(stranger, READERS[name]).endswith(f"{place}: file error: is a folder; expected a file")


@pytest.mark.parametrize("name", ["tasks.jsonl", "demonstrations/M2.jsonl"])
def test_lines_are_bounded(stranger, name):
    place = stranger / name
    lines = place.read_bytes().splitlines(keepends=True)
    for second, why in (
        (b'{"id": "' + b"x" * (8 << 20) + b'"}\n', "is longer than 8388608 bytes"),
        (b"\n", "is empty"),
        (lines[1][:-1] + b"\r\n", "ends in CR LF"),
        (lines[1][:-1], "does not end in a line feed"),
    ):
        place.write_bytes(lines[0] + second)
        text = said(stranger, READERS[name])
        assert f"{place}:2" in text and why in text
    with place.open("r+b") as file:
        file.truncate(1 << 40)  # sparse
    assert "is longer than 8388608 bytes" in said(stranger, READERS[name])


@pytest.mark.parametrize("name", ["tasks.jsonl", "demonstrations/M2.jsonl"])
def test_a_line_is_what_the_program_would_read(stranger, name):
    place = stranger / name
    sound = place.read_text()
    first, others = sound.split("\n", 1)
    for line, why in (
        ("[" * 100_000, "nested deeper than 64 levels"),
        ("[]", "expected an object"),
        ('{"id": NaN}', "parse error"),
        (first[:-1] + ',"more":1}', '"more"'),
        (first[:-1] + ',"format":""}', "occurs twice"),
        (first.replace('"', "\ud800", 1), "parse error"),
    ):
        place.write_bytes((line + "\n" + others).encode("utf-8", "surrogatepass"))
        text = said(stranger, READERS[name])
        assert re.search(f"{place}(#[^:]*)?:1[:#]", text) and why in text


def test_homes_are_bounded(stranger):
    place = place_of(stranger, "homes/HOME.scene.json.gz")
    read = READERS["homes/HOME.scene.json.gz"]
    home = json.loads(gzip.decompress(place.read_bytes()))
    member = gzip.compress(b" " * (64 << 20))
    place.write_bytes(member * 32)  # 2 GiB
    assert said(stranger, read) == f"{place}: parse error: unpacks to more than 268435456 bytes"
    place.write_bytes(gzip.compress(b'{"nodes":[' + b"0," * 5_000_000 + b"0]}"))
    assert "has more than 4000000 JSON values" in said(stranger, read)
    place.write_bytes(gzip.compress(json.dumps({**home, "rooms": home["rooms"] * 1000}).encode()))
    assert "expected at most 200" in said(stranger, read)
    place.write_bytes(gzip.compress(json.dumps({**home, "id": "other"}).encode()))
    assert 'is called "other"' in said(stranger, read)
    place.write_bytes(gzip.compress(json.dumps(home).encode())[:-9])
    assert "not a whole gzip file" in said(stranger, read)
    with place.open("wb") as file:
        file.truncate(1 << 40)
    assert "has more than 268435456 bytes" in said(stranger, read)


def test_a_manifest_is_bounded(stranger):
    place = stranger / "manifest.json"
    place.write_text("[]")
    assert said(stranger, READERS["manifest.json"]) == f"{place}: expected an object"
    place.write_text("[" * 100_000)
    assert "nested deeper than 64 levels" in said(stranger, READERS["manifest.json"])
    with place.open("wb") as file:
        file.truncate(1 << 40)
    assert f"{place}: file error: has more than 268435456 bytes" in said(stranger, READERS["manifest.json"])


def test_demonstrations_of_other_tasks_and_equal_ids_are_refused(stranger):
    opened = unietp.load_dataset(stranger)
    other = opened[1].id
    change_first(stranger / "demonstrations" / "M1.jsonl", task=other)
    with pytest.raises(unietp.Error, match=r"M1\.jsonl:1: is of '.*' in M1, not of"):
        unietp.load_dataset(stranger).demonstration(0)
    change_first(stranger / "tasks.jsonl", id=other)
    with pytest.raises(unietp.Error, match=r"tasks\.jsonl:2: another task has the id"):
        unietp.load_dataset(stranger).position(other)
