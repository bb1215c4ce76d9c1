"""Independent planners on the PDDL of a data set, for `checks/judges planners`.

Fast Downward (up-fast-downward) must find a plan for each problem. For each N-th problem unified-planning's simulator must
accept that plan and the stored one, and refuse the stored one without any one of its steps. That takes half a minute a
problem or more, because it writes out every conditional effect in Python.

The rows of OUT.csv are sorted by task and do not depend on the machine, except where Fast Downward runs out of time.
Exit code 1: a problem was not solved, or a plan was judged otherwise than it should be.
"""

import argparse
import subprocess
import sys
import tempfile
import warnings
from collections import Counter
from pathlib import Path

import up_fast_downward
from unified_planning.engines import UPSequentialSimulator
from unified_planning.io import PDDLReader

from report import finish

warnings.filterwarnings("ignore", module="unified_planning")
DOWNWARD = Path(up_fast_downward.__file__).parent / "downward" / "fast-downward.py"


def solve(domain, problem, seconds):
    """The text of a plan by Fast Downward's lazy greedy search with the FF heuristic, or the reason why there is none."""
    with tempfile.TemporaryDirectory() as folder:
        plan = Path(folder) / "plan"
        command = [sys.executable, DOWNWARD, "--overall-time-limit", str(seconds), "--plan-file", plan, domain, problem]
        command += ["--search", "lazy_greedy([ff()], preferred=[ff()])"]
        done = subprocess.run(command, capture_output=True, text=True)
        if plan.exists():
            return plan.read_text(), ""
        return None, f"exit code {done.returncode}"


class Judge:
    """Acts out plans of one problem in unified-planning's simulator."""

    def __init__(self, domain, problem):
        reader = PDDLReader()
        self.problem = reader.parse_problem(str(domain), str(problem))
        self.simulator = UPSequentialSimulator(self.problem, error_on_failed_checks=False)
        self.reader = reader

    def plan(self, text):
        return self.reader.parse_plan_string(self.problem, text).actions

    def states(self, actions, state=None):
        """The state before each action and after the last; shorter where an action cannot be done."""
        states = [state or self.simulator.get_initial_state()]
        for action in actions:
            after = self.simulator.apply(states[-1], action.action, action.actual_parameters)
            if after is None:
                break
            states.append(after)
        return states

    def reaches(self, actions, state=None):
        states = self.states(actions, state)
        return len(states) == len(actions) + 1 and self.simulator.is_goal(states[-1])


def solved_row(problem, seconds):
    """What Fast Downward says of a task's problem, and its plan."""
    text, reason = solve(problem.with_name("domain.pddl"), problem, seconds)
    steps = sum(line.startswith("(") for line in text.splitlines()) if text else ""
    return {"task": problem.stem, "solved": "yes" if text else reason, "solution_steps": steps}, text


def acted_row(problem, text):
    """What unified-planning's simulator says of Fast Downward's plan, of the stored one, and of that without a step."""
    judge = Judge(problem.with_name("domain.pddl"), problem)
    stored = judge.plan(problem.with_suffix(".plan").read_text())
    states = judge.states(stored)
    valid = len(states) == len(stored) + 1 and judge.simulator.is_goal(states[-1])
    spare = [
        f"{left_out}:{stored[left_out].action.name}"
        for left_out in range(len(stored) if valid else 0)
        if judge.reaches(stored[left_out + 1 :], states[left_out])
    ]
    return {
        "solution_valid": "" if text is None else "yes" if judge.reaches(judge.plan(text)) else "no",
        "stored_steps": len(stored),
        "stored_valid": "yes" if valid else f"no, it stops before step {len(states)}",
        "steps_not_needed": " ".join(spare),
    }


def is_right(row):
    valid = row.get("solution_valid", "yes") == row.get("stored_valid", "yes") == "yes"
    return row["solved"] == "yes" and valid and not row.get("steps_not_needed")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", type=Path, help="what `unietp export --format pddl` wrote")
    options.add_argument("out", type=Path, help="a CSV file to write")
    options.add_argument("--only", type=int, default=1, metavar="N", help="solve only each N-th problem")
    options.add_argument("--acted", type=int, default=40, metavar="N", help="act out the plans of each N-th problem solved")
    options.add_argument("--seconds", type=int, default=120, help="the time that Fast Downward has for a problem")
    options = options.parse_args()
    problems = sorted(path for path in options.folder.glob("*/*.pddl") if path.stem != "domain")[:: options.only]
    rows = []
    for number, problem in enumerate(problems):
        row, text = solved_row(problem, options.seconds)
        rows.append(row | (acted_row(problem, text) if number % options.acted == 0 else {}))
        print(f"\r{number + 1} of {len(problems)}", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    acted = [row for row in rows if "stored_steps" in row]
    spare = Counter(step.split(":")[1] for row in acted for step in row["steps_not_needed"].split())
    steps = sum(row["stored_steps"] for row in acted)
    finish(
        rows,
        options.out,
        f"Fast Downward solves {sum(row['solved'] == 'yes' for row in rows)} of {len(rows)} problems\n"
        f"unified-planning accepts the stored plan of {sum(row['stored_valid'] == 'yes' for row in acted)} of {len(acted)}\n"
        f"and refuses {steps - sum(spare.values())} of {steps} plans that lack a step; the others lack {dict(spare)}",
        is_right,
    )


if __name__ == "__main__":
    main()
