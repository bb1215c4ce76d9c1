"""Resets and steps a second, memory of further environments, and two threads against one: python steps.py FOLDER.

FOLDER is a data set of homes as large as the figures are to be of. Actions are those of the stored demonstrations of M1,
repeated as long as it takes. After them, in the same run, come the other environments of peers.py; `python/venv peers`
makes an environment with their packages. One core; run it under `taskset -c 0`, and for two threads without.
"""

import json
import os
import sys
from collections.abc import Callable
from pathlib import Path

from peers import peers_figures, rate

import unietp


def memory_mb() -> float:
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGESIZE") / 2**20


def played(env: unietp.TaskEnv, plans: list[tuple[int, list[object]]]) -> Callable[[], int]:
    """Acts out one demonstration after the other; counts steps."""
    place = iter(())

    def episodes():
        while True:
            for index, plan in plans:
                env.reset(options={"index": index})
                for said in plan:
                    env.step(said)
                    yield 1

    place = episodes()
    return lambda: next(place)


def own_figures(folder: str) -> dict[str, float]:
    dataset = unietp.load_dataset(folder)
    plans = [(i, [json.dumps(step.command()) for step in shown.steps]) for i, shown in enumerate(dataset.demonstrations())]
    env = unietp.make(folder, "M1", picture=False)
    figures: dict[str, float] = {"objects in a home": sum(len(dataset.home(t)["nodes"]) for t in dataset) / len(dataset)}
    for index, _ in plans:
        env.reset(options={"index": index})  # homes and tasks are in memory from here on

    def resets(some: list[tuple[int, list[object]]]) -> Callable[[], int]:
        return lambda: sum(env.reset(options={"index": index}) is not None for index, _ in some)

    figures["ms for a reset, home in memory"] = 1000 / rate(resets(plans))
    figures["ms for a reset, home and task in memory"] = 1000 / rate(resets(plans[:32]))
    figures["steps a second, boxes, resets included"] = rate(played(env, plans))
    env.reset(options={"index": 0})
    turns = unietp.make(folder, "M1", picture=False, steps=10**6)
    turns.reset(options={"index": 0})
    figures["steps a second, boxes, turning in place"] = rate(lambda: turns.step("turn_left()") and 1)
    pictures = unietp.make(folder, "M1", image_width=300, image_height=300)
    figures["steps a second, boxes and 300 x 300 pictures"] = rate(played(pictures, plans))
    before = memory_mb()
    more = [unietp.make(folder, "M1", picture=False) for _ in range(20)]
    for one in more:
        one.reset(options={"index": 0})
        one.step("turn_left()")
    figures["MB for a further environment of the same home"] = (memory_mb() - before) / len(more)
    return figures


def batch_figures(folder: str) -> dict[str, float]:
    figures = {}
    for threads in (1, 2):
        envs = unietp.make_vec(32, folder, "M1", threads=threads, picture=False)
        envs.reset(seed=1)
        envs.action_space.seed(1)
        batches = [envs.action_space.sample() for _ in range(50)]
        envs.step(batches[0])
        place = iter(range(10**9))
        figures[f"steps a second, batch of 32, {threads} thread(s)"] = rate(
            lambda envs=envs, place=place: envs.step(batches[next(place) % len(batches)]) and envs.num_envs, 5
        )
    one, two = figures.values()
    figures["2 threads / 1 thread"] = two / one
    return figures


def new_task_figures() -> dict[str, float]:
    env = unietp.make(procedural={"homes": 1}, mode="M1", picture=False)
    seeds = iter(range(10**9))

    def reset() -> int:
        env.reset(options={"index": next(seeds)})
        return 1

    for _ in range(40):
        reset()  # each simulator's home is made
    return {"ms for a reset to a new task in a home in memory": 1000 / rate(reset, 6)}


def main() -> None:
    folder = sys.argv[1]
    figures = own_figures(folder) | batch_figures(folder) | new_task_figures()
    own_steps = figures["steps a second, boxes, resets included"]
    peers = peers_figures(folder)
    for name, value in peers.items():
        if "steps a second" in name:
            figures[f"times the steps of {name.split(':')[0]}"] = own_steps / value
    for name, value in (figures | peers).items():
        print(f"{value:12.2f}  {name}")


if __name__ == "__main__":
    main()
