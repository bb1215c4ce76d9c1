"""Resets and steps a second, memory of further environments, and two threads against one: python steps.py FOLDER.

FOLDER is a data set of homes as large as the figures are to be of. Actions are those of the stored demonstrations of M1,
repeated as long as it takes. Beside them, in the same run, peers that are installed: MiniGrid, TextWorld and the evolving
graph of VirtualHome. One core; run it under `taskset -c 0`, and for two threads without.
"""

import importlib.util
import json
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path

import unietp


def rate(work: Callable[[], int], seconds: float = 3.0) -> float:
    """How often a second; `work` says how much it did."""
    begun, done = time.perf_counter(), 0
    while time.perf_counter() - begun < seconds:
        done += work()
    return done / (time.perf_counter() - begun)


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
    plans = [(i, [json.dumps(step.said()) for step in shown.steps]) for i, shown in enumerate(dataset.demonstrations())]
    env = unietp.make(folder, "M1", picture=False)
    figures: dict[str, float] = {"objects in a home": sum(len(dataset.home(t)["nodes"]) for t in dataset) / len(dataset)}
    for index, _ in plans:
        env.reset(options={"index": index})  # homes and tasks are in memory from here on

    def reset() -> int:
        for index, _ in plans:
            env.reset(options={"index": index})
        return len(plans)

    figures["ms for a reset, home and task in memory"] = 1000 / rate(reset)
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


def minigrid_figures() -> dict[str, float]:
    import gymnasium
    import minigrid  # noqa: F401

    env = gymnasium.make("MiniGrid-FourRooms-v0")
    env.reset(seed=1)

    def step() -> int:
        *_, terminated, truncated, _ = env.step(env.action_space.sample())
        if terminated or truncated:
            env.reset()
        return 1

    return {"MiniGrid FourRooms: steps a second": rate(step), "MiniGrid FourRooms: ms for a reset": 1000 / rate(
        lambda: env.reset() and 1
    )}


def textworld_figures() -> dict[str, float]:
    import tempfile

    import textworld

    options = textworld.GameOptions()
    options.nb_rooms, options.nb_objects, options.seeds = 8, 40, 1
    with tempfile.TemporaryDirectory() as folder:
        options.path = f"{folder}/game.z8"
        file, _ = textworld.make(options)
        env = textworld.start(file)
        env.reset()
        figures = {"TextWorld, 8 rooms, 40 objects: steps a second": rate(lambda: env.step("look") and 1)}
        figures["TextWorld: ms for a reset"] = 1000 / rate(lambda: env.reset() and 1)
        env.close()
    return figures


PEERS = {"minigrid": minigrid_figures, "textworld": textworld_figures}


def main() -> None:
    folder = sys.argv[1]
    figures = own_figures(folder) | batch_figures(folder) | new_task_figures()
    for package, measure in PEERS.items():
        if importlib.util.find_spec(package):
            figures |= measure()
        else:
            print(f"{package} is not installed")
    for name, value in figures.items():
        print(f"{value:12.2f}  {name}")


if __name__ == "__main__":
    main()
