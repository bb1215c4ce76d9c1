"""The tests that judge mutants: which there are, what each costs and which mutants it comes by."""

import contextlib
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

# Tests of the whole program that take longer than this are not counted as fast.
LONGEST_S = 5.0
# Whole programs of end-to-end tests; each TEST in them is counted on its own.
WHOLE = ("data_set_test", "modes_test")
FAILED = re.compile(r"^\[  FAILED  \] (\S+?),? ", re.M)
RUN = re.compile(r"^\[ RUN      \] (\S+)", re.M)
MEMORY = 6 << 30
LARGEST_FILE = 1 << 30


class Workplace:
    """The folders of one worker: temporary files and caches, so that what a mutant writes there ends with it."""

    def __init__(self, folder, caches):
        self.folder = Path(folder)
        self.caches = caches
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.fresh()

    def fresh(self):
        """Nothing temporary, and caches as they were before any mutant."""
        shutil.rmtree(self.folder / "tmp", ignore_errors=True)
        (self.folder / "tmp").mkdir()
        own = self.folder / "caches"
        if not own.is_dir() or stamps(own) != stamps(self.caches):
            shutil.rmtree(own, ignore_errors=True)
            shutil.copytree(self.caches, own)

    def environment(self, **more):
        kept = {name: value for name, value in os.environ.items() if not name.startswith("UNIETP_")}
        return kept | {"TMPDIR": str(self.folder / "tmp"), "XDG_CACHE_HOME": str(self.folder / "caches"),
                       "UNIETP_TEST_CACHE": str(self.folder / "caches/tests")} | more


def stamps(folder):
    return {path.relative_to(folder): (path.stat().st_size, path.stat().st_mtime_ns)
            for path in folder.rglob("*") if path.is_file()}


def run(command, workplace, seconds, **environment):
    """(exit code, output, processor seconds, whether it was stopped). `seconds` of processor time for each process, and
    twenty times as much of the clock, since the machine may be busy."""
    limits = ["prlimit", f"--cpu={int(seconds) + 1}:{int(seconds) + 2}", f"--as={MEMORY}", f"--fsize={LARGEST_FILE}",
              "--core=0"]
    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen(limits + command, cwd=workplace.folder, env=workplace.environment(**environment),
                                   stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                                   start_new_session=True)
        alarm = threading.Timer(20 * seconds + 60, os.killpg, (process.pid, signal.SIGKILL))
        alarm.start()
        _, status, usage = os.wait4(process.pid, 0)
        alarm.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)  # what it started and left running
        output.seek(0)
        text = output.read().decode("utf-8", "replace")
    stopped = process.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
    return process.returncode, text, usage.ru_utime + usage.ru_stime, stopped


def listed(build, rooms):
    """All tests that may judge: (name, room or "", program, TEST)."""
    shown = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True,
                           text=True)
    tests = []
    for test in json.loads(shown.stdout)["tests"]:
        command = test.get("command")
        if not command:
            continue
        labels = next((one["value"] for one in test["properties"] if one["name"] == "LABELS"), [])
        program = Path(command[0])
        chosen = next((word.split("=", 1)[1] for word in command if word.startswith("--gtest_filter=")), None)
        room = program.parent.name
        end_to_end = room == "end_to_end"
        if room == "house":
            continue
        if chosen is not None and (end_to_end or "fast" in labels):
            tests += [(f"{test['name'].split('.')[0]}.{name}", room if room in rooms else "", str(program), name)
                      for name in tests_in(program, chosen)]
        elif end_to_end and program.name in WHOLE:
            tests += [(f"{test['name']}.{name}", "", str(program), name) for name in tests_in(program)]
    return tests


def tests_in(program, chosen="*"):
    out = subprocess.run([program, "--gtest_list_tests", f"--gtest_filter={chosen}"], check=True, capture_output=True,
                         text=True).stdout
    names, suite = [], ""
    for line in out.splitlines():
        word = line.split("#")[0].rstrip()
        if word.startswith("  "):
            names.append(suite + word.strip())
        elif word.endswith("."):
            suite = word
    return names


def measure(build, rooms, folder, workers):
    """Runs every test once, nothing switched on. A list of {name, room, program, test, seconds, reached, passed}."""
    caches = folder / "caches"
    caches.mkdir(parents=True, exist_ok=True)
    tests = listed(build, rooms)
    places = [Workplace(folder / f"worker{number}", caches) for number in range(workers)]
    free = list(places)

    def one(test):
        name, room, program, chosen = test
        place = free.pop()
        reach = place.folder / "reach"
        reach.unlink(missing_ok=True)
        code, output, seconds, stopped = run([program, f"--gtest_filter={chosen}"], place, 60,
                                             UNIETP_MUTANT_REACH=str(reach))
        reached = sorted({int(line) for line in reach.read_text().split()}) if reach.is_file() else []
        free.append(place)
        passed = code == 0 and not stopped and "[  SKIPPED ]" not in output and " 1 test " in output
        return {"name": name, "room": room, "program": program, "test": chosen, "seconds": round(seconds, 3),
                "reached": reached, "passed": passed}

    with ThreadPoolExecutor(workers) as pool:
        found = list(pool.map(one, tests))
    for place in places:
        shutil.copytree(place.folder / "caches", caches, dirs_exist_ok=True)
    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(lambda some: leave_out_failures(some, free), by_program(found).values()))
    return found


def counts(test):
    """Whether a test may judge: it passes with nothing switched on, and it is fast if it runs the whole program."""
    return test["passed"] and (test["room"] != "" or test["seconds"] <= LONGEST_S)


def by_program(tests):
    programs = {}
    for test in tests:
        if counts(test):
            programs.setdefault(test["program"], []).append(test)
    return programs


def leave_out_failures(tests, free):
    """Mutants meet many tests in one process; those that fail there with nothing switched on must not judge."""
    place = free.pop()
    place.fresh()
    left = {test["test"]: test for test in tests}
    while left:
        command = [tests[0]["program"], "--gtest_filter=" + ":".join(left)]
        code, output, _, _ = run(command, place, 30 + 4 * sum(test["seconds"] for test in left.values()))
        if code == 0:
            break
        failed = FAILED.findall(output) or RUN.findall(output)[-1:]
        if not set(failed) & set(left):
            raise RuntimeError(f"{tests[0]['program']} fails with nothing switched on: {output[-2000:]}")
        for name in failed:
            if name in left:
                left.pop(name)["passed"] = False
    free.append(place)
