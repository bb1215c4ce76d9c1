"""Acting in Habitat: the backend of `unietp evaluate` with a scene and functions of a few lines. checks/judges runs it with
habitat-lab's own functions, and a stand-in for habitat-sim that answers rays."""

import gzip
import json
from types import SimpleNamespace

import act_habitat
import pytest
from acting import Facts
from stand_ins.placed_agent import Agent

MUG, BOX, TABLE, CABINET = 1, 2, 3, 4
DRAWER = 5  # a link of the cabinet
REGION = {"name": "kitchen_1", "poly_loop": [[0, 0, 0], [4, 0, 0], [4, 0, -4], [0, 0, -4]]}
OTHER = {"name": "hall_1", "poly_loop": [[4, 0, 0], [8, 0, 0], [8, 0, -4], [4, 0, -4]]}


class Matrix:
    """Poses here are places alone."""

    def __init__(self, at):
        self.translation = list(at)

    @classmethod
    def from_(cls, turn, at):
        return cls(at)

    def rotation(self):
        return None

    def inverted(self):
        return Matrix([-one for one in self.translation])

    def __matmul__(self, other):
        return Matrix([a + b for a, b in zip(self.translation, other.translation, strict=True)])


MAGNUM = SimpleNamespace(
    Matrix4=type("Matrix4", (Matrix,), {"__init__": lambda self, columns: Matrix.__init__(self, columns[3][:3]), "from_": Matrix.from_}),
    Vector3=lambda *at: list(at),
    Quaternion=lambda vector, scalar: SimpleNamespace(to_matrix=lambda: None),
)


class Rigid:
    def __init__(self, number, at, motion="STATIC"):
        self.object_id, self.transformation, self.motion_type = number, Matrix(at), motion


class Cabinet(Rigid):
    link_object_ids, fixed_base = {DRAWER: 0}, True

    def __init__(self, number, at):
        super().__init__(number, at)
        self.joint_positions = [0.0]

    def get_link_ids(self):
        return [0]

    def get_link_joint_type(self, link):
        return "Prismatic"

    def get_link_joint_pos_offset(self, link):
        return link

    def get_link_scene_node(self, link):
        return SimpleNamespace(absolute_transformation=lambda: Matrix([0, 0, self.joint_positions[0]]))


class Simulator:
    def __init__(self, configuration):
        self.scene = configuration[0]
        self.furniture = {"table_:0000": Rigid(TABLE, [1, 0.4, -1]), "cabinet_:0000": Cabinet(CABINET, [3, 0.4, -1])}
        self.agent, self.added, self.closed = Agent(), [], 0

    def close(self):
        self.closed += 1

    def reconfigure(self, configuration):
        closed = self.closed
        self.__init__(configuration)
        self.closed = closed

    def get_agent(self, number):
        return self.agent

    def get_object_template_manager(self):
        files = ["x/objects/mug.object_config.json", "x/objects/big_mug.object_config.json", "x/objects/box.object_config.json"]
        return SimpleNamespace(load_configs=lambda path: None, get_template_handles=lambda part: [one for one in files if part in one])

    def get_rigid_object_manager(self):
        def add(template):
            assert "big" not in template
            self.added.append(Rigid(MUG if "mug" in template else BOX, [0, 0, 0], "DYNAMIC"))
            return self.added[-1]

        return SimpleNamespace(add_object_by_template_handle=add)

    def things(self):
        return [*self.added, *self.furniture.values()]


def below(simulator, thing):
    """The ids of what is under a thing, the nearest first: what is at its place and lower; at last the floor."""
    x, y, _ = thing.transformation.translation
    places = {one.object_id: one.transformation.translation for one in simulator.things() if one is not thing}
    under = [one for one, at in places.items() if at[0] == x and at[1] < y]
    return [*sorted(under, key=lambda one: -places[one][1]), 0]


def keypoint_cast(simulator, thing):
    _, y, _ = thing.transformation.translation
    hits = [SimpleNamespace(object_id=one, point=[0, y - 0.01, 0]) for one in below(simulator, thing)]
    return [SimpleNamespace(ray=SimpleNamespace(origin=[0, y, 0]), hits=hits)]


def snap_down(simulator, thing, supports, ignored):
    first = next(one for one in below(simulator, thing) if one not in ignored)
    if first in supports:
        thing.transformation = Matrix([0, -0.001, 0]) @ thing.transformation
    return first in supports


def set_joint(thing, link, share):
    thing.joint_positions = [0.5 * share]


UTILITIES = SimpleNamespace(
    get_obj_from_handle=lambda simulator, handle: simulator.furniture.get(handle),
    within=lambda simulator, thing: [CABINET, DRAWER] if below(simulator, thing)[0] == CABINET else [TABLE],
    object_keypoint_cast=keypoint_cast,
    snap_down=snap_down,
    set_link_normalized_joint_position=set_joint,
    link_is_open=lambda thing, link: thing.joint_positions[link] >= 0.2,
)
HABITAT = SimpleNamespace(
    sim=SimpleNamespace(
        SimulatorConfiguration=SimpleNamespace,
        Configuration=lambda settings, agents: (settings, agents),
        Simulator=Simulator,
        agent=SimpleNamespace(AgentConfiguration=lambda sensor_specifications: None),
        physics=SimpleNamespace(
            MotionType=SimpleNamespace(STATIC="STATIC", KINEMATIC="KINEMATIC"),
            JointType=SimpleNamespace(Revolute="Revolute", Prismatic="Prismatic"),
        ),
        utils=SimpleNamespace(common=SimpleNamespace(quat_from_angle_axis=lambda angle, axis: angle)),
        stage_id=0,
    ),
    mn=MAGNUM,
    utilities=UTILITIES,
    array=list,
)
START = Facts(
    {"mug_1": ["clean"], "box_1": [], "table_1": [], "cabinet_1": ["closed"]},
    {("on", "mug_1", "table_1"), ("in_room", "mug_1", "kitchen_1"), ("inside", "box_1", "cabinet_1"), ("in_room", "box_1", "kitchen_1"),
     ("in_room", "agent", "hall_1")},
)  # fmt: skip


def rows(at):
    return [[1, 0, 0, at[0]], [0, 1, 0, at[1]], [0, 0, 1, at[2]], [0, 0, 0, 1]]


@pytest.fixture
def folder(tmp_path):
    names = {"mug_1": "mug_:0000", "box_1": "box_:0000", "table_1": "table_:0000", "cabinet_1": "cabinet_:0000"}
    episode = {
        "episode_id": "task", "scene_id": "data/unietp/scenes/task.scene_instance.json",
        "scene_dataset_config": "data/unietp/unietp.scene_dataset_config.json", "additional_obj_config_paths": ["data/unietp/objects"],
        "start_position": [6, 0, -1],
        "rigid_objs": [["mug.object_config.json", rows([1, 0.9, -1])], ["box.object_config.json", rows([3, 0.9, -1])]],
        "ao_states": {}, "info": {"unietp": {"names": names}},
    }  # fmt: skip
    (tmp_path / "episodes.json.gz").write_bytes(gzip.compress(json.dumps({"episodes": [episode]}).encode()))
    (tmp_path / "scenes").mkdir()
    (tmp_path / "scenes" / "task.scene_instance.json").write_text(json.dumps({"user_defined": {"regions": [REGION, OTHER]}}))
    act_habitat.episodes_of.cache_clear()
    return tmp_path


@pytest.fixture
def episode(folder):
    return act_habitat.Episode(folder, "task", Facts(dict(START.states), set(START.edges)), HABITAT)


def put_at(name, *at):
    return {"id": name, "position": list(at), "rotation": [1, 0, 0, 0]}


def test_the_first_answer_tells_what_the_start_differs_in(folder):
    wrong = Facts(dict(START.states), START.edges - {("on", "mug_1", "table_1")})
    answer = act_habitat.Episode(folder, "task", wrong, HABITAT).act("look_up", [], {})
    assert answer["edges_added"] == [("on", "mug_1", "table_1")] and answer["edges_removed"] == []


def test_what_is_picked_up_is_held_and_then_rests_where_it_was_put(episode):
    agent = {"agent": {"position": [2, 1], "yaw_rad": 0.0}}
    answer = episode.act("go_to", ["mug_1"], agent)
    assert answer["edges_added"] == [("in_room", "agent", "kitchen_1")]
    answer = episode.act("pick_up", ["mug_1"], agent)
    assert answer["held"] == ["mug_1"]
    assert answer["edges_removed"] == [("in_room", "mug_1", "kitchen_1"), ("on", "mug_1", "table_1")]
    assert episode.objects["mug_1"].transformation.translation == [2, act_habitat.HAND_M, -1]
    answer = episode.act("place_on", ["cabinet_1"], {"nodes": [put_at("mug_1", 3, 1, 0.85)]})
    assert answer["success"] and answer["held"] == []
    assert ("inside", "mug_1", "cabinet_1") in answer["edges_added"], "as Habitat says"


def test_what_finds_no_support_stays_in_the_hand(episode):
    episode.act("pick_up", ["mug_1"], {})
    held = episode.objects["mug_1"].transformation
    answer = episode.act("place_on", ["table_1"], {"nodes": [put_at("mug_1", 2, 1, 0.9)]})
    assert not answer["success"] and "nothing below mug_1" in answer["message"]
    assert episode.objects["mug_1"].transformation is held and episode.held == ["mug_1"]
    assert episode.act("drop", [], {"nodes": [put_at("mug_1", 2, 1, 0.1)]})["edges_added"] == [
        ("in_room", "mug_1", "kitchen_1"), ("on_floor", "mug_1", "kitchen_1")
    ]  # fmt: skip


def test_what_is_in_a_drawer_goes_with_it(episode):
    episode.act("look_up", [], {})
    answer = episode.act("open", ["cabinet_1"], {"nodes": [{"id": "cabinet_1", "opening": 1.0}]})
    assert answer["states"] == {"cabinet_1": ["open"]}
    assert episode.objects["box_1"].transformation.translation == [3, 0.9, -0.5]
    answer = episode.act("close", ["cabinet_1"], {"nodes": [{"id": "cabinet_1", "opening": 0.0}]})
    assert answer["states"] == {"cabinet_1": ["closed"]}
    assert episode.objects["box_1"].transformation.translation == [3, 0.9, -1.0]


def test_what_lies_on_a_thing_is_carried_with_it(folder):
    edges = {("on", "mug_1", "box_1"), ("inside", "box_1", "cabinet_1")}
    episode = act_habitat.Episode(folder, "task", Facts(dict(START.states), edges), HABITAT)
    episode.act("pick_up", ["box_1"], {"agent": {"position": [2, 1], "yaw_rad": 0.0}})
    assert episode.objects["box_1"].transformation.translation == [2, act_habitat.HAND_M, -1]
    mug = episode.objects["mug_1"].transformation.translation
    assert mug == pytest.approx([0, act_habitat.HAND_M, -1]), "as far from the box as before"


def test_what_habitat_has_not_is_refused(episode):
    assert episode.act("turn_on", ["cabinet_1"], {})["message"] == "Habitat has no turn_on"
    assert episode.act("open", ["door_9"], {})["message"] == "Habitat has no door_9"
    assert "has no joints" in episode.act("open", ["table_1"], {})["message"]
    assert "cannot be moved" in episode.act("pick_up", ["table_1"], {})["message"]
    assert episode.act("place_on", ["table_1"], {})["message"] == "the hand is empty"
    assert not episode.act("go_to", ["door_9"], {})["success"]


def test_the_next_episode_is_loaded_into_the_same_simulator(folder):
    begin = act_habitat.make(lambda: HABITAT)
    start = {"states": START.states, "edges": [list(edge) for edge in START.edges], "held": []}
    params = {"task": "task", "folder": str(folder), "rooms": [], "start": start}
    first = begin(params)
    second = begin(params)
    assert second.sim is first.sim and second.sim.closed == 1
    assert second.sim.scene.scene_id.endswith("scenes/task.scene_instance.json") and second.sim.scene.scene_id.startswith(str(folder))


def test_without_habitat_it_says_what_to_install():
    with pytest.raises(RuntimeError, match="habitat-sim"):
        act_habitat.start_habitat()
