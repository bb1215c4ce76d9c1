"""Inspect AI (0.3): the tasks of a data set as an evaluation, in which the model acts by calling a tool.

    inspect eval unietp.integrations.inspect -T dataset=out/first-benchmark -T mode=M2 --model MODEL

The score is 1 for a reached goal, else 0. When the environment itself fails, the sample has an error and no score.
"""

from typing import Any

from inspect_ai import Task, task
from inspect_ai.dataset import MemoryDataset, Sample
from inspect_ai.model import ChatMessageSystem, ChatMessageUser, execute_tools, get_model
from inspect_ai.scorer import Score, Scorer, Target, accuracy, scorer, stderr
from inspect_ai.solver import Generate, Solver, TaskState, solver
from inspect_ai.tool import Tool, tool
from inspect_ai.util import store

import unietp


@task
def unietp_tasks(dataset: str, mode: str = "M2", **settings: Any) -> Task:
    """All tasks of a data set. `settings`: those of `unietp.make`; the picture is not sent."""
    samples = [
        Sample(input=line.instruction, target="1", id=line.id, metadata={"split": line.split, "simulator": line.simulator})
        for line in unietp.load_dataset(dataset)
    ]
    return Task(
        dataset=MemoryDataset(samples),
        solver=play(dataset, mode, {"picture": False, **settings}),
        scorer=goal_reached(),
    )


@tool
def act(env: unietp.TaskEnv) -> Tool:
    """The tool of an episode."""

    async def execute(action: str, argument: str = "") -> str:
        """Perform one action of the list in the instructions.

        Args:
            action: Its name, such as pick_up.
            argument: The id of the object or room, such as mug_1; empty for actions without one.

        Returns:
            What became of it, and what is in view.
        """
        execute_action(env, {"action": action, "args": [argument] if argument else []})
        return env.text()

    return execute


def execute_action(env: unietp.TaskEnv, action: Any) -> None:
    """Executes it, and keeps the verdict when the episode is over."""
    _, _, terminated, truncated, info = env.step(action)
    if terminated or truncated:
        store().set("success", info["success"])


@solver
def play(dataset: str, mode: str, settings: dict[str, Any]) -> Solver:
    """Lets the model act until the episode is over. An answer without a call of the tool is read as an action."""

    async def solve(state: TaskState, generate: Generate) -> TaskState:
        env = unietp.make(f"{dataset}/{state.sample_id}", mode, **settings)
        env.reset()
        state.messages = [ChatMessageSystem(content=env.prompt()), ChatMessageUser(content=env.text())]
        state.tools = [act(env)]
        while store().get("success") is None and not state.completed:
            state.output = await get_model().generate(state.messages, state.tools)
            state.messages.append(state.output.message)
            if state.output.message.tool_calls:
                state.messages.extend((await execute_tools(state.messages, state.tools)).messages)
            else:
                execute_action(env, state.output.completion)
                state.messages.append(ChatMessageUser(content=env.text()))
        env.close()
        return state

    return solve


@scorer(metrics=[accuracy(), stderr()])
def goal_reached() -> Scorer:
    """1 when the goal held at the end; 0 when not, also when a limit of Inspect's ended the sample before."""

    async def score(state: TaskState, target: Target) -> Score:
        return Score(value=1 if store().get("success") else 0)

    return score
