"""BEHAVIOR's own package `bddl` on the BDDL problems of a data set, for `checks/judges bddl`.

It must parse each problem, and its evaluation of the goal must agree with ours at the start and after each step of the
demonstration in M1. The atoms come from our scene graphs: the relations and states of the objects that a problem names. The
trivial backend of `bddl` 3.6.0 is not used, because it has two classes of one name and so looks up `hot` as `on_fire`.

Exit code 1: a problem was not parsed, or a goal was judged otherwise.
"""

import argparse
import re
from dataclasses import dataclass
from pathlib import Path

from bddl.activity import Conditions, evaluate_goal_conditions, get_goal_conditions, get_object_scope
from bddl.backend_abc import BDDLBackend
from bddl.logic_base import BinaryAtomicFormula, UnaryAtomicFormula

import unietp
from report import finish

STATES = {"open": "open", "power_on": "toggled_on", "hot": "hot", "cooked": "cooked", "frozen": "frozen"}
STATES |= {"folded": "folded", "unfolded": "unfolded"}
RELATIONS = {"on": "ontop", "inside": "inside", "next_to": "nextto", "under": "under"}
NAMES = re.compile(r"^; (\S+\.n\.\d+_\d+): (\S+)$", re.MULTILINE)  # "; platter.n.01_1: platter_80"


def literals(scene, names):
    """What holds in a scene graph of the objects in `names` (ours: BDDL's), as tuples of BDDL's words."""
    states = {
        (STATES[state], names[node["id"]])
        for node in scene["nodes"]
        if node["id"] in names
        for state in node["states"]
        if state in STATES
    }
    return states | {
        (RELATIONS[edge["relation"]], names[edge["from"]], names[edge["to"]])
        for edge in scene["edges"]
        if edge["relation"] in RELATIONS and edge["from"] in names and edge["to"] in names
    }


class Facts(BDDLBackend):
    """Atoms are true that stand in `true`; objects are their names."""

    def __init__(self):
        self.true = set()

    def get_predicate_class(self, name):
        facts = self

        class Predicate(UnaryAtomicFormula if name in STATES.values() else BinaryAtomicFormula):
            STATE_NAME = name

            def _evaluate(self, *objects):
                return (name, *(thing.name for thing in objects)) in facts.true

            def _sample(self, *arguments):
                raise NotImplementedError

        return Predicate


@dataclass(frozen=True)
class Thing:
    name: str


def compiled_goal(text):
    """The compiled goal of a problem's text, and the facts that it looks at."""
    conditions = Conditions("task", 0, "omnigibson", predefined_problem=text)
    facts = Facts()
    scope = {name: Thing(name) for name in get_object_scope(conditions)}
    return get_goal_conditions(conditions, facts, scope, generate_ground_options=False), facts


def judge(env, task, demonstration, text):
    """One row: how often the two agree on the states of a task's demonstration, and the first state where they do not."""
    try:
        goal, facts = compiled_goal(text)
    except Exception as error:  # the package raises whatever its parser trips over
        return {"task": task, "parsed": f"no: {error!r}", "states": 0, "agreed": 0}
    names = {ours: theirs for theirs, ours in NAMES.findall(text)}
    env.reset(options={"task": task})
    verdicts = []
    for step in [None, *demonstration.steps]:
        if step is not None:
            env.step(step.command())
        facts.true = literals(env.scene(), names)
        verdicts.append((env.privileged()["success"], evaluate_goal_conditions(goal)[0]))
    apart = [number for number, (ours, theirs) in enumerate(verdicts) if ours != theirs]
    return {
        "task": task,
        "parsed": "yes",
        "states": len(verdicts),
        "agreed": len(verdicts) - len(apart),
        "first_disagreement": apart[0] if apart else "",
        "true_at_the_end": "yes" if verdicts[-1][1] else "no",
    }


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("dataset", type=Path)
    options.add_argument("folder", type=Path, help="what `unietp export --format bddl` wrote")
    options.add_argument("out", type=Path, help="a CSV file to write")
    options = options.parse_args()
    env = unietp.make(options.dataset, "M1", picture=False)
    dataset = unietp.load_dataset(options.dataset)
    rows = [
        judge(env, problem.stem, dataset.demonstration(problem.stem), problem.read_text())
        for problem in sorted(options.folder.glob("*.bddl"))
    ]
    parsed = sum(row["parsed"] == "yes" for row in rows)
    states, agreed = (sum(row[name] for row in rows) for name in ("states", "agreed"))
    finish(
        rows,
        options.out,
        f"bddl parses {parsed} of {len(rows)} problems and agrees with ours on {agreed} of {states} states",
        lambda row: row["parsed"] == row.get("true_at_the_end") == "yes" and row["states"] == row["agreed"],
    )


if __name__ == "__main__":
    main()
