"""Many environments, stepped together by native threads."""

import os
from collections.abc import Sequence
from typing import Any

import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from unietp import _native
from unietp._native import Error
from unietp.spaces import MOST_SEED, EnvironmentSpaces, action_bytes, is_batch
from unietp.task_source import TaskSource


class VectorTaskEnv(VectorEnv[dict[str, np.ndarray], Any, np.ndarray]):
    """Environments of equal settings, each with its own order of the tasks. `unietp.make_vec` makes it.

    Observations are those of `TaskEnv`, stacked; every step's arrays are new. Actions are a batch of the action space,
    or a list with what each agent says. Results equal those of single environments byte for byte, for any number of
    threads. `text(i)`, `prompt(i)` and `observe(i)` are what one agent is told.

    Autoreset mode: next step. The step that ends an episode gives its last observation; the next one ignores the
    environment's action, begins its next episode and gives its first observation with reward 0.
    """

    metadata = {"autoreset_mode": AutoresetMode.NEXT_STEP, "render_modes": []}

    def __init__(self, num_envs: int, source: TaskSource, env_spaces: EnvironmentSpaces, *, threads: int | None = None):
        if num_envs < 1:
            raise Error("expected at least one environment")
        if source.single is not None:
            raise Error("a batch needs the tasks of a data set; give its folder without the id of a task")
        self.num_envs = num_envs
        self.settings, self.categories, self.actions = env_spaces.settings, env_spaces.categories, env_spaces.actions
        self.single_observation_space, self.single_action_space = env_spaces.observation_space, env_spaces.action_space
        self.observation_space = batch_space(env_spaces.observation_space, num_envs)
        self.action_space = batch_space(env_spaces.action_space, num_envs)
        self._env_spaces = env_spaces
        self._native: _native.Batch | None = _native.Batch(
            num_envs, threads or len(os.sched_getaffinity(0)), source.native, env_spaces.text, env_spaces.encoding
        )

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
        """Begins the next episode of each environment.

        Args:
            seed: of the order of the tasks: one number, to which environment i adds i, or one for each.
            options: none are known.
        """
        if options:
            raise Error("a batch has no options of reset")
        seeds: list[int | None] | None = None
        if seed is not None:
            wanted = [seed + i for i in range(self.num_envs)] if isinstance(seed, int) else list(seed)
            if isinstance(seed, int):
                super().reset(seed=seed)
            seeds = [one if one is None else one & MOST_SEED for one in wanted]
        return self._unpacked(self._open_batch().reset(seeds))[:2]

    def step(
        self, actions: Any
    ) -> tuple[dict[str, np.ndarray], np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """One action of each environment, in their order. Returns what `TaskEnv.step` does, in arrays; `info` has
        "task" (ids) and "success" (bool, of the episodes that are over)."""
        if is_batch(actions):
            boxes = actions.get("box", np.zeros((self.num_envs, 4)))
            result = self._open_batch().step_numbers(
                np.ascontiguousarray(actions["action"], np.int64),
                np.ascontiguousarray(actions["argument"], np.int64),
                np.ascontiguousarray(boxes, np.float64),
            )
        else:
            result = self._open_batch().step([action_bytes(action) for action in actions])
        observations, info, rest = self._unpacked(result)
        rewards, terminated, truncated, success = rest
        ended = (terminated | truncated).astype(bool)
        info |= {"success": success.astype(bool), "_success": ended}
        return observations, rewards, terminated.astype(bool), truncated.astype(bool), info

    def observe(self, environment: int) -> dict[str, Any]:
        """The readable observation of one environment, without its picture."""
        return self._open_batch().observe(environment)

    def text(self, environment: int) -> str:
        """The observation of one environment in words."""
        return self._open_batch().text(environment)

    def prompt(self, environment: int) -> str:
        """The system prompt of one environment."""
        return self._open_batch().prompt(environment)

    def ids(self, environment: int) -> list[str]:
        """The id in each row of `things` that is in use by one environment."""
        return self._open_batch().ids(environment)

    def close_extras(self, **_: Any) -> None:
        """Frees the worlds."""
        self._native = None

    def _open_batch(self) -> _native.Batch:
        if self._native is None:
            raise Error("the environments are closed")
        return self._native

    def _unpacked(self, result: tuple) -> tuple[dict[str, np.ndarray], dict[str, Any], list[np.ndarray]]:
        arrays, pictures, *rest = result
        if pictures:
            arrays["image"] = np.stack([self._env_spaces.padded(picture) for picture in pictures])
        if self._env_spaces.channels:
            spaces, seen = self._env_spaces, self._open_batch().channels()
            for name in self._env_spaces.channels:
                arrays[name] = np.stack([spaces.padded(spaces.bounded(name, one[name])) for one in seen])
        ids = np.array([self._open_batch().task_id(i) for i in range(self.num_envs)], dtype=object)
        return arrays, {"task": ids, "_task": np.ones(self.num_envs, bool)}, rest
