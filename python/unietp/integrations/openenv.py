"""OpenEnv (0.10): a server with one environment for each session over WebSocket, and its client.

    python -m unietp.integrations.openenv out/first-benchmark --mode M2 --port 8000 --sessions 8 --idle 600

    with UnietpClient(base_url="http://127.0.0.1:8000").sync() as env:
        result = env.reset(task="ai2thor-00001")
        result = env.step(UnietpAction(action="go_to(mug_1)"))
"""

import argparse
import asyncio
import base64
import io
from typing import Any

import numpy as np
from openenv.core import EnvClient
from openenv.core.client_types import StepResult
from openenv.core.env_server import Action, Environment, Observation, State, create_app
from openenv.core.env_server.types import ConcurrencyConfig
from pydantic import Field, JsonValue

import unietp


class UnietpAction(Action):
    """What the agent says."""

    action: JsonValue = Field(description="Text or JSON: pick_up(mug_1), or a list of several actions")


class UnietpObservation(Observation):
    """What the agent is told. `done` and `reward` are OpenEnv's."""

    text: str = Field(description="The observation in words, as a user's turn of a chat")
    prompt: str | None = Field(default=None, description="The system prompt, at the start of an episode")
    fields: dict[str, Any] = Field(description="The same as text, by name")
    image: str | None = Field(default=None, description="The picture as PNG in base64, if the mode shows it")


class UnietpState(State):
    """Where the episode is. The verdict comes when it is over."""

    task: str | None = None
    success: bool | None = None


class UnietpEnvironment(Environment[UnietpAction, UnietpObservation, UnietpState]):
    """An environment of one session. `reset` takes a seed, or the id or the index of a task."""

    SUPPORTS_CONCURRENT_SESSIONS = True

    def __init__(self, dataset: str, mode: str = "M2", **settings: Any):
        super().__init__()
        self._env = unietp.make(dataset, mode, **settings)
        self._tasks = unietp.load_dataset(dataset)
        self._state = UnietpState()

    def reset(
        self,
        seed: int | None = None,
        episode_id: str | None = None,
        task: str | None = None,
        index: int | None = None,
        **_: Any,
    ) -> UnietpObservation:
        options = {"task": task} if task is not None else {"index": index} if index is not None else None
        _, info = self._env.reset(seed=seed, options=options)
        self._state = UnietpState(episode_id=episode_id, task=info["task"])
        return self._observation(info, prompt=self._env.prompt())

    def step(self, action: UnietpAction, timeout_s: float | None = None, **_: Any) -> UnietpObservation:
        _, reward, terminated, truncated, info = self._env.step(action.action)
        self._state.step_count = info["observation"]["step"]
        self._state.success = info.get("success")
        return self._observation(info, reward=float(reward), done=terminated or truncated)

    @property
    def state(self) -> UnietpState:
        return self._state

    def close(self) -> None:
        self._env.close()

    # The tasks, for OpenEnv's routes.

    def list_splits(self) -> list[str]:
        return ["all"]

    def num_tasks(self, split: str) -> int:
        return len(self._tasks)

    def get_task(self, split: str, index: int) -> dict[str, Any]:
        task = self._tasks[index]
        return {"id": task.id, "index": index, "instruction": task.instruction, "simulator": task.simulator}

    def list_tasks(self, split: str) -> list[dict[str, Any]]:
        return [self.get_task(split, index) for index in range(len(self._tasks))]

    def get_task_range(self, split: str, start: int | None = None, stop: int | None = None) -> list[dict[str, Any]]:
        return [self.get_task(split, index) for index in range(len(self._tasks))[start:stop]]

    def _observation(self, info: dict[str, Any], **more: Any) -> UnietpObservation:
        fields = dict(info["observation"])
        picture = fields.pop("image", None)
        return UnietpObservation(
            text=self._env.text(), fields=fields, image=None if picture is None else png_text(picture), **more
        )


class UnietpClient(EnvClient[UnietpAction, UnietpObservation, UnietpState]):
    """The client of the server."""

    def _step_payload(self, action: UnietpAction) -> dict[str, Any]:
        return action.model_dump(exclude={"metadata"})

    def _parse_result(self, payload: dict[str, Any]) -> StepResult[UnietpObservation]:
        done, reward = bool(payload.get("done")), payload.get("reward")
        observation = UnietpObservation(**payload["observation"], done=done, reward=reward)
        return StepResult(observation=observation, reward=reward, done=done)

    def _parse_state(self, payload: dict[str, Any]) -> UnietpState:
        return UnietpState(**payload)


def png_text(picture: np.ndarray) -> str:
    """A picture as PNG in base64."""
    from PIL import Image

    with io.BytesIO() as file:
        Image.fromarray(picture).save(file, "PNG")
        return base64.b64encode(file.getvalue()).decode()


class IdleLimit:
    """Closes a WebSocket on which nothing has come for a while. OpenEnv itself ends silent sessions only when no socket
    holds them."""

    def __init__(self, app: Any, idle_s: float):
        self._app, self._idle_s = app, idle_s

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        async def receive_in_time() -> Any:
            try:
                return await asyncio.wait_for(receive(), self._idle_s)
            except TimeoutError:
                await send({"type": "websocket.close", "code": 1001, "reason": "idle"})
                return {"type": "websocket.disconnect", "code": 1001}

        await self._app(scope, receive_in_time if scope["type"] == "websocket" else receive, send)


def make_app(dataset: str, mode: str = "M2", *, sessions: int = 8, idle_s: float = 600, **settings: Any) -> Any:
    """The server as a FastAPI application.

    Args:
        sessions: how many there may be at a time; further ones are refused.
        idle_s: seconds without a message after which a session is closed.
        settings: those of `unietp.make`.
    """
    unietp.make(dataset, mode, **settings).close()  # what is wrong with them shows here and not in a session
    app = create_app(
        lambda: UnietpEnvironment(dataset, mode, **settings),
        UnietpAction,
        UnietpObservation,
        env_name="unietp",
        concurrency_config=ConcurrencyConfig(max_concurrent_envs=sessions, session_timeout=idle_s),
        state_cls=UnietpState,
    )
    app.add_middleware(IdleLimit, idle_s=idle_s)
    return app


def main() -> None:
    import uvicorn

    parser = argparse.ArgumentParser(description="Serves the tasks of a data set to OpenEnv's clients.")
    parser.add_argument("dataset", help="folder of a data set")
    parser.add_argument("--mode", default="M2", choices=["M1", "M2", "M3"])
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=8000)
    parser.add_argument("--sessions", type=int, default=8, help="at a time")
    parser.add_argument("--idle", type=float, default=600, help="seconds after which a silent session is closed")
    given = parser.parse_args()
    app = make_app(given.dataset, given.mode, sessions=given.sessions, idle_s=given.idle)
    uvicorn.run(app, host=given.host, port=given.port)


if __name__ == "__main__":
    main()
