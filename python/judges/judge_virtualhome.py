"""VirtualHome's evolving-graph simulator on the programs of a data set, for `checks/judges virtualhome`.

The simulator must execute each program (the demonstration in M1) in the graph of the task's start. In its last graph every
object that the demonstration changed must be on or in what it is on or in at the end of our physics, and be open, closed, on
or off as it is there.

With the table of what objects of each class can do in Unity (`properties_data_unity.json` of VirtualHome), a column tells what a
program asks of a class that the table denies. Our tasks go by both worlds of VirtualHome, of which the one of scripts knows,
for example, that a washing machine opens; so this is counted, and no fault.

Exit code 1: a program was not executed, or an object ended otherwise.
"""

import argparse
import importlib.util
import json
import re
import sys
from collections import Counter
from pathlib import Path

import unietp
from report import finish

# The package's own start needs Unity, so the modules of the graph are imported without it.
sys.path.append(importlib.util.find_spec("virtualhome").submodule_search_locations[0] + "/simulation")
from evolving_graph.environment import EnvironmentGraph  # noqa: E402
from evolving_graph.execution import ScriptExecutor  # noqa: E402
from evolving_graph.scripts import read_script_from_list_string  # noqa: E402

STATES = {"open": "OPEN", "closed": "CLOSED", "power_on": "ON", "power_off": "OFF"}
RELATIONS = {"on": "ON", "inside": "INSIDE"}
# What Unity's actions need of their object, as VirtualHome's documentation of its Unity simulator says.
NEEDS = {"Grab": "GRABBABLE", "PutBack": "SURFACES", "PutIn": "CONTAINERS", "Open": "CAN_OPEN", "Close": "CAN_OPEN",
         "SwitchOn": "HAS_SWITCH", "SwitchOff": "HAS_SWITCH", "Sit": "SITTABLE"}  # fmt: skip
LINE = re.compile(r"\[(\w+)\](?: <[^>]+> \(\d+\))*? <([^>]+)> \(\d+\)$")  # an action and the last object that it names


def ours_at_the_end(dataset, task, numbers):
    """Of the objects that the demonstration changed: (number, relation, number) and (number, state) in VirtualHome's words,
    and their numbers."""
    *_, scene = dataset.scenes(task, "M1")
    steps = dataset.demonstration(task).steps
    changed = {node["id"] for step in steps for node in step.changes.get("nodes", [])}
    edges = [edge for edge in scene["edges"] if edge["relation"] in RELATIONS and edge["from"] in changed]
    facts = {(numbers[edge["from"]], RELATIONS[edge["relation"]], numbers[edge["to"]]) for edge in edges}
    for node in scene["nodes"]:
        if node["id"] in changed:
            facts |= {(numbers[node["id"]], STATES[state]) for state in node["states"] if state in STATES}
    return facts, {numbers[thing] for thing in changed}


def theirs_at_the_end(graph, things, known):
    """The same of their graph, which need not say that what is on or in a thing is also in what that thing is in."""
    edges = {
        (edge["from_id"], edge["relation_type"], edge["to_id"])
        for edge in graph["edges"]
        if edge["relation_type"] in RELATIONS.values() and edge["from_id"] in known and edge["to_id"] in known
    }
    while indirect := {(one, "INSIDE", far) for one, _, near in edges for it, rel, far in edges if it == near and rel == "INSIDE" and far != one} - edges:
        edges |= indirect
    facts = {edge for edge in edges if edge[0] in things}
    for node in graph["nodes"]:
        if node["id"] in things:
            facts |= {(node["id"], state) for state in node["states"] if state in STATES.values()}
    return facts


def denied_by_unity(lines, table):
    """Actions with classes that have not the property of the table which the action needs."""
    acts = [found.groups() for found in map(LINE.match, lines) if found]
    denied = [f"{word} {name}" for word, name in acts if word in NEEDS and NEEDS[word] not in table.get(name.replace("_", ""), ())]
    return list(dict.fromkeys(denied))


def judge(dataset, folder, task, table):
    """One row: whether the program of a task runs, and in what its end differs from ours."""
    graph = json.loads((folder / f"{task}.json").read_text())
    names = json.loads((folder / f"{task}.names.json").read_text())
    numbers = {ours: int(name.rsplit("_", 1)[1]) for ours, name in names.items()}
    lines = [line for line in (folder / f"{task}.txt").read_text().splitlines() if line.startswith("[")]
    executor = ScriptExecutor(EnvironmentGraph(graph), {})
    done, _, graphs = executor.execute(read_script_from_list_string(lines), w_graph_list=True)
    row = {"task": task, "lines": len(lines), "executed": "yes" if done else executor.info.get_error_string()}
    if table is not None:
        row["denied_by_unity"] = "; ".join(denied_by_unity(lines, table))
    if not done:
        return row | {"end": "", "differs": ""}
    ours, things = ours_at_the_end(dataset, task, numbers)
    theirs = theirs_at_the_end(graphs[-1], things, set(numbers.values()))
    apart = ours ^ theirs
    return row | {
        "end": "differs" if apart else "equal",
        "differs": "; ".join(("ours " if fact in ours else "theirs ") + " ".join(map(str, fact)) for fact in sorted(apart, key=str)),
    }


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("dataset", type=Path)
    options.add_argument("folder", type=Path, help="what `unietp export --format virtualhome` wrote")
    options.add_argument("out", type=Path, help="a CSV file to write")
    options.add_argument("--unity", type=Path, metavar="FILE", help="properties_data_unity.json of VirtualHome")
    options = options.parse_args()
    table = json.loads(options.unity.read_text()) if options.unity else None
    dataset = unietp.load_dataset(options.dataset)
    rows = [judge(dataset, options.folder, program.stem, table) for program in sorted(options.folder.glob("*.txt"))]
    ends = Counter(row["end"] for row in rows if row["executed"] == "yes")
    denied = Counter(pair for row in rows for pair in row.get("denied_by_unity", "").split("; ") if pair)
    allowed = "" if table is None else (
        f"\nUnity's table allows {sum(not row['denied_by_unity'] for row in rows)} of them; it denies {dict(denied.most_common())}"
    )
    finish(
        rows,
        options.out,
        f"VirtualHome's graph simulator executes {sum(ends.values())} of {len(rows)} programs; their ends: {dict(ends)}{allowed}",
        lambda row: row["end"] == "equal",
    )


if __name__ == "__main__":
    main()
