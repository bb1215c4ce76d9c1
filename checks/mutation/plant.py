"""Draws mutants by seed and writes the tree that holds them all, each behind a switch of its own."""

import json
import multiprocessing
import os
import random
import re
import shutil
import subprocess
from dataclasses import dataclass, fields
from pathlib import Path

import sites

LEAST_PER_ROOM = 4
MOST_PER_FILE = 3
HEADER = "bool unietp_mutant(int);\n#line 1\n"
SWITCH = Path(__file__).parent / "switch.cpp"


@dataclass(frozen=True)
class Mutant:
    id: int
    room: str
    file: str
    line: int
    last_line: int
    kind: str
    original: str
    mutated: str
    start: int
    end: int
    text: str


def snapshot(root, folder):
    """Copies the files that git lists, as they are now; later stages go by this copy."""
    shutil.rmtree(folder, ignore_errors=True)
    listed = subprocess.run(["git", "-C", root, "ls-files", "-z"], check=True, capture_output=True, text=True)
    for name in listed.stdout.split("\0"):
        if name and (root / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(root / name, folder / name)


def sources(original):
    """Room -> its .cpp files, in the order of the rooms."""
    cmake = (original / "CMakeLists.txt").read_text()
    rooms = re.search(r"set\(UNIETP_ALL_ROOMS[^\n]*(.*?)\)", cmake, re.S)[1].split()
    return {room: sorted(str(path.relative_to(original)) for path in (original / room).rglob("*.cpp")) for room in rooms}


def shares(original, files, count):
    """Room -> number of mutants: a floor for each, the rest in proportion to lines."""
    lines = {room: sum(length(original / file) for file in names) for room, names in files.items()}
    rest, total = count - LEAST_PER_ROOM * len(files), sum(lines.values())
    exact = {room: rest * lines[room] / total for room in files}
    share = {room: LEAST_PER_ROOM + int(exact[room]) for room in files}
    for room in sorted(files, key=lambda name: int(exact[name]) - exact[name])[:count - sum(share.values())]:
        share[room] += 1
    return share


def length(path):
    return path.read_text().count("\n")


def arguments_of(commands, original):
    """File -> what the compiler is told about it, for libclang."""
    found = {}
    for entry in json.loads((commands / "compile_commands.json").read_text()):
        words = entry["command"].split()
        kept = []
        for word, after in zip(words, words[1:] + [""]):
            if word.startswith(("-I", "-D", "-std=")):
                kept.append(word.replace('\\"', '"').replace("\\ ", " "))
            elif word == "-isystem":
                kept += [word, after]
        found[os.path.relpath(entry["file"], original)] = kept
    return found


def sites_of(task):
    """A file that libclang cannot read (clang 14 knows less of C++20's ranges than g++) has none, and is named."""
    try:
        return sites.sites_of(*task)
    except RuntimeError as error:
        print(f"left out: {error}", flush=True)
        return []


def draw(original, commands, seed, count, workers):
    """The mutants of `seed`. Files are drawn in proportion to their length; within a room the kinds take turns."""
    files = sources(original)
    arguments = arguments_of(commands, original)
    drawn = []
    with multiprocessing.Pool(workers) as pool:
        for room, share in shares(original, files, count).items():
            rng = random.Random(f"{seed} {room}")
            order = sorted(files[room], key=lambda file: rng.random() ** (1 / length(original / file)), reverse=True)
            order = [file for file in order if file in arguments]
            chosen = []
            batch = max(2, (share + 1) // 2)
            while len(chosen) < share and order:
                names, order = order[:batch], order[batch:]
                found = pool.map(sites_of, [(str(original / name), arguments[name]) for name in names], chunksize=1)
                chosen += choose(dict(zip(names, found)), share - len(chosen), rng)
            drawn += [(room, file, site) for file, site in sorted(chosen, key=lambda item: (item[0], item[1].start))]
            print(f"{room}: {len(chosen)} mutants", flush=True)
    return [Mutant(number, room, file, site.line, site.last_line, site.kind, site.original, site.mutated, site.start,
                   site.end, site.text) for number, (room, file, site) in enumerate(drawn, 1)]


def choose(found, share, rng):
    """Up to `share` sites that do not overlap."""
    by_kind = {kind: [(file, site) for file, all_sites in found.items() for site in all_sites if site.kind == kind]
               for kind in sites.KINDS}
    kinds = [kind for kind in sites.KINDS if by_kind[kind]]
    rng.shuffle(kinds)
    for candidates in by_kind.values():
        rng.shuffle(candidates)
    chosen = []
    while len(chosen) < share and any(by_kind[kind] for kind in kinds):
        for kind in kinds:
            while by_kind[kind] and len(chosen) < share:
                file, site = by_kind[kind].pop()
                inside = [other for name, other in chosen if name == file]
                if len(inside) < MOST_PER_FILE and all(site.end <= other.start or other.end <= site.start
                                                       for other in inside):
                    chosen.append((file, site))
                    break
    return chosen


def write_list(mutants, path):
    path.write_text("".join(json.dumps({field.name: getattr(mutant, field.name) for field in fields(Mutant)}) + "\n"
                            for mutant in mutants))


def read_list(path):
    return [Mutant(**json.loads(line)) for line in path.read_text().splitlines()]


def write_tree(original, tree, mutants):
    """The original files with all mutants planted. Files that would not change are not written."""
    planted = {}
    for mutant in mutants:
        planted.setdefault(mutant.file, []).append(mutant)
    for path in sorted(original.rglob("*")):
        if not path.is_file():
            continue
        name, content = str(path.relative_to(original)), path.read_bytes()
        if name in planted:
            content = with_mutants(content, planted[name])
        elif name == "cmake/Room.cmake":
            content = room_rules(content)
        elif name == "core/CMakeLists.txt":
            content = content.replace(b"SOURCES ", b"SOURCES mutant_switch.cpp ", 1)
        put(tree / name, content, path)
    put(tree / "core/mutant_switch.cpp", SWITCH.read_bytes(), SWITCH)


def put(path, content, like):
    if path.is_file() and path.read_bytes() == content:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)
    shutil.copymode(like, path)


def with_mutants(content, mutants):
    for mutant in sorted(mutants, key=lambda one: one.start, reverse=True):
        switched = mutant.text.format(on=f"::unietp_mutant({mutant.id})").encode()
        content = content[:mutant.start] + switched + content[mutant.end:]
    return HEADER.encode() + content


def room_rules(content):
    """Mutants may make comparisons that are always false, and are compiled more often than they are run."""
    end = b"  file(APPEND ${PROJECT_BINARY_DIR}/room_graph.txt"
    assert end in content
    return content.replace(end, b"  target_compile_options(unietp_${name} PRIVATE -w -O1)\n" + end, 1)


def broken(output, mutants):
    """The mutants that a compiler's errors fall on."""
    places = {(Path(file), int(line)) for file, line in
              re.findall(r"^(\S+?\.cpp):(\d+):\d+: (?:fatal )?error", output, re.M)}
    return [mutant for mutant in mutants
            if any(str(file).endswith("/" + mutant.file) and mutant.line <= line <= mutant.last_line
                   for file, line in places)]
