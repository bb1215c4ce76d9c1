"""TRL (1.16): an environment for GRPOTrainer, with the actions as a tool and the goal as the reward.

    trainer = GRPOTrainer(
        model=MODEL,
        environment_factory=environment_factory("out/first-benchmark", mode="M2"),
        train_dataset=train_dataset("out/first-benchmark"),
    )
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import unietp

if TYPE_CHECKING:
    import datasets


class UnietpEnvironment:
    """An environment as GRPOTrainer has it: `reset` begins a rollout, `act` is the model's tool, `get_reward` scores."""

    def __init__(self, env: unietp.TaskEnv):
        self._env = env
        self._reward = 0.0
        self._over = False

    def reset(self, task: str | None = None, **_: Any) -> str:
        self._env.reset(options=None if task is None else {"task": task})
        self._reward, self._over = 0.0, False
        return f"{self._env.prompt()}\n\n{self._env.text()}"

    def act(self, action: str, argument: str = "") -> str:
        """
        Perform one action of the list in the instructions.

        Args:
            action: Its name, such as pick_up.
            argument: The id of the object or room, such as mug_1; empty for actions without one.

        Returns:
            What became of it, and what is in view.
        """
        if self._over:
            return "The episode is over."
        command = {"action": action, "args": [argument] if argument else []}
        _, reward, terminated, truncated, _ = self._env.step(command)
        self._reward += float(reward)
        self._over = terminated or truncated
        return "The episode is over." if self._over else self._env.text()

    def get_reward(self) -> float:
        return self._reward


def environment_factory(dataset: str, mode: str = "M2", **settings: Any) -> Callable[[], UnietpEnvironment]:
    """For the argument of this name. `settings`: those of `unietp.make`; the picture is not sent."""
    return lambda: UnietpEnvironment(unietp.make(dataset, mode, **{"picture": False, **settings}))


def train_dataset(dataset: str) -> "datasets.Dataset":
    """A row for each task: an empty prompt, which `reset` completes, and the task's id."""
    import datasets

    rows = [{"prompt": [{"role": "user", "content": ""}], "task": line.id} for line in unietp.load_dataset(dataset)]
    return datasets.Dataset.from_list(rows)


__all__ = ["UnietpEnvironment", "environment_factory", "train_dataset"]
