"""Demonstrations of a data set in OmniGibson, for `checks/judges behavior`: does BEHAVIOR say that they reach the goal?

Each activity is acted out by the backend of `unietp evaluate` (act_behavior.py). At the start and after each step the
package `bddl` evaluates the problem's goal on OmniGibson's states, and where the last state does not decide it, the formula
over its propositions. Isaac Sim is replaced (python/tests/stand_ins): the primitives and the BDDL backend are OmniGibson's.
The results stand beside those of `unietp evaluate --backend behavior --policy replay`, which has our evaluator on the same
states.

Exit code 1: for a demonstration that was executed to its end, the two do not agree, or the goal is not reached though
nothing of it is beyond the stand-in.
"""

import argparse
import json
from pathlib import Path
from typing import Any

import act_behavior
from acting import Facts
from judge_bddl import holds, with_goal
from report import Row, finish

import unietp


def facts_of(scene: dict[str, Any]) -> Facts:
    edges = {(edge["relation"], edge["from"], edge["to"]) for edge in scene["edges"]}
    return Facts({node["id"]: node["states"] for node in scene["nodes"]}, edges, list(scene["agent"].get("held", [])))


class Judge:
    """The goal of an activity on the states of an episode."""

    def __init__(self, episode: act_behavior.Episode):
        self.episode, self.goal = episode, episode.task["goal"]
        self.decides: bool = episode.task["last_state_decides"]
        self.propositions = {
            one["name"]: episode.goal_of(with_goal(episode.problem, one["bddl"])) for one in self.goal["propositions"]
        }
        self.trace: list[set[str]] = []

    def look(self) -> None:
        self.trace.append({name for name, one in self.propositions.items() if one.holds()})

    def reached(self) -> bool:
        return self.episode.goal.holds() if self.decides else bool(holds(self.goal["formula"], self.trace))


def judge(folder: Path, dataset: Any, task: str, gibson: Any) -> Row:
    start, *_ = dataset.scenes(task, "M1")
    try:
        episode = act_behavior.Episode(folder, task, facts_of(start), gibson)
        judge = Judge(episode)
        episode.watch = judge.look
        judge.look()
        at_start = judge.reached()
    except KeyError as error:  # of the states of an object
        return {"task": task, "judged": f"no, OmniGibson has no such state of an object that the goal names: {error}"}
    row: Row = {"task": task, "judged": "last state" if judge.decides else "formula"}
    row["reached_at_start"] = "yes" if at_start else "no"
    for number, step in enumerate(dataset.demonstration(task).steps):
        if step.action == "stop":
            continue
        answer = episode.act(step.action, list(step.args), step.changes)
        if not answer["success"]:
            row |= {"refused_step": number, "refused": step.action, "why": answer["message"]}
            break
        judge.look()
    reached = judge.reached()
    if not reached and "refused" not in row and "(nextto " in episode.problem.split("(:goal", 1)[1]:
        row["why"] = "the goal asks for nextto, and things have no shapes in the stand-in"
    return row | {"reached": "yes" if reached else "no"}


def evaluated(run: Path) -> dict[str, bool]:
    """Which tasks our evaluator says are reached in a run."""
    lines = (json.loads(line) for line in (run / "episodes.jsonl").read_text().splitlines())
    return {line["task"]: line["success"] for line in lines}


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("dataset", type=Path)
    options.add_argument("folder", type=Path, help="what `unietp export --format behavior` wrote")
    options.add_argument("run", type=Path, help="what `unietp evaluate --backend behavior --policy replay` wrote")
    options.add_argument("out", type=Path, help="a CSV file to write")
    options = options.parse_args()
    gibson, dataset, ours = act_behavior.start_omnigibson(), unietp.load_dataset(options.dataset), evaluated(options.run)
    rows = []
    for file in sorted(options.folder.glob("*.json")):
        row = judge(options.folder, dataset, file.stem, gibson)
        rows.append(row | {"ours": {True: "yes", False: "no", None: "not told"}[ours.get(file.stem)]})
    done = [row for row in rows if "reached" in row and "refused" not in row]
    both = [row for row in rows if row["ours"] != "not told"]
    finish(
        rows,
        options.out,
        f"of {len(rows)} demonstrations {len(done)} are executed to the end; bddl says that {count(rows, 'reached')} reach the "
        f"goal; of the {len(both)} whose goals the backend tells of, {count(both, 'reached')} by bddl and {count(both, 'ours')} by ours",
        lambda row: "reached" not in row or (row["ours"] in (row["reached"], "not told") and is_explained(row)),
    )


def is_explained(row: Row) -> bool:
    return row["reached"] == "yes" or "why" in row


def count(rows: list[Row], name: str) -> int:
    return sum(row.get(name) == "yes" for row in rows)


if __name__ == "__main__":
    main()
