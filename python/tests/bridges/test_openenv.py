"""OpenEnv's server and client play over a WebSocket of loopback."""

import json
import threading
import time
import urllib.request

import numpy as np
import pytest
import uvicorn

from unietp.integrations.openenv import UnietpAction, UnietpClient, make_app


@pytest.fixture
def serve():
    servers = []

    def start(app):
        server = uvicorn.Server(uvicorn.Config(app, host="127.0.0.1", port=0, log_level="warning"))
        thread = threading.Thread(target=server.run)
        thread.start()
        while not server.started:
            assert thread.is_alive()
            time.sleep(0.01)
        servers.append((server, thread))
        return f"http://127.0.0.1:{server.servers[0].sockets[0].getsockname()[1]}"

    yield start
    for server, thread in servers:
        server.should_exit = True
        thread.join()


@pytest.mark.parametrize("mode", ["M1", "M2", "M3"])
def test_a_demonstration_reaches_the_goal(folder, dataset, serve, mode):
    url = serve(make_app(str(folder), mode))
    task = dataset[2]
    with UnietpClient(base_url=url).sync() as env:
        result = env.reset(task=task.id)
        assert task.instruction in result.observation.text and result.observation.prompt and result.observation.image
        for step in dataset.demonstration(task, mode).steps:
            assert not result.done
            result = env.step(UnietpAction(action=step.command()))
        assert result.done and result.reward == 1
        state = env.state()
        assert state.task == task.id and state.success is True


def test_sessions_are_apart_and_limited(folder, dataset, serve):
    url = serve(make_app(str(folder), "M2", sessions=2, picture=False))
    with UnietpClient(base_url=url).sync() as one, UnietpClient(base_url=url).sync() as two:
        first, second = one.reset(task=dataset[0].id), two.reset(task=dataset[1].id)
        assert first.observation.fields["instruction"] != second.observation.fields["instruction"]
        one.step(UnietpAction(action="turn_left()"))
        assert (one.state().step_count, two.state().step_count) == (1, 0)
        with pytest.raises(Exception, match="(?i)capacity|limit|sessions"):
            with UnietpClient(base_url=url).sync() as three:
                three.reset()
    with UnietpClient(base_url=url).sync() as again:  # their places are free again
        assert again.reset(seed=1).observation.text


def test_a_silent_session_is_closed(folder, serve):
    url = serve(make_app(str(folder), "M2", sessions=1, idle_s=0.5, picture=False))
    with UnietpClient(base_url=url).sync() as env:
        env.reset()
        deadline = time.monotonic() + 20
        while time.monotonic() < deadline:
            try:
                with UnietpClient(base_url=url).sync() as other:
                    assert other.reset().observation.text
                    break
            except Exception:  # still taken
                time.sleep(0.1)
        else:
            pytest.fail("the place of the silent session was not freed")
        with pytest.raises(Exception):
            env.step(UnietpAction(action="stop()"))


def test_the_tasks_are_listed(folder, dataset, serve):
    url = serve(make_app(str(folder), "M2", picture=False))
    with urllib.request.urlopen(f"{url}/openapi.json") as answer:
        routes = json.load(answer)["paths"]
    assert any("num_tasks" in route for route in routes)


def test_pictures_survive(folder):
    import base64
    import io

    from PIL import Image

    from unietp.integrations.openenv import png_text

    picture = np.arange(4 * 5 * 3, dtype=np.uint8).reshape(4, 5, 3)
    assert np.array_equal(np.asarray(Image.open(io.BytesIO(base64.b64decode(png_text(picture))))), picture)
