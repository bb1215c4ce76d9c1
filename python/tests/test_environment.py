"""unietp.make and Gymnasium's interface."""

import json
import random
import subprocess
import warnings

import gymnasium
import numpy as np
import pytest
from conftest import MODES
from gymnasium.utils.env_checker import check_env

import unietp
from unietp.places import catalog


def first_bytes(observation):
    return {name: array.tobytes() for name, array in observation.items()}


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("picture", [True, False])
def test_gymnasiums_checker_finds_nothing(folder, mode, picture):
    env = gymnasium.make(f"unietp/{mode}-v0", dataset=str(folder), picture=picture, disable_env_checker=True)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped)


def test_make_gives_the_environment_itself(folder):
    env = unietp.make(folder, "M2")
    assert type(env) is unietp.TaskEnv and env.spec.id == "unietp/M2-v0"


@pytest.mark.parametrize("mode", MODES)
def test_random_actions_stay_in_the_spaces(folder, mode):
    env = unietp.make(folder, mode, picture=False)
    env.action_space.seed(3)
    observation, _ = env.reset(seed=3)
    for _ in range(300):
        assert observation in env.observation_space
        observation, _, terminated, truncated, _ = env.step(env.action_space.sample())
        if terminated or truncated:
            assert observation in env.observation_space
            observation, _ = env.reset()


def test_arrays_say_what_the_readable_observation_says(folder, dataset):
    env = unietp.make(folder, "M1", picture=False)
    for task in dataset[:6]:
        env.reset(options={"task": task.id})
        for step in dataset.demonstration(task).steps[:-1]:
            arrays, _, _, _, info = env.step(step.command())
            readable, ids = info["observation"], env.ids()
            known = [*readable["rooms"], *readable["furniture"], *readable["movables"]]
            assert ids[: len(known)] == [thing["id"] for thing in known]
            kinds = [1] * len(readable["rooms"]) + [2] * len(readable["furniture"]) + [3] * len(readable["movables"])
            assert arrays["things"][: len(known), 0].tolist() == kinds
            assert [env.categories[number] for number in arrays["things"][: len(known), 1]] == [
                thing["category"] for thing in known
            ]
            in_view = {one["id"]: one["box"] for one in readable["boxes"]}
            rows = arrays["things"][: len(ids)]
            assert {ids[i]: row[3:].tolist() for i, row in enumerate(rows) if row[2]} == in_view
            assert (arrays["things"][len(ids) :, :3] == 0).all() and (rows[rows[:, 2] == 0][:, 3:] == -1).all()
            assert [ids[row - 1] for row in arrays["held"][:, 0] if row] == [one["id"] for one in readable["held"]]
            assert arrays["counts"].tolist() == [readable[name] for name in ("step", "steps_left", "failures_left")]
            assert env.actions[arrays["last"][0] - 1] == step.action
            assert arrays["last"][1] == (2 if step.success else 1)
            assert bytes(arrays["instruction"]).rstrip(b"\0").decode() == readable["instruction"] == task.instruction


@pytest.mark.parametrize("mode", MODES)
def test_numbers_do_what_names_do(folder, dataset, mode):
    named, numbered = (unietp.make(folder, mode, picture=False) for _ in range(2))
    for task, shown in zip(dataset[:8], dataset.demonstrations(mode)):
        for env in (named, numbered):
            env.reset(options={"task": task.id})
        for step in shown.steps:
            width, height = catalog().image_size(task.simulator)
            action = {"action": named.actions.index(step.action), "argument": 0, "box": np.zeros(4)}
            for arg in step.args:
                if isinstance(arg, str):
                    action["argument"] = numbered.ids().index(arg) + 1
                else:
                    size = np.array([width, height, width, height]) - 1
                    action["box"] = np.array(arg["bbox"]) / size
            one, other = named.step(step.command()), numbered.step(action)
            assert first_bytes(one[0]) == first_bytes(other[0]) and one[1:4] == other[1:4]
            assert named.executed() == numbered.executed()


def test_equal_seeds_give_equal_bytes(folder):
    def run():
        env = unietp.make(folder, "M2")
        observation, _ = env.reset(seed=11)
        env.action_space.seed(5)
        seen = [first_bytes(observation)]
        for _ in range(40):
            observation, _, terminated, truncated, _ = env.step(env.action_space.sample())
            seen.append(first_bytes(observation))
            if terminated or truncated:
                seen.append(first_bytes(env.reset()[0]))
        return seen

    assert run() == run()


def test_a_seed_orders_all_tasks(folder, dataset):
    env = unietp.make(folder, "M1", picture=False)

    def order(seed):
        first = env.reset(seed=seed)[1]["task"]
        return [first] + [env.reset()[1]["task"] for _ in range(len(dataset) - 1)]

    assert sorted(order(1)) == sorted(task.id for task in dataset)
    assert order(1) == order(1) != order(2)
    fresh = unietp.make(folder, "M1", picture=False)
    assert [fresh.reset()[1]["task"] for _ in range(3)] == [task.id for task in dataset[:3]]


def test_tasks_by_id_index_and_path(folder, dataset):
    env = unietp.make(folder, "M1", picture=False)
    assert env.reset(options={"task": dataset[5].id})[1]["task"] == dataset[5].id
    assert env.reset(options={"index": 7})[1]["task"] == dataset[7].id
    one = unietp.make(folder / dataset[9].id, "M1", picture=False)
    assert [one.reset(seed=seed)[1]["task"] for seed in (None, 1, 2)] == [dataset[9].id] * 3
    for options in ({"task": "nobody"}, {"index": 24}, {"index": -1}, {"other": 1}, {"task": 3}):
        with pytest.raises(unietp.Error):
            env.reset(options=options)


def test_new_tasks_without_end(folder):
    wanted = {"simulators": ["habitat"], "splits": ["atomic"], "homes": 1}
    env = unietp.make(procedural=wanted, mode="M1", picture=False)
    instructions = [env.reset(options={"index": seed})[1]["observation"]["instruction"] for seed in (1, 2, 1)]
    assert instructions[0] == instructions[2] and instructions[0] != instructions[1]
    with pytest.raises(unietp.Error, match="simulator"):
        unietp.make(procedural={"simulators": ["nowhere"]})
    with pytest.raises(unietp.Error, match="no option"):
        unietp.make(procedural={"rooms": 3})


def test_snapshots_and_clones(folder, dataset):
    env = unietp.make(folder, "M2", picture=False)
    steps = dataset.demonstration(2, "M2").steps
    env.reset(options={"index": 2})
    for step in steps[: len(steps) // 2]:
        env.step(step.command())
    kept, here = env.snapshot(), env.observe()
    twin = env.clone()
    rest = [env.step(step.command()) for step in steps[len(steps) // 2 :]]
    assert rest[-1][1] == 1
    assert twin.observe() == here
    assert [first_bytes(twin.step(step.command())[0]) for step in steps[len(steps) // 2 :]] == [
        first_bytes(one[0]) for one in rest
    ]
    assert env.restore(kept) == here
    assert env.step(steps[len(steps) // 2].command())[1:4] == rest[0][1:4]


ODD_ACTIONS = [
    "", " ", "pick_up", "pick_up(", "pick_up(nothing_1)", "fly()", "null", "[]", "{}", '{"action":', "\udc80", "\0" * 9,
    b"\xff\xfe", bytearray(b"stopp"), None, 3, -1.5, float("nan"), True, [], {}, object(), {1: 2}, {"action": None},
    {"action": "pick_up", "args": {"a": [1, {"b": "c"}]}}, {"action": "pick_up", "args": ["x"] * 1000}, [[[[]]]],
    {"action": 10**6, "argument": 0}, {"action": 17, "argument": -5}, {"action": 17, "argument": 10**9, "box": [9, 9, 0, 0]},
    {"actions": [{"action_name": "pick up", "args": {"object_id": "mug_99"}}]}, "[" * 5000, "x" * 100_000,
    {"action": 1, "argument": None}, {"action": 1, "argument": "mug_1"}, {"action": 1, "argument": 0, "box": "x"},
    {"action": 1, "argument": 0, "box": [1, 2]}, {"action": 1, "argument": 0, "box": None}, {"action": 1, "argument": [0]},
    {"action": 10**30, "argument": 0}, {"action": 1, "argument": 0.5}, {"action": True, "argument": 0},
    {"action": np.zeros(3, np.int64), "argument": 0}, {"action": 1, "argument": 0, "why": 2},
]


def random_json(rng, depth=3):
    """A JSON value, with names of fields that actions have."""
    kind = rng.randrange(8 if depth else 6)
    if kind == 6:
        return [random_json(rng, depth - 1) for _ in range(rng.randrange(4))]
    if kind == 7:
        names = rng.sample(["action", "args", "argument", "box", "bbox", "actions", "name"], rng.randrange(5))
        return {name: random_json(rng, depth - 1) for name in names}
    return [None, rng.random() < 0.5, rng.randrange(-3, 60), rng.uniform(-1, 600), 10 ** rng.randrange(40), "pick_up"][kind]


@pytest.mark.parametrize("mode", MODES)
def test_random_json_never_raises(folder, mode):
    env = unietp.make(folder, mode, picture=False)
    rng = random.Random(8)
    env.reset(seed=2)
    for _ in range(2000):
        *_, terminated, truncated, _ = env.step(random_json(rng))
        if terminated or truncated:
            env.reset()


def test_a_snapshot_of_other_settings_is_refused(folder):
    env, other = unietp.make(folder, "M3", picture=False), unietp.make(folder, "M1", picture=False)
    env.reset(seed=1)
    other.reset(seed=1)
    with pytest.raises(unietp.Error, match="other settings"):
        env.restore(other.snapshot())
    assert "boxes" not in env.observe()


def test_wrong_arguments_are_errors_of_the_package(folder):
    env = unietp.make(folder, "M1", picture=False)
    for options in (5, [1], "ai2thor-00001", {"index": True}, {"index": -1}, {"task": 3}):
        with pytest.raises(unietp.Error, match="options|no task"):
            env.reset(options=options)
    for count in (0, -1, 2.5, None):
        with pytest.raises(unietp.Error, match="max_things"):
            unietp.make(folder, "M1", max_things=count)
    for wanted in ([], "ai2thor", 3):
        with pytest.raises(unietp.Error, match="procedural"):
            unietp.make(procedural=wanted)
    with pytest.raises(unietp.Error, match="folder"):
        unietp.make(3)


@pytest.mark.parametrize("mode", MODES)
def test_whatever_is_said_is_a_failed_step(folder, mode):
    env = unietp.make(folder, mode, picture=False, failures=200, steps=200)
    env.reset(seed=1)
    for said in ODD_ACTIONS:
        before = env.observe()["failures_left"]
        _, reward, terminated, truncated, info = env.step(said)
        assert info["observation"]["failures_left"] < before, said
        assert not info["observation"]["last"]["success"] and info["observation"]["last"]["feedback"], said
        assert reward == 0 and not terminated and not truncated, said


def test_random_text_never_raises(folder):
    env = unietp.make(folder, "M3", picture=False)
    rng = random.Random(5)
    env.reset(seed=2)
    words = ['{"action":', '"pick_up"', '"args":', "[", "]", "}", ",", '"mug_1"', "go_to(", ")", "1", "0.5", "\n", "```"]
    for _ in range(3000):
        said = "".join(rng.choice(words) for _ in range(rng.randrange(12)))
        if rng.random() < 0.3:
            said = bytes(rng.randrange(256) for _ in range(rng.randrange(40)))
        _, _, terminated, truncated, _ = env.step(said)
        if terminated or truncated:
            env.reset()


def test_a_step_after_the_end_changes_nothing(folder):
    env = unietp.make(folder, "M1", picture=False)
    env.reset(seed=1)
    _, _, terminated, _, _ = env.step("stop()")
    kept = env.observe()
    _, reward, *_ = env.step("move_forward()")
    assert terminated and reward == 0
    assert {**env.observe(), "results": None} == {**kept, "results": None}


def test_settings_are_checked(folder):
    for settings in ({"steps": -1}, {"nonsense": 1}, {"teleport": "moon"}, {"picture": "yes"}, {"feedback": object()}):
        with pytest.raises(unietp.Error):
            unietp.make(folder, **settings)
    with pytest.raises(unietp.Error, match="mode"):
        unietp.make(folder, "M4")
    with pytest.raises(unietp.Error):
        unietp.make(folder / "nowhere" / "x")
    with pytest.raises(unietp.Error):
        unietp.make()
    assert unietp.make(folder, "M2", global_="by_room").settings["global"] == "by_room"


def test_rendering(folder):
    env = unietp.make(folder, "M1", picture=False, render_mode="rgb_array")
    env.reset(seed=1)
    assert env.render().shape == (*env._env_spaces.image_shape[:2], 3) and env.render().any()
    told = unietp.make(folder, "M1", picture=False, render_mode="ansi")
    told.reset(seed=1)
    assert told.render() == told.text()


def test_the_picture_is_that_of_the_camera(folder):
    env = unietp.make(folder, "M3", image_width=64, image_height=48)
    observation, info = env.reset(seed=1)
    assert observation["image"].shape == (48, 64, 3) == env.observation_space["image"].shape
    assert np.array_equal(observation["image"], info["observation"]["image"])


def test_steps_before_reset_are_refused(folder):
    env = unietp.make(folder, "M1")
    for call in (lambda: env.step("stop()"), env.text, env.snapshot):
        with pytest.raises(gymnasium.error.ResetNeeded):
            call()


def test_m2_and_m3_answer_alike_for_what_is_not_and_what_is_not_seen(folder, dataset):
    env = unietp.make(folder, "M2", picture=False)
    known = unietp.make(folder, "M1", picture=False)
    _, info = env.reset(options={"index": 0})
    hidden = {one["id"] for one in known.reset(options={"index": 0})[1]["observation"]["movables"]}
    hidden -= {one["id"] for one in info["observation"]["boxes"]}
    answers = set()
    for name in [sorted(hidden)[0], "mug_999"]:
        last = env.step({"action": "pick_up", "args": [name]})[4]["observation"]["last"]
        answers.add(json.dumps({**last, "action": ""}))
    assert len(answers) == 1


@pytest.mark.parametrize(
    "settings",
    [
        {"mode": "M1", "global": "by_room"},
        {"mode": "M2", "box_form": "thousand_y_first"},
        {"mode": "M3", "boxes": True, "box_form": "unit"},
    ],
)
def test_the_readable_observation_is_what_the_server_tells(folder, dataset, settings):
    """The server's is JSON; of equal tasks, settings and actions both have the same names, order and values."""
    sizes = {"image_width": 32, "image_height": 24}
    env = unietp.make(folder, **{name if name != "global" else "global_": value for name, value in settings.items()}, **sizes)
    serve = [unietp.places.PROGRAM, "serve", folder]
    with subprocess.Popen(serve, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as server:

        def call(method, **params):
            request = {"jsonrpc": "2.0", "id": 1, "method": method, "params": params}
            print(json.dumps(request), file=server.stdin, flush=True)
            return json.loads(server.stdout.readline())["result"]

        call("open", **settings, **sizes)
        for index, shown in enumerate(dataset.demonstrations(settings["mode"])):
            told = [call("reset", index=index)["observation"]]
            seen = [env.reset(options={"index": index})[1]["observation"]]
            for said in ["no_such_action(1)", *[step.command() for step in shown.steps]]:
                told.append(call("step", action=said)["observation"])
                seen.append(env.step(said)[4]["observation"])
            for server_told, one in zip(told, seen, strict=True):
                height, width, _ = one["image"].shape
                assert json.dumps(server_told) == json.dumps(one | {"image": {"width": width, "height": height}})
