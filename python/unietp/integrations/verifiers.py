"""verifiers (0.4, `verifiers.v1`): the tasks of a data set as a taskset, played by a multi-turn environment.

    vf-eval unietp-verifiers --env.taskset.dataset out/first-benchmark --env.taskset.mode M2 -m MODEL -n 10

The agent gets the system prompt and the observations in words, and answers with actions, until the episode is over. Its
reward is 1 for a reached goal, else 0. When the environment itself fails (a missing file, say), the episode has an error
and no reward, so that training leaves it out and does not take it for a failure of the agent.
"""

from collections.abc import Iterator
from typing import Any

import verifiers.v1 as vf
from pydantic import Field
from verifiers.v1.harnesses.null import NullHarnessConfig

import unietp


class UnietpData(vf.TaskData):
    """A task by its place. The home is read when the episode begins."""

    dataset: str
    mode: str
    settings: dict[str, Any]


class UnietpConfig(vf.TasksetConfig):
    """What to play."""

    dataset: str = ""
    """Folder of a data set."""
    mode: str = "M2"
    """M1 or M2. M3 names objects by boxes in a picture, which is not sent here."""
    settings: dict[str, Any] = Field(default_factory=dict)
    """Further settings of `unietp.make`."""


class UnietpTask(vf.Task[UnietpData]):
    """A task of a data set."""

    @property
    def key(self) -> str:
        return f"{self.data.id}@{self.data.mode}"


class UnietpTaskset(vf.Taskset[UnietpTask, UnietpConfig]):
    """The tasks of a data set, in the order of the file."""

    def load(self) -> Iterator[UnietpTask]:
        config = self.config
        for task in unietp.load_dataset(config.dataset):
            yield UnietpTask(
                UnietpData(
                    id=task.id,
                    name=task.id,
                    description=task.instruction,
                    dataset=config.dataset,
                    mode=config.mode,
                    settings={"picture": False, **config.settings},
                ),
                config.task,
            )


class UnietpEnvConfig(vf.EnvConfig):
    """One agent acts. It needs no tools but its answers."""

    player: vf.AgentConfig = vf.AgentConfig(harness=NullHarnessConfig(id="null"), runtime=vf.SubprocessConfig())


class UnietpEnv(vf.Env[UnietpEnvConfig]):
    """Plays an episode: each answer of the agent is a step, and the next observation its next turn."""

    async def run(self, task: UnietpTask, agents: Any) -> None:
        data = task.data
        env = unietp.make(f"{data.dataset}/{data.id}", data.mode, **data.settings)
        env.reset()
        total = 0.0
        # The system prompt lists the home, so it belongs to the episode.
        async with agents.player.interaction(task.with_system_prompt(env.prompt())) as interaction:
            segment = await interaction.turn(env.text())
            while not segment.terminated:
                _, reward, terminated, truncated, _ = env.step(segment.last_reply)
                total += float(reward)
                if terminated or truncated:
                    break
                segment = await interaction.turn(env.text())
        trace = interaction.trace
        if trace.ok:  # an agent that could not answer has an error, and no reward
            trace.record_reward("goal", total)
            verdict = env.privileged()
            trace.record_metrics({name: float(verdict[name]) for name in ("success", "progress", "steps", "failures")})
        env.close()


__all__ = ["UnietpEnv", "UnietpTaskset"]
