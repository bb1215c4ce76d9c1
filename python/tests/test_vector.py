"""unietp.make_vec."""

import gymnasium
import numpy as np
import pytest

import unietp


def batch_bytes(observation, i):
    return {name: array[i].tobytes() for name, array in observation.items()}


def single_bytes(observation):
    return {name: array.tobytes() for name, array in observation.items()}


@pytest.mark.parametrize("threads", [1, 3])
@pytest.mark.parametrize("mode", ["M1", "M3"])
def test_a_batch_equals_single_environments(folder, mode, threads):
    count, settings = 5, {"image_width": 32, "image_height": 32, "failures": 3, "channels": ["depth", "normals"]}
    envs = unietp.make_vec(count, folder, mode, threads=threads, **settings)
    singles = [unietp.make(folder, mode, **settings) for _ in range(count)]
    observation, info = envs.reset(seed=21)
    for i, env in enumerate(singles):
        alone, told = env.reset(seed=21 + i)
        assert batch_bytes(observation, i) == single_bytes(alone) and info["task"][i] == told["task"]
    envs.action_space.seed(4)
    ended = [False] * count
    restarts = 0
    for _ in range(60):
        actions = envs.action_space.sample()
        observation, rewards, terminated, truncated, info = envs.step(actions)
        for i, env in enumerate(singles):
            if ended[i]:  # the step after an end begins the next episode
                alone, told = env.reset()
                expected = (0.0, False, False)
                restarts += 1
            else:
                alone, *rest, told = env.step({name: part[i] for name, part in actions.items()})
                expected = tuple(rest)
            assert batch_bytes(observation, i) == single_bytes(alone)
            assert (rewards[i], terminated[i], truncated[i]) == expected
            assert info["task"][i] == told["task"]
            ended[i] = bool(terminated[i] or truncated[i])
    assert restarts > count


def test_words_are_understood_as_by_single_environments(folder, dataset):
    envs = unietp.make_vec(2, folder, "M2", picture=False)
    envs.reset()  # both play the tasks in the order of the file
    shown = dataset.demonstration(0, "M2").steps
    for step in shown:
        observation, rewards, terminated, _, info = envs.step([step.command(), "move_forward()"])
    assert rewards[0] == 1 and terminated[0] and info["success"][0] and info["_success"][0]
    assert not info["_success"][1] or not info["success"][1]


def test_no_array_is_used_twice(folder):
    envs = unietp.make_vec(2, folder, "M1", image_width=32, image_height=32)
    kept = [envs.reset(seed=1)[0]]
    copies = [{name: array.copy() for name, array in kept[0].items()}]
    for _ in range(4):
        observation = envs.step(envs.action_space.sample())[0]
        kept.append(observation)
        copies.append({name: array.copy() for name, array in observation.items()})
    for one, copy in zip(kept, copies, strict=True):
        assert all(np.array_equal(one[name], copy[name]) for name in copy)
    assert not any(np.shares_memory(a["things"], b["things"]) for a in kept for b in kept if a is not b)


def test_what_gymnasium_wants_to_know(folder):
    envs = gymnasium.make_vec("unietp/M1-v0", 3, vectorization_mode="vector_entry_point", dataset=str(folder), picture=False)
    assert envs.metadata["autoreset_mode"] is gymnasium.vector.AutoresetMode.NEXT_STEP
    observation, _ = envs.reset(seed=[4, None, 5])
    assert observation in envs.observation_space
    observation, *_ = envs.step(envs.action_space.sample())
    assert observation in envs.observation_space
    assert envs.text(1) and envs.prompt(2) and envs.observe(0)["instruction"]
    envs.close()
    with pytest.raises(unietp.Error, match="closed"):
        envs.step(envs.action_space.sample())


def test_wrong_arguments_are_refused(folder, dataset):
    with pytest.raises(unietp.Error):
        unietp.make_vec(0, folder)
    with pytest.raises(unietp.Error):
        unietp.make_vec(2, folder / dataset[0].id)
    envs = unietp.make_vec(2, folder, picture=False)
    with pytest.raises(unietp.Error):
        envs.reset(seed=[1])
    envs.reset()
    with pytest.raises(unietp.Error):
        envs.step(["stop()"])
    with pytest.raises(unietp.Error, match="no environment"):
        envs.text(2)
