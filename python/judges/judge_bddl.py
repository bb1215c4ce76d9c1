"""BEHAVIOR's own package `bddl` on the activities of a data set, for `checks/judges bddl`.

It must parse each problem, and its evaluation must agree with ours at the start and after each step of the demonstration in M1:
of the problem's goal where the last state decides the task's goal, and otherwise of each proposition, with the formula over them
read here; then the problem's goal must follow from the task's. The atoms come from our scene graphs: the relations and states of
the objects that a problem names. The trivial backend of `bddl` 3.6.0 is not used, because it has two classes of one name and so
looks up `hot` as `on_fire`.

Our table of what things can do or undergo in BEHAVIOR (data/bddl/abilities.csv) must be the package's.

Exit code 1: a problem was not parsed, a goal was judged otherwise, or the table differs.
"""

import argparse
import csv
import json
import re
import sys
from dataclasses import dataclass
from pathlib import Path

from bddl.activity import Conditions, evaluate_goal_conditions, get_goal_conditions, get_object_scope
from bddl.backend_abc import BDDLBackend
from bddl.logic_base import BinaryAtomicFormula, UnaryAtomicFormula
from bddl.object_taxonomy import ObjectTaxonomy

import unietp
from unietp.dataset import changed
from report import finish

STATES = {"open": "open", "power_on": "toggled_on", "hot": "hot", "cooked": "cooked", "frozen": "frozen"}
STATES |= {"folded": "folded", "unfolded": "unfolded"}
COATS = {"dirty": ("covered", "stain"), "soaked": ("saturated", "water")}
UNARY = {*STATES.values(), "real", "future"}
RELATIONS = {"on": "ontop", "inside": "inside", "next_to": "nextto", "under": "under", "attached": "attached", "on_floor": "ontop"}
NAMES = re.compile(r"^; (\S+\.n\.\d+_\d+): (\S+)$", re.MULTILINE)  # "; platter.n.01_1: platter_80"
SUBSTANCE = re.compile(r"(filled|covered)\((.+)\)")
AGENT = "agent.n.01_1"
WATER, STAIN = "water.n.06", "stain.n.01"
DATA = Path(__file__).parents[2] / "data" / "bddl"
PLAIN = ("cloth", "fillable", "freezable", "heatable", "openable", "slicer", "toggleable")
COOKED_C = 70.0  # where nothing else is said


def substances():
    """The object of a problem that is a substance of ours."""
    with (DATA / "substances.csv").open(newline="") as rows:
        return {row["substance"]: row["synset"] + "_1" for row in csv.DictReader(rows)}


def abilities_of(abilities):
    """What the package says of a synset in the words of our table, as tuples of ability, °C and rate."""
    rows = {(word, None, None) for word in PLAIN if word in abilities}
    if "sliceable" in abilities or "diceable" in abilities:
        rows.add(("sliceable", None, None))
    if "cookable" in abilities:
        rows.add(("cookable", abilities["cookable"].get("cook_temperature", COOKED_C), None))
    for word, theirs in (("heat_source", "heatSource"), ("cold_source", "coldSource")):
        if theirs in abilities:
            rows.add((word, abilities[theirs]["temperature"], abilities[theirs]["heating_rate"]))
    if WATER in abilities.get("particleSource", {}).get("conditions", {}):
        rows.add(("gives_water", None, None))
    if "particleRemover" in abilities:
        conditions = abilities["particleRemover"].get("conditions") or {}
        rows.add(("saturable", None, None))
        if conditions.get(WATER) is not None:
            rows.add(("takes_water", None, None))
        if conditions.get(STAIN) == []:
            rows.add(("wipes_stains", None, None))
    return rows


def differing_abilities():
    """The synsets of which our table says otherwise than the package."""
    taxonomy = ObjectTaxonomy()
    with (DATA / "synsets.csv").open(newline="") as rows:
        ours = {row["synset"]: set() for row in csv.DictReader(rows)}
    with (DATA / "abilities.csv").open(newline="") as rows:
        for row in csv.DictReader(rows):
            numbers = [float(row[name]) if row[name] else None for name in ("celsius", "rate_per_s")]
            ours.setdefault(row["synset"], set()).add((row["ability"], *numbers))
    return sorted(synset for synset, its in ours.items() if its != abilities_of(taxonomy.get_abilities(synset)))


def literals(scene, names, synsets):
    """What holds in a scene graph of the objects in `names` (ours: BDDL's), as tuples of BDDL's words. Where the problem has
    halves of a thing, one that is cut is no longer there: the first half is what remains of it, the second the piece."""
    here = {room["id"]: names[room["id"]] for room in scene["rooms"] if room["id"] in names}
    for node in scene["nodes"]:
        cut = "sliced" in node["states"] and node["id"] + "/1" in names
        own = node["id"] + "/1" if cut else node["id"] if node["id"] in names else f"{node.get('slice_of')}/2"
        if own in names:
            here[node["id"]] = names[own]
    facts = {("real", name) for name in here.values()}
    facts |= {("future", name) for name in names.values() if ("real", name) not in facts}
    for node in scene["nodes"]:
        name = here.get(node["id"])
        for state in node["states"] if name else ():
            if state in STATES:
                facts.add((STATES[state], name))
            if state in COATS:
                facts.add((COATS[state][0], name, synsets[COATS[state][1]]))
            if found := SUBSTANCE.fullmatch(state):
                word, substance = found[1], synsets.get(found[2], found[2])
                facts |= {(one, name, substance) for one in (["filled", "contains"] if word == "filled" else [word])}
    facts |= {("grasped", AGENT, here[thing]) for thing in scene["agent"].get("held", []) if thing in here}
    return facts | {
        (RELATIONS[edge["relation"]], here[edge["from"]], here[edge["to"]])
        for edge in scene["edges"]
        if edge["relation"] in RELATIONS and edge["from"] in here and edge["to"] in here
    }


class Facts(BDDLBackend):
    """Atoms are true that stand in `true`; objects are their names."""

    def __init__(self):
        self.true = set()

    def get_predicate_class(self, name):
        facts = self

        class Predicate(UnaryAtomicFormula if name in UNARY else BinaryAtomicFormula):
            STATE_NAME = name

            def _evaluate(self, *objects):
                return (name, *(thing.name for thing in objects)) in facts.true

            def _sample(self, *arguments):
                raise NotImplementedError

        return Predicate


@dataclass(frozen=True)
class Thing:
    name: str


def compiled_goal(text, facts):
    """The compiled goal of a problem's text, which looks at `facts`."""
    conditions = Conditions("task", 0, "omnigibson", predefined_problem=text)
    scope = {name: Thing(name) for name in get_object_scope(conditions)}
    return get_goal_conditions(conditions, facts, scope, generate_ground_options=False)


def with_goal(text, goal):
    """A problem with another goal."""
    return text[: text.index("(:goal")] + f"(:goal {goal}))"


def holds(formula, trace):
    """A formula of linear temporal logic on a trace of sets of names, by the rules of docs/exports.md: ! & | F G U."""
    text = re.sub(r"\btrue\b", "(T)", re.sub(r"\bfalse\b", "(N)", formula))
    words = iter(re.findall(r"[a-z][a-z0-9_]*|[!&|FGUTN()]", text) + [None])
    word = next(words)
    last = len(trace) - 1

    def advance():
        nonlocal word
        word = next(words)

    def operand():
        sign = word
        advance()
        if sign == "(":
            value = whole()
            advance()
            return value
        if sign in ("T", "N"):
            return [sign == "T"] * len(trace)
        if sign in ("!", "F", "G"):
            value = operand()
            if sign == "!":
                return [not one for one in value]
            return [(any if sign == "F" else all)(value[at:]) for at in range(len(value))]
        return [sign in state for state in trace]

    def whole():
        value = operand()
        while word in ("&", "|", "U"):
            sign = word
            advance()
            other = operand()
            if sign == "U":
                met = [other[last]] * len(trace)
                for at in reversed(range(last)):
                    met[at] = other[at] or (value[at] and met[at + 1])
                value = met
            else:
                value = [(a and b) if sign == "&" else (a or b) for a, b in zip(value, other)]
        return value

    return whole()[0]


def moments_of(env, step):
    """Does a step; the scene graphs of the moments that it passes through, the last of which is how it ends."""
    before = env.scene()
    env.step(step.command())
    scenes = []
    for change in env.executed()[-1].get("moments", [])[:-1]:
        before = changed(before, change)
        scenes.append(before)
    return [*scenes, env.scene()]


def judge(env, demonstration, activity, text, synsets):
    """One row: how often the two agree on the states of a task's demonstration, and the first state where they do not."""
    task = activity["task"]
    facts = Facts()
    try:
        goal = compiled_goal(text, facts)
        propositions = {
            one["name"]: compiled_goal(with_goal(text, one["bddl"]), facts) for one in activity["goal"]["propositions"]
        }
    except Exception as error:  # the package raises whatever its parser trips over
        return {"task": task, "parsed": f"no: {error!r}", "states": 0, "agreed": 0}
    names = {ours: theirs for theirs, ours in NAMES.findall(text)}
    env.reset(options={"task": task})
    trace, apart, theirs = [], [], False
    for number, step in enumerate([None, *demonstration.steps]):
        for scene in [env.scene()] if step is None else moments_of(env, step):
            facts.true = literals(scene, names, synsets)
            trace.append({name for name, one in propositions.items() if evaluate_goal_conditions(one)[0]})
        ours, asked = env.privileged()["success"], evaluate_goal_conditions(goal)[0]
        theirs = holds(activity["goal"]["formula"], trace)
        if theirs != ours or (asked != ours if activity["last_state_decides"] else ours and not asked):
            apart.append(number)
    return {
        "task": task,
        "parsed": "yes",
        "decided_by": "last state" if activity["last_state_decides"] else "formula",
        "states": len(trace),
        "agreed": len(trace) - len(apart),
        "first_disagreement": apart[0] if apart else "",
        "true_at_the_end": "yes" if theirs else "no",
    }


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("dataset", type=Path)
    options.add_argument("folder", type=Path, help="what `unietp export --format behavior` wrote")
    options.add_argument("out", type=Path, help="a CSV file to write")
    options = options.parse_args()
    env = unietp.make(options.dataset, "M1", picture=False)
    dataset = unietp.load_dataset(options.dataset)
    synsets = substances()
    rows = []
    for file in sorted(options.folder.glob("*.json")):
        problem = options.folder / "activity_definitions" / file.stem / "problem0.bddl"
        activity = json.loads(file.read_text())
        rows.append(judge(env, dataset.demonstration(file.stem), activity, problem.read_text(), synsets))
    if apart := differing_abilities():
        sys.exit(f"data/bddl/abilities.csv differs from bddl of {apart}")
    parsed = sum(row["parsed"] == "yes" for row in rows)
    states, agreed = (sum(row[name] for row in rows) for name in ("states", "agreed"))
    alone = sum(row.get("decided_by") == "last state" for row in rows)
    finish(
        rows,
        options.out,
        f"bddl parses {parsed} of {len(rows)} problems, {alone} of which are the whole goal, and agrees with ours on {agreed} of "
        f"{states} states",
        lambda row: row["parsed"] == row.get("true_at_the_end") == "yes" and row["states"] == row["agreed"],
    )


if __name__ == "__main__":
    main()
