"""Independent planners on the PDDL of a data set, for `checks/judges planners`.

For each problem Fast Downward (up-fast-downward) grounds the task; in what it makes of it (sas_task.py) the stored plan must
reach the goal, and not without any one of its steps. Then it must find a plan itself, with the first search of LAMA. Of each
N-th problem unified-planning's validator, which reads the PDDL with a parser of its own, is asked the same of the stored plan,
of those that lack one of its steps, and of the plan that was found. Reading a domain takes most of its time, so each process reads
one once, and judges its problems in children that have it.

OUT.csv gets a row as soon as a problem is judged, so that a slow one holds up no other, and a later call goes on with those
that have none, or one of another domain, problem or plan by its digest (`of`); where unified-planning was not asked and now is, it
is asked without Fast Downward. Problems come in an order that has nothing to do with what they are, so that those judged so far are a
fair sample. Grounding, searching and validating each have a limit of memory and of time of the processor; a problem that needs more
is recorded as "not within" it. The limit of time is generous, so that the one of memory, which does not depend on how fast the
machine is, comes first.

Exit code 1: a problem was not grounded or solved, or a plan was judged otherwise than it should be.
"""

import argparse
import csv
import functools
import hashlib
import multiprocessing
import os
import resource
import subprocess
import sys
import tempfile
import warnings
from collections import Counter
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path

import up_fast_downward
from unified_planning.engines import SequentialPlanValidator
from unified_planning.io import PDDLReader, pddl_reader
from unified_planning.plans import SequentialPlan

from report import finish
from sas_task import SasTask, actions_of, holds

warnings.filterwarnings("ignore", module="unified_planning")
DOWNWARD = Path(up_fast_downward.__file__).parent / "downward" / "fast-downward.py"
# The monitors' actions at the end of a plan may be none that its goal needs.
SPARE = ("note", "judge")
# Fast Downward looks for facts that exclude each other, to make variables of them: nine tenths of the time for large problems.
# Without them each fact is a variable of its own, which changes neither what actions do nor which plans there are.
WITHOUT_INVARIANTS = ("--invariant-generation-max-candidates", "0")
COLUMNS = ("task", "of", "grounded", "stored_steps", "stored_valid", "steps_not_needed", "solved", "solution_steps", "solution_valid",
           "unified_planning", "not_needed_by_unified_planning")  # fmt: skip

FORK = multiprocessing.get_context("fork")
# The reader parses the domain's text again with each problem; children of a process that has read it find it parsed.
pddl_reader.parse_string = functools.lru_cache(maxsize=None)(pddl_reader.parse_string)
READER = PDDLReader()

# What Fast Downward's exit codes say of its limits; 24 is both.
OUT_OF_MEMORY, OUT_OF_TIME = (20, 22, 24), (21, 23)


class Limits:
    """Of one process: seconds of the processor, and MiB of memory."""

    def __init__(self, seconds, memory):
        self.seconds, self.memory = seconds, memory

    def of(self, part):
        return (f"--{part}-time-limit", str(self.seconds), f"--{part}-memory-limit", f"{self.memory}M")

    def downward(self, folder, *arguments):
        """Fast Downward in a folder; why it did not do it, "" where it did."""
        done = subprocess.run([sys.executable, DOWNWARD, *arguments], cwd=folder, capture_output=True, text=True)
        if done.returncode in OUT_OF_MEMORY:
            return f"not within {self.memory} MiB"
        if done.returncode in OUT_OF_TIME:
            return f"not within {self.seconds} s"
        return "" if done.returncode == 0 else f"exit code {done.returncode}"

    def validate(self, problem, plans):
        """What unified-planning's validator says of a problem and plans in files: for each whether it reaches the goal, and
        the numbers of the steps without which it does; why it did not say, as text."""
        read_domain(problem.with_name("domain.pddl"))
        answers, end = FORK.Pipe(duplex=False)
        child = FORK.Process(target=self.tell, args=(end, problem, plans))
        child.start()
        end.close()
        try:
            said = answers.recv()
        except EOFError:
            said = None
        child.join()
        if said is not None:
            return said
        # the kernel ends what has used its time
        return f"not within {self.seconds} s" if child.exitcode in (-9, -24) else f"exit code {child.exitcode}"

    def tell(self, end, problem, plans):
        """In the child of `validate`."""
        self.set()
        try:
            said = validated_by_unified_planning(problem, plans)
        except MemoryError:
            said = f"not within {self.memory} MiB"
        end.send(said)

    def set(self):
        resource.setrlimit(resource.RLIMIT_CPU, (self.seconds, self.seconds))
        resource.setrlimit(resource.RLIMIT_AS, (self.memory << 20, self.memory << 20))


@functools.cache
def read_domain(domain):
    READER.parse_problem(str(domain))


def digest_of(problem):
    """Of a problem, its domain and its stored plan."""
    texts = [problem.with_name("domain.pddl"), problem, problem.with_suffix(".plan")]
    return hashlib.sha256(b"".join(hashlib.sha256(text.read_bytes()).digest() for text in texts)).hexdigest()[:16]


def judged_by_downward(problem, limits, folder):
    """The columns of a row up to `solution_valid`. The plan that was found is left in `folder`."""
    row = {"task": problem.stem, "of": digest_of(problem)}
    inputs = [problem.with_name("domain.pddl").resolve(), problem.resolve()]
    failed = limits.downward(
        folder, "--translate", *limits.of("translate"), *inputs, "--translate-options", *WITHOUT_INVARIANTS
    )
    row["grounded"] = failed or "yes"
    if failed:
        return row
    task = SasTask(Path(folder) / "output.sas")
    stored = list(actions_of(problem.with_suffix(".plan").read_text()))
    states = task.states(stored)
    valid = len(states) == len(stored) + 1 and holds(task.goal, states[-1])
    spare = [
        f"{left_out}:{stored[left_out].split()[0]}"
        for left_out in range(len(stored) if valid else 0)
        if task.reaches(stored[left_out + 1 :], states[left_out])
    ]
    row["stored_steps"] = len(stored)
    row["stored_valid"] = "yes" if valid else f"no, it stops before step {len(states)}"
    row["steps_not_needed"] = " ".join(spare)
    failed = limits.downward(folder, *limits.of("search"), "--alias", "lama-first", "output.sas")
    plan = Path(folder) / "sas_plan"
    row["solved"] = "yes" if plan.exists() else failed
    if plan.exists():
        found = list(actions_of(plan.read_text()))
        row |= {"solution_steps": len(found), "solution_valid": "yes" if task.reaches(found) else "no"}
    return row


def validated_by_unified_planning(problem, plans):
    """For each plan in a file: whether it reaches the goal, and the numbers of the steps without which it does."""
    validator = SequentialPlanValidator()
    parsed = READER.parse_problem(str(problem.with_name("domain.pddl")), str(problem))

    def accepts(actions):
        return bool(validator.validate(parsed, SequentialPlan(actions, parsed.environment)))

    answers = []
    for plan in plans:
        steps = READER.parse_plan_string(parsed, plan.read_text()).actions
        spare = [at for at in range(len(steps)) if accepts(steps[:at] + steps[at + 1 :])] if plan == plans[0] else []
        answers.append([accepts(steps), spare])
    return answers


def judged_by_unified_planning(problem, limits, found):
    """The columns of unified-planning. `found`: the file of Fast Downward's plan, if there is one."""
    stored = problem.with_suffix(".plan")
    said = limits.validate(problem, [stored, found] if found.exists() else [stored])
    if isinstance(said, str):
        return {"unified_planning": said}
    refused = [name for name, (accepted, _) in zip(("stored", "found"), said, strict=False) if not accepted]
    steps = [step.split()[0] for step in actions_of(stored.read_text())]
    return {
        "unified_planning": ", ".join(f"{name}: no" for name in refused) or "yes",
        "not_needed_by_unified_planning": " ".join(f"{at}:{steps[at]}" for at in said[0][1]),
    }


def judge(problem, limits, by_unified_planning, before):
    """`before`: the row of an earlier call; None where there is none of the same."""
    with tempfile.TemporaryDirectory() as folder:
        row = before or judged_by_downward(problem, limits, folder)
        more = judged_by_unified_planning(problem, limits, Path(folder) / "sas_plan") if by_unified_planning else {}
    return row | more


def needed(row):
    """How many of a plan's steps must be rejected when they are left out, and are."""
    spare = [step for step in row["steps_not_needed"].split() if step.split(":")[1] not in SPARE]
    return int(row["stored_steps"]) - len(row["steps_not_needed"].split()), len(spare)


def is_right(row):
    plans = [row.get(name) or "yes" for name in ("stored_valid", "solution_valid", "unified_planning")]
    same = row["unified_planning"] != "yes" or row["not_needed_by_unified_planning"] == row["steps_not_needed"]
    return row["grounded"] == row["solved"] == "yes" and set(plans) == {"yes"} and needed(row)[1] == 0 and same


def read_rows(out):
    """The last row of each task."""
    if not out.exists():
        return {}
    with out.open(newline="") as file:
        return {row["task"]: dict.fromkeys(COLUMNS, "") | row for row in csv.DictReader(file)}


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", type=Path, help="what `unietp export --format pddl` wrote")
    options.add_argument("out", type=Path, help="a CSV file to write, or to go on with")
    options.add_argument("--each", type=int, default=1, metavar="N", help="unified-planning validates the plans of each N-th (default: 1)")
    options.add_argument("--seconds", type=int, default=300, help="of the processor, for grounding, searching and validating each")
    options.add_argument("--memory", type=int, default=2048, metavar="MIB", help="likewise")
    options.add_argument("--jobs", type=int, default=os.cpu_count(), help="problems at once (default: one for each processor)")
    options = options.parse_args()
    problems = [path for path in options.folder.glob("*/*.pddl") if path.stem != "domain"]
    problems.sort(key=lambda path: hashlib.sha256(path.stem.encode()).digest())
    before = read_rows(options.out)
    with options.out.open("w", newline="") as file:
        rows = csv.DictWriter(file, COLUMNS, restval="", lineterminator="\n")
        rows.writeheader()
        rows.writerows(before.values())
        file.flush()
        left = []
        for number, problem in enumerate(problems):
            row, validated = before.get(problem.stem), number % options.each == 0
            if row is not None and row["of"] != digest_of(problem):
                row = None
            if row is None or (validated and not row["unified_planning"]):
                left.append((problem, validated, row))
        limits = Limits(options.seconds, options.memory)
        with ProcessPoolExecutor(options.jobs, mp_context=FORK) as jobs:
            judged = as_completed([jobs.submit(judge, problem, limits, validated, row) for problem, validated, row in left])
            for number, row in enumerate(judged, len(problems) - len(left) + 1):
                rows.writerow(row.result())
                file.flush()
                print(f"\r{number} of {len(problems)}", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    here = {path.stem for path in problems}
    rows = sorted((row for row in read_rows(options.out).values() if row["task"] in here), key=lambda row: row["task"])
    finish(rows, options.out, summary(rows), is_right)


def summary(rows):
    grounded = [row for row in rows if row["grounded"] == "yes"]
    validated = [row for row in rows if row["unified_planning"]]
    accepted = [row for row in validated if row["unified_planning"] == "yes"]
    spare = Counter(step.split(":")[1] for row in grounded for step in row["steps_not_needed"].split())
    return (
        f"Fast Downward grounds {len(grounded)} of {len(rows)} problems, and solves "
        f"{sum(row['solved'] == 'yes' for row in rows)}\n"
        f"it accepts the stored plan of {sum(row['stored_valid'] == 'yes' for row in grounded)} of {len(grounded)}, and "
        f"refuses {sum(needed(row)[0] for row in grounded)} of {sum(int(row['stored_steps']) for row in grounded)} plans that "
        f"lack a step; the others lack {dict(spare)}\n"
        f"unified-planning accepts the plans of {len(accepted)} of {len(validated)} problems, and refuses "
        f"{sum(int(row['stored_steps']) - len(row['not_needed_by_unified_planning'].split()) for row in accepted)} of "
        f"{sum(int(row['stored_steps']) for row in accepted)} plans that lack a step, the same as Fast Downward in "
        f"{sum(row['not_needed_by_unified_planning'] == row['steps_not_needed'] for row in accepted)}"
    )


if __name__ == "__main__":
    main()
