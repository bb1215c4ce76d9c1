"""Independent planners on the PDDL of a data set, for `checks/judges planners`.

For each problem Fast Downward (up-fast-downward) grounds the task; in what it makes of it (sas_task.py) the stored plan must
reach the goal, and not without any one of its steps. Then it must find a plan itself, with the first search of LAMA. Each N-th
of these is acted out once more by unified-planning's simulator, which reads the PDDL with a parser of its own; that takes half
a minute a problem or more, because it writes out every conditional effect in Python.

OUT.csv gets a row as soon as a problem is judged, and a later call goes on with the others. Problems come in an order that
has nothing to do with what they are, so that those judged so far are a fair sample. The rows do not depend on the machine,
except where Fast Downward runs out of time.

Exit code 1: a problem was not grounded or solved, or a plan was judged otherwise than it should be.
"""

import argparse
import csv
import hashlib
import os
import subprocess
import sys
import tempfile
import warnings
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import up_fast_downward
from unified_planning.engines import UPSequentialSimulator
from unified_planning.io import PDDLReader

from report import finish
from sas_task import SasTask, actions_of, holds

warnings.filterwarnings("ignore", module="unified_planning")
DOWNWARD = Path(up_fast_downward.__file__).parent / "downward" / "fast-downward.py"
# The monitors' actions at the end of a plan may be none that its goal needs. Nor is a second walk to where the agent is:
# PDDL has places, and not where at a fridge one stands while it is opened and after.
SPARE = ("note", "judge", "again")
# Fast Downward looks for facts that exclude each other, to make variables of them: nine tenths of the time for large problems.
# Without them each fact is a variable of its own, which changes neither what actions do nor which plans there are.
WITHOUT_INVARIANTS = ("--invariant-generation-max-candidates", "0")
COLUMNS = ("task", "grounded", "stored_steps", "stored_valid", "steps_not_needed", "solved", "solution_steps", "solution_valid",
           "unified_planning")  # fmt: skip


def downward(folder, *arguments):
    """Fast Downward in a folder; why it did not do it, "" where it did."""
    done = subprocess.run([sys.executable, DOWNWARD, *arguments], cwd=folder, capture_output=True, text=True)
    return "" if done.returncode == 0 else f"exit code {done.returncode}"


def kind_of(plan, step):
    """The action of a step; "again" for a walk to where the walk before it led."""
    walks = [action for action in plan[:step] if action.startswith("go_to ")]
    return "again" if walks and walks[-1] == plan[step] else plan[step].split()[0]


def judged_by_downward(problem, seconds):
    """The columns of a row up to `solution_valid`, and the text of the plan that was found."""
    row = {"task": problem.stem}
    with tempfile.TemporaryDirectory() as folder:
        inputs = [problem.with_name("domain.pddl").resolve(), problem.resolve()]
        limit = ("--translate", "--translate-time-limit", str(seconds))
        failed = downward(folder, *limit, *inputs, "--translate-options", *WITHOUT_INVARIANTS)
        row["grounded"] = failed or "yes"
        if failed:
            return row, None
        task = SasTask(Path(folder) / "output.sas")
        stored = list(actions_of(problem.with_suffix(".plan").read_text()))
        states = task.states(stored)
        valid = len(states) == len(stored) + 1 and holds(task.goal, states[-1])
        spare = [
            f"{left_out}:{kind_of(stored, left_out)}"
            for left_out in range(len(stored) if valid else 0)
            if task.reaches(stored[left_out + 1 :], states[left_out])
        ]
        row["stored_steps"] = len(stored)
        row["stored_valid"] = "yes" if valid else f"no, it stops before step {len(states)}"
        row["steps_not_needed"] = " ".join(spare)
        failed = downward(folder, "--search-time-limit", str(seconds), "--alias", "lama-first", "output.sas")
        plan = Path(folder) / "sas_plan"
        text = plan.read_text() if plan.exists() else None
        row["solved"] = "yes" if text else failed
        if text:
            found = list(actions_of(text))
            row |= {"solution_steps": len(found), "solution_valid": "yes" if task.reaches(found) else "no"}
        return row, text


def accepted_by_unified_planning(problem, text):
    """Whether its simulator reaches the goal with a plan."""
    reader = PDDLReader()
    parsed = reader.parse_problem(str(problem.with_name("domain.pddl")), str(problem))
    simulator = UPSequentialSimulator(parsed, error_on_failed_checks=False)
    state = simulator.get_initial_state()
    for action in reader.parse_plan_string(parsed, text).actions:
        state = simulator.apply(state, action.action, action.actual_parameters)
        if state is None:
            return False
    return simulator.is_goal(state)


def judge(problem, seconds, by_unified_planning):
    row, found = judged_by_downward(problem, seconds)
    if by_unified_planning:
        plans = {"stored": problem.with_suffix(".plan").read_text(), "found": found}
        refused = [name for name, text in plans.items() if text and not accepted_by_unified_planning(problem, text)]
        row["unified_planning"] = "refuses " + " and ".join(refused) if refused else "yes"
    return row


def needed(row):
    """How many of a plan's steps must be rejected when they are left out, and are."""
    spare = [step for step in row["steps_not_needed"].split() if step.split(":")[1] not in SPARE]
    return int(row["stored_steps"]) - len(row["steps_not_needed"].split()), len(spare)


def is_right(row):
    plans = [row.get(name) or "yes" for name in ("stored_valid", "solution_valid", "unified_planning")]
    return row["grounded"] == row["solved"] == "yes" and set(plans) == {"yes"} and needed(row)[1] == 0


def read_rows(out):
    if not out.exists():
        return []
    with out.open(newline="") as file:
        return list(csv.DictReader(file))


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", type=Path, help="what `unietp export --format pddl` wrote")
    options.add_argument("out", type=Path, help="a CSV file to write, or to go on with")
    options.add_argument("--acted", type=int, default=40, metavar="N", help="unified-planning acts out the plans of each N-th")
    options.add_argument("--seconds", type=int, default=60, help="of the processor, for grounding and for searching")
    options.add_argument("--jobs", type=int, default=os.cpu_count(), help="problems at once (default: one for each processor)")
    options = options.parse_args()
    problems = [path for path in options.folder.glob("*/*.pddl") if path.stem != "domain"]
    problems.sort(key=lambda path: hashlib.sha256(path.stem.encode()).digest())
    done = {row["task"] for row in read_rows(options.out)}
    with options.out.open("a", newline="") as file:
        rows = csv.DictWriter(file, COLUMNS, restval="", lineterminator="\n")
        if not done:
            rows.writeheader()
        left = [(problem, number % options.acted == 0) for number, problem in enumerate(problems) if problem.stem not in done]
        with ThreadPoolExecutor(options.jobs) as jobs:
            judged = jobs.map(lambda one: judge(one[0], options.seconds, one[1]), left)
            for number, row in enumerate(judged, len(problems) - len(left) + 1):
                rows.writerow(row)
                file.flush()
                print(f"\r{number} of {len(problems)}", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    here = {path.stem for path in problems}
    rows = sorted((row for row in read_rows(options.out) if row["task"] in here), key=lambda row: row["task"])
    finish(rows, options.out, summary(rows), is_right)


def summary(rows):
    grounded = [row for row in rows if row["grounded"] == "yes"]
    acted = [row for row in rows if row["unified_planning"]]
    spare = Counter(step.split(":")[1] for row in grounded for step in row["steps_not_needed"].split())
    return (
        f"Fast Downward grounds {len(grounded)} of {len(rows)} problems, and solves "
        f"{sum(row['solved'] == 'yes' for row in rows)}\n"
        f"it accepts the stored plan of {sum(row['stored_valid'] == 'yes' for row in grounded)} of {len(grounded)}, and "
        f"refuses {sum(needed(row)[0] for row in grounded)} of {sum(int(row['stored_steps']) for row in grounded)} plans that "
        f"lack a step; the others lack {dict(spare)}\n"
        f"unified-planning accepts the plans of {sum(row['unified_planning'] == 'yes' for row in acted)} of {len(acted)}"
    )


if __name__ == "__main__":
    main()
