"""The environment of one agent."""

from typing import Any, SupportsFloat, cast

import gymnasium
import numpy as np

from unietp import _native
from unietp._native import Error
from unietp.spaces import MOST_SEED, EnvironmentSpaces, action_bytes, numbered
from unietp.task_source import TaskSource

Snapshot = _native.Snapshot
CAMERAS = ("agent", "behind", "above")


class TaskEnv(gymnasium.Env[dict[str, np.ndarray], Any]):
    """Tasks to act in, for one agent. `unietp.make` and `gymnasium.make("unietp/M1-v0", dataset=...)` make it.

    An observation is a dict of arrays of fixed sizes (`observation_space`; docs/python.md). The same in a form to read
    is `info["observation"]`: instruction, image, boxes, rooms, furniture, movables, last, held, step, steps_left,
    failures_left, as far as the settings tell of them. `text()` is it in words, `prompt()` the system prompt.

    An action is a dict of the action space, or what a language model says: text or JSON like
    `{"action": "pick_up", "args": ["mug_1"]}`, a list of several, or the released runner's form. What cannot be read or
    is not allowed is a failed step with a reason, never an exception.

    Deterministic: equal tasks, settings and actions give equal bytes on every x86-64 processor. Several threads may call one
    environment, one after the other; native work runs without the interpreter's lock.
    """

    metadata = {"render_modes": ["rgb_array", "ansi"], "render_fps": 4}

    def __init__(
        self,
        source: TaskSource,
        env_spaces: EnvironmentSpaces,
        *,
        render_mode: str | None = None,
        render_camera: str = "agent",
        privileged: bool = False,
    ):
        if render_camera not in CAMERAS:
            raise Error(f"no camera is named {render_camera!r}; accepted are {', '.join(CAMERAS)}")
        if render_mode is not None and render_mode not in self.metadata["render_modes"]:
            raise Error(f"no render_mode is named {render_mode!r}; accepted are {self.metadata['render_modes']}")
        self.render_mode = render_mode
        self.render_camera = render_camera
        self.settings = env_spaces.settings  #: all settings by name
        self.observation_space = cast("gymnasium.Space[dict[str, np.ndarray]]", env_spaces.observation_space)
        self.action_space = env_spaces.action_space
        self.categories = env_spaces.categories  #: category or room type by its number in arrays
        self.actions = env_spaces.actions  #: action by its number
        self._source, self._env_spaces, self._privileged = source, env_spaces, privileged
        self._seed: int | None = None
        self._episode = 0
        self._native: _native.Environment | None = None

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
        """Begins the next episode in a new world.

        Args:
            seed: begins an order of the tasks that depends on the seed only. Without one ever: the order of the file.
            options: `{"task": ID}` or `{"index": POSITION}` for a certain task; of new tasks the index is the seed.

        Raises:
            Error: there is no such task, or its files are wrong.
        """
        super().reset(seed=seed)
        if seed is not None:
            self._seed, self._episode = seed & MOST_SEED, 0
        if options:
            task = self._source.task(options)
        else:
            task = self._source.task_of_episode(self._seed, self._episode)
            self._episode += 1
        if self._native is None:
            self._native = _native.Environment(task, self._env_spaces.text, self._env_spaces.encoding)
            return self._unpacked(self._native.observe())
        return self._unpacked(self._native.reset(task))

    def step(
        self, action: Any
    ) -> tuple[dict[str, np.ndarray], SupportsFloat, bool, bool, dict[str, Any]]:
        """Executes an action, or a list of them one after the other.

        Returns:
            Observation; reward (1 at the end of an episode that reached the goal, else 0, unless
            `reward="progress"`); terminated (by `stop` or too many failures); truncated (by the limit of steps); info
            with "task" and "observation", and at the end "success". After the end nothing happens.
        """
        native = self._started()
        if (numbers := numbered(action)) is not None:
            seen, reward, terminated, truncated = native.step_numbers(*numbers)
        else:
            seen, reward, terminated, truncated = native.step(action_bytes(action))
        observation, info = self._unpacked(seen)
        if terminated or truncated:
            info["success"] = native.privileged()["success"]
        return observation, reward, terminated, truncated, info

    def render(self) -> Any:
        """The picture (uint8, height × width × 3) or the text, as `render_mode` says; None without one. `render_camera`
        says what takes the picture."""
        if self.render_mode == "rgb_array":
            return self._started().render(*self._size(None), self.render_camera)
        return self.text() if self.render_mode == "ansi" else None

    def close(self) -> None:
        """Frees the world. The tasks stay in memory for other environments."""
        self._native = None

    def observe(self) -> dict[str, Any]:
        """The present observation in the form to read."""
        return self._unpacked(self._started().observe())[1]["observation"]

    def text(self) -> str:
        """The present observation in words, as a user's turn of a chat. The picture is sent beside it."""
        return self._started().text()

    def prompt(self, reasoning: bool = False) -> str:
        """The system prompt of this episode: actions, rules, and what is known of the home. The same as in exports for
        fine-tuning. `reasoning`: asks for a rationale with each answer."""
        return self._started().prompt(reasoning)

    def ids(self) -> list[str]:
        """The id in each row of `things` that is in use; row `n` is the argument `n + 1`."""
        return self._started().ids()

    def snapshot(self) -> Snapshot:
        """The present state, to come back to. Several environments of equal settings may restore it."""
        return self._started().snapshot()

    def restore(self, snapshot: Snapshot) -> dict[str, Any]:
        """Goes to a snapshot, with its task. Returns the observation there, in the form to read. Raises Error for a snapshot
        of an environment with other settings."""
        if self._native is None:
            self.reset()
        self._started().restore(snapshot)
        return self.observe()

    def clone(self) -> "TaskEnv":
        """An independent copy at the same state."""
        other = TaskEnv(
            self._source, self._env_spaces, render_mode=self.render_mode, render_camera=self.render_camera,
            privileged=self._privileged,
        )
        other._seed, other._episode = self._seed, self._episode
        other._native = _native.Environment(self._started().task, self._env_spaces.text, self._env_spaces.encoding)
        other._native.restore(self.snapshot())
        return other

    # What the agent must not know.

    def privileged(self) -> dict[str, Any]:
        """success (would the goal hold if the episode ended now), hopeless, progress, missing, goal, steps, failures,
        ended_by."""
        return self._started().privileged()

    def executed(self) -> list[dict[str, Any]]:
        """What the last step's actions came to and changed, as in demonstrations/<mode>.jsonl."""
        return self._started().executed()

    def channels(self, camera: str = "agent", size: tuple[int, int] | None = None) -> dict[str, Any]:
        """What a camera sees, as numbers for each pixel.

        Args:
            camera: "agent"; "behind", which follows the agent; or "above", which shows the whole home. The last two show
                the agent too.
            size: width and height in pixels, 16 to 4096; by default those of `render`.

        Returns:
            "color" uint8 (height, width, 3); "depth" float32 (height, width), meters along the view direction, infinite
            where nothing is; "normals" float32 (height, width, 3), unit vectors of the surface in the camera's frame (x
            right, y down, z ahead), 0 where nothing is; "instances" int32 (height, width), positions in "ids"; "ids",
            whose first is "" (walls, floor, ceiling) and whose last is "agent" where it is shown. All but the color are
            of the nearest surface, glass included, and leave out what the agent's own camera shows in its hands.

        Raises:
            Error: there is no such camera, or the size is out of range.
        """
        width, height = self._size(size)
        native = self._started()
        return {"color": native.render(width, height, camera), **native.channels(width, height, camera)}

    def scene(self) -> dict[str, Any]:
        """The scene graph with all relations."""
        return self._started().scene()

    def expert_steps_left(self) -> int | None:
        """Actions of M1 that the expert's plan from here has, `stop` included; None when it finds no plan."""
        return self._started().expert_steps_left()

    def _size(self, size: tuple[int, int] | None) -> tuple[int, int]:
        height, width, _ = self._env_spaces.image_shape
        return (width, height) if size is None else size

    def _started(self) -> _native.Environment:
        if self._native is None:
            raise gymnasium.error.ResetNeeded("call reset first")
        return self._native

    def _unpacked(
        self, result: tuple[dict[str, np.ndarray], dict[str, Any], np.ndarray | None]
    ) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
        arrays, readable, picture = result
        if picture is not None:
            readable["image"] = picture
            arrays["image"] = self._env_spaces.padded(picture)
        native = self._started()
        if self._env_spaces.channels:
            seen = native.channels(0, 0)
            for name in self._env_spaces.channels:
                readable[name] = self._env_spaces.bounded(name, seen[name])
                arrays[name] = self._env_spaces.padded(readable[name])
        info: dict[str, Any] = {"task": native.task.id, "observation": readable}
        if self._privileged:
            info["privileged"] = native.privileged()
        return arrays, info
