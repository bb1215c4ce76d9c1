"""The stored demonstrations, acted out through Python."""

import json
from collections import Counter

import pytest
from conftest import MODES

import unietp


def replay(env, task, steps):
    """Each step's observation before it, what it came to, and the end."""
    _, info = env.reset(options={"task": task})
    for step in steps:
        seen = info["observation"]
        _, reward, terminated, truncated, info = env.step(step.command())
        yield step, seen, env.executed(), reward, terminated or truncated, info


@pytest.mark.parametrize("mode", MODES)
def test_every_demonstration_succeeds_with_the_stored_results(folder, dataset, mode):
    env = unietp.make(folder, mode, picture=False)
    for task, shown in zip(dataset, dataset.demonstrations(mode), strict=True):
        for number, (step, seen, executed, reward, over, info) in enumerate(replay(env, task.id, shown.steps)):
            where = f"{task.id}, {mode}, step {number}"
            assert len(executed) == 1, where
            stored = {"success": step.success, "failure": step.failure, "feedback": step.feedback, "changes": step.changes}
            assert {name: executed[0][name] for name in stored} == stored, where
            if mode != "M3":
                assert [(one["id"], one["box"]) for one in seen["boxes"]] == [
                    (one["id"], one["box"]) for one in step.visible
                ], where
            assert over == (number == len(shown.steps) - 1), where
            assert reward == (1 if over else 0), where
        assert info["success"], task.id


def test_a_plan_without_its_last_deed_fails(folder, dataset):
    env = unietp.make(folder, "M1", picture=False)
    for task, shown in zip(dataset, dataset.demonstrations("M1"), strict=True):
        env.reset(options={"task": task.id})
        _, reward, terminated, _, info = env.step("stop()")
        assert terminated and reward == 0 and not info["success"], task.id
        assert info["observation"]["last"]["success"]  # stop itself did what it does


def act(env, actions):
    """Does all of them, a hundred with each answer, which is as many as it may have."""
    for first in range(0, len(actions), 100):
        _, reward, terminated, truncated, info = env.step(actions[first : first + 100])
        if terminated or truncated:
            break
    return reward, terminated, truncated, info


@pytest.mark.parametrize("mode", MODES)
def test_a_plan_that_lacks_a_step_fails(folder, dataset, mode):
    """Each plan without one of the steps that are neither search nor tidying. In M3 a box may mean another object once a step is left out, so that the rest
    may still succeed; there the reward is the verdict."""
    env = unietp.make(folder, mode, picture=False)
    for task, shown in zip(dataset, dataset.demonstrations(mode), strict=True):
        for left_out in range(len(shown.steps) - 1):
            if shown.steps[left_out].search or shown.steps[left_out].tidying:
                continue
            env.reset(options={"task": task.id})
            rest = [step.command() for number, step in enumerate(shown.steps) if number != left_out]
            reward, _, _, info = act(env, rest)
            assert reward == (1 if info.get("success", False) else 0), (task.id, left_out)
            if mode != "M3":
                assert reward == 0, (task.id, left_out)


def test_altered_plans_are_rewarded_as_the_validator_judges_them(folder, tmp_path):
    """What the validator makes of each demonstration: without a step, with something kept in the hand, in another order,
    with an object that the goal excludes."""
    unietp.validate(folder, altered_plans=tmp_path / "plans.jsonl")
    envs = {mode: unietp.make(folder, mode, picture=False) for mode in MODES}
    tried = Counter()
    with open(tmp_path / "plans.jsonl", encoding="utf-8") as plans:
        for line in plans:
            plan = json.loads(line)
            env = envs[plan["mode"]]
            env.reset(options={"task": plan["task"]})
            reward, terminated, truncated, info = act(env, plan["actions"])
            assert terminated or truncated, line
            assert reward == (1 if plan["reaches_goal"] else 0) == (1 if info["success"] else 0), line
            if plan["change"] not in ("swapped-parts", "reversed-parts"):
                assert reward == 0, line
            tried[plan["change"]] += 1
    print(dict(tried))
    assert {"missing-step", "kept-in-hand", "swapped-parts", "distractor"} <= set(tried)


def test_the_scene_graph_follows_the_stored_changes(folder, dataset):
    env = unietp.make(folder, "M1", picture=False)
    task = dataset[3]
    scenes = dataset.scenes(task)

    def by_id(scene):
        return {node["id"]: node for node in scene["nodes"]}, sorted(map(str, scene["edges"])), scene["agent"]

    env.reset(options={"task": task.id})
    assert by_id(env.scene()) == by_id(next(scenes))
    for step, scene in zip(dataset.demonstration(task).steps, scenes, strict=True):
        env.step(step.command())
        assert by_id(env.scene()) == by_id(scene), step


def test_a_list_of_actions_is_executed_in_turn(folder, dataset):
    env = unietp.make(folder, "M1", picture=False)
    for task, shown in zip(dataset, dataset.demonstrations("M1"), strict=True):
        env.reset(options={"task": task.id})
        _, reward, terminated, _, info = env.step([step.command() for step in shown.steps])
        assert terminated and reward == 1, task.id
        assert len(info["observation"]["results"]) == len(shown.steps)
