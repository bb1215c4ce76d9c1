"""Switches mutants on one at a time and runs the tests that come by them, those of the mutant's own room first."""

import json
import threading
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor

import suite

BUSY = {"llm_tests", "annotate_tests", "complete_tests", "report_tests", "run_commands_tests"}


def plan(mutant, tests):
    """[(program, TESTs, seconds)] in the order to run: the room's own, then cheap ones first."""
    by_program = defaultdict(list)
    for test in tests:
        if mutant.id in test["reached"]:
            by_program[test["room"] != mutant.room, test["room"] == "", test["program"]].append(test)
    runs = [(far, whole, sum(test["seconds"] for test in some), program, [test["test"] for test in some])
            for (far, whole, program), some in by_program.items()]
    return [(program, names, seconds) for _, _, seconds, program, names in sorted(runs)]


def judged(mutant, tests, place):
    """The verdict and the test that caught the mutant. Verdicts: caught (a test fails), crashed, hung (no end within
    several times the usual processor time), survived, not reached (no fast test comes by)."""
    runs = plan(mutant, tests)
    if not runs:
        return {"verdict": "not reached", "by": ""}
    for program, names, seconds in runs:
        found = tried(mutant, program, names, seconds, place)
        # What talks to other processes may fail on a busy machine, so it has to fail twice.
        if found is not None and program.rsplit("/", 1)[1] in BUSY:
            found = tried(mutant, program, names, seconds, place)
        if found is not None:
            return found
    return {"verdict": "survived", "by": ""}


def tried(mutant, program, names, seconds, place):
    place.fresh()
    command = [program, "--gtest_filter=" + ":".join(names), "--gtest_fail_fast"]
    code, output, _, stopped = suite.run(command, place, 10 + 4 * seconds, UNIETP_MUTANT=str(mutant.id))
    if code == 0 and not stopped:
        return None
    failed, begun = suite.FAILED.findall(output), suite.RUN.findall(output)
    verdict = "hung" if stopped else "caught" if failed else "crashed"
    test = (failed or begun[-1:] or ["before its first test"])[0]
    return {"verdict": verdict, "by": f"{program.rsplit('/', 1)[1]}: {test}"}


def judge(mutants, tests, results, folder, workers):
    """Judges the mutants that the file `results` does not yet hold and appends a line for each, so that a run that was
    stopped goes on."""
    tests = [dict(test, reached=frozenset(test["reached"])) for test in tests if suite.counts(test)]
    done = {json.loads(line)["id"] for line in results.read_text().splitlines()} if results.is_file() else set()
    lock = threading.Lock()
    free = [suite.Workplace(folder / f"worker{number}", folder / "caches") for number in range(workers)]

    def one(mutant):
        place = free.pop()
        line = {"id": mutant.id, "room": mutant.room, "file": mutant.file, "line": mutant.line, "kind": mutant.kind,
                "original": mutant.original, "mutated": mutant.mutated} | judged(mutant, tests, place)
        free.append(place)
        with lock, results.open("a") as file:
            file.write(json.dumps(line, ensure_ascii=False) + "\n")
        print(f"{line['id']} {line['file']}:{line['line']} {line['kind']}: {line['verdict']} {line['by']}", flush=True)

    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(one, [mutant for mutant in mutants if mutant.id not in done]))

