"""Resets and steps a second of other environments, as far as their packages are installed (requirements-peers.txt).

Each function takes the folder of a data set and gives figures by name. Agents are as simple as can be: what is measured is
the environment. None of the four has physics or a camera of its own here.
"""

import importlib.util
import json
import sys
import tempfile
import time
from collections.abc import Callable
from itertools import cycle
from pathlib import Path

import unietp


def rate(work: Callable[[], int], seconds: float = 3.0) -> float:
    """How often a second; `work` says how much it did."""
    begun, done = time.perf_counter(), 0
    while time.perf_counter() - begun < seconds:
        done += work()
    return done / (time.perf_counter() - begun)


def minigrid_figures(_: str) -> dict[str, float]:
    """A grid of 19 x 19 cells: little more than the overhead of Gymnasium."""
    import gymnasium
    import minigrid  # noqa: F401

    env = gymnasium.make("MiniGrid-FourRooms-v0")
    env.reset(seed=1)

    def step() -> int:
        *_, terminated, truncated, _ = env.step(env.action_space.sample())
        if terminated or truncated:
            env.reset()
        return 1

    resets = rate(lambda: env.reset() is not None)
    return {"MiniGrid FourRooms: steps a second": rate(step), "MiniGrid FourRooms: ms for a reset": 1000 / resets}


def textworld_figures(_: str) -> dict[str, float]:
    """A generated game of 8 rooms and 40 objects; the agent looks."""
    import textworld

    options = textworld.GameOptions()
    options.nb_rooms, options.nb_objects, options.seeds = 8, 40, 1
    with tempfile.TemporaryDirectory() as folder:
        options.path = f"{folder}/game.z8"
        file, _ = textworld.make(options)
        env = textworld.start(file)
        env.reset()
        figures = {"TextWorld, 8 rooms, 40 objects: steps a second": rate(lambda: env.step("look") and 1)}
        figures["TextWorld: ms for a reset"] = 1000 / rate(lambda: env.reset() is not None)
        env.close()
    return figures


def alfworld_problem(cabinets: int, objects: int) -> str:
    """A kitchen in the domain of ALFWorld, in PDDL: cabinets with mugs, and a table that a mug is to be put on."""
    places = [f"Cabinet_{i}" for i in range(cabinets)] + ["DiningTable_0"]
    mugs = [f"Mug_{i}" for i in range(objects)]
    facts = ["(= (total-cost) 0)", "(atLocation agent1 loc_0)", "(canContain CabinetType MugType)"]
    facts += ["(canContain DiningTableType MugType)"]
    for i, place in enumerate(places):
        facts += [f"(receptacleAtLocation {place} loc_{i})", f"(receptacleType {place} {place.split('_')[0]}Type)"]
        facts += [f"(openable {place})"] * place.startswith("Cabinet")
    for i, mug in enumerate(mugs):
        facts += [f"(inReceptacle {mug} {places[i % cabinets]})", f"(objectAtLocation {mug} loc_{i % cabinets})"]
        facts += [f"(objectType {mug} MugType)", f"(pickupable {mug})", f"(heatable {mug})", f"(cleanable {mug})"]
    locations = " ".join(f"loc_{i}" for i in range(len(places)))
    return f"""(define (problem kitchen) (:domain alfred)
      (:objects agent1 - agent {locations} - location {" ".join(places)} - receptacle {" ".join(mugs)} - object
        CabinetType DiningTableType - rtype MugType - otype)
      (:init {" ".join(facts)})
      (:goal (exists (?o - object) (and (objectType ?o MugType) (inReceptacle ?o DiningTable_0))))
      (:metric minimize (total-cost)))"""


def alfworld_figures(_: str) -> dict[str, float]:
    """ALFWorld's domain and texts in TextWorld's engine, with as many things as its rooms have. Its own tasks are a
    download, so the room is made here; the agent walks from place to place."""
    from alfworld import info
    from alfworld.agents.environment.alfred_tw_env import AlfredDemangler
    from textworld import EnvInfos
    from textworld.envs.pddl import PddlEnv

    domain, grammar = (Path(path).read_text() for path in (info.ALFRED_PDDL_PATH, info.ALFRED_TWL2_PATH))
    env = AlfredDemangler(PddlEnv(EnvInfos(admissible_commands=True)))
    env.load({"pddl_domain": domain, "grammar": grammar, "pddl_problem": alfworld_problem(30, 40)})
    state = env.reset()

    def step() -> int:
        nonlocal state, turn
        walks = [said for said in state["admissible_commands"] if said.startswith("go to")]
        turn += 1
        state, *_ = env.step(walks[turn % len(walks)])
        return 1

    turn = 0
    figures = {"ALFWorld's text engine, 71 things: steps a second": rate(step)}
    return figures | {"ALFWorld's text engine: ms for a reset": 1000 / rate(lambda: env.reset() is not None)}


def virtualhome_figures(folder: str) -> dict[str, float]:
    """The evolving graph in a home of the data set; the agent walks from thing to thing and is told what its room
    shows. The package's own start needs Unity, so the modules of the graph are imported without it."""
    package = importlib.util.find_spec("virtualhome").submodule_search_locations[0]
    sys.path.append(f"{package}/simulation")
    from evolving_graph.environment import EnvironmentGraph, EnvironmentState
    from evolving_graph.execution import ScriptExecutor
    from evolving_graph.scripts import read_script_from_list_string
    from evolving_graph.utils import get_visible_nodes

    home = min(Path(folder, "homes").glob("virtualhome-*"))
    with tempfile.TemporaryDirectory() as out:
        unietp.run_program("scene", "export", "virtualhome", str(home), "--out", f"{out}/graph.json")
        graph = json.loads(Path(out, "graph.json").read_text())
    rooms = {node["id"] for node in graph["nodes"] if node["category"] == "Rooms"}
    agent = next(node["id"] for node in graph["nodes"] if node["class_name"] == "character")
    walks = cycle(
        read_script_from_list_string([f"[Walk] <{node['class_name']}> ({node['id']})"])
        for node in graph["nodes"]
        if node["id"] not in rooms | {agent} and node["category"] not in ("Floor", "Walls", "Ceiling", "Floors", "Doors")
    )
    begin = lambda: EnvironmentState(EnvironmentGraph(graph), {}, instance_selection=True)  # noqa: E731
    state, executor, failed = begin(), ScriptExecutor(EnvironmentGraph(graph), {}), 0

    def step() -> int:
        nonlocal state, failed
        done, state = executor.execute_one_step(next(walks), state)
        failed += not done
        get_visible_nodes(state.to_dict(), agent)
        return 1

    name = f"VirtualHome's evolving graph, {len(graph['nodes'])} nodes"
    figures = {f"{name}: steps a second, with what is visible": rate(step)}
    if failed:
        print(f"{name}: {failed} walks failed")
    return figures | {"VirtualHome's evolving graph: ms for a reset": 1000 / rate(lambda: begin() is not None)}


PEERS = {
    "minigrid": minigrid_figures,
    "textworld": textworld_figures,
    "alfworld": alfworld_figures,
    "virtualhome": virtualhome_figures,
}


def peers_figures(folder: str) -> dict[str, float]:
    """Of all that are installed."""
    figures = {}
    for package, measure in PEERS.items():
        if importlib.util.find_spec(package):
            figures |= measure(folder)
        else:
            print(f"{package} is not installed")
    return figures


if __name__ == "__main__":
    for name, value in peers_figures(sys.argv[1]).items():
        print(f"{value:12.2f}  {name}")
