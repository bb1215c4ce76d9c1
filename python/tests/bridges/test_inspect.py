"""Inspect AI evaluates with its mock model, which answers with the demonstrations."""

import json
import shutil
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.parse
import urllib.request

import pytest
from inspect_ai import eval as evaluate
from inspect_ai.model import ModelOutput, ModelUsage, get_model
from replaying import next_step

import unietp
from unietp.integrations.inspect import unietp_tasks


def counted(output):
    """The mock model would count tokens itself, with a table that it downloads."""
    output.usage = ModelUsage(input_tokens=1, output_tokens=1, total_tokens=2)
    return output


def replay(dataset, mode, by_tool=True):
    def answer(messages, tools, tool_choice, config):
        step = next_step(dataset, mode, messages[1].text, sum(message.role == "assistant" for message in messages))
        if not by_tool:
            return counted(ModelOutput.from_content("mockllm", f"{step.action}({', '.join(step.args)})"))
        assert [tool.name for tool in tools] == ["act"]
        arguments = {"action": step.action, **({"argument": step.args[0]} if step.args else {})}
        return counted(ModelOutput.for_tool_call("mockllm", "act", arguments))

    return get_model("mockllm/model", custom_outputs=answer)


def run(folder, model, tmp_path, mode="M2", **options):
    [log] = evaluate(
        unietp_tasks(str(folder), mode), model=model, log_dir=str(tmp_path / "logs"), display="none", **options
    )
    return log


@pytest.mark.parametrize("by_tool", [True, False])
@pytest.mark.parametrize("mode", ["M1", "M2"])
def test_the_demonstrations_score_one(folder, dataset, tmp_path, mode, by_tool):
    log = run(folder, replay(dataset, mode, by_tool), tmp_path, mode, limit=6)
    assert log.status == "success" and len(log.samples) == 6
    assert log.results.scores[0].metrics["accuracy"].value == 1


def test_stopping_at_once_scores_zero(folder, tmp_path):
    stop = get_model("mockllm/model", custom_outputs=lambda *_: counted(ModelOutput.from_content("mockllm", "stop()")))
    log = run(folder, stop, tmp_path, limit=3)
    assert log.results.scores[0].metrics["accuracy"].value == 0


def test_a_fault_of_the_environment_is_an_error_and_no_zero(folder, dataset, tmp_path):
    damaged = tmp_path / "set"
    shutil.copytree(folder, damaged)
    (damaged / "homes" / f"{dataset[0].layout}.scene.json.gz").unlink()
    log = run(damaged, replay(unietp.load_dataset(damaged), "M2"), tmp_path, limit=1, fail_on_error=False)
    assert log.samples[0].error is not None and not log.samples[0].scores


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def fetched(url):
    """What is at an address of a server that may still be starting."""
    for _ in range(300):
        try:
            with urllib.request.urlopen(url) as answer:
                return answer.read()
        except urllib.error.HTTPError:
            raise
        except OSError:
            time.sleep(0.1)
    raise TimeoutError(url)


def test_the_log_opens_in_inspects_viewer(folder, dataset, tmp_path):
    log = run(folder, replay(dataset, "M1"), tmp_path, "M1", limit=2)
    port = free_port()
    command = [sys.executable, "-m", "inspect_ai", "view", "start", "--log-dir", str(tmp_path / "logs"), "--port", str(port)]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as viewer:
        try:
            site = f"http://127.0.0.1:{port}"
            assert b"<html" in fetched(site)
            [shown] = json.loads(fetched(f"{site}/api/logs"))["files"]
            assert shown["name"].endswith(log.location.rsplit("/", 1)[-1])
            opened = json.loads(fetched(f"{site}/api/logs/{urllib.parse.quote(shown['name'], safe='')}"))
            assert opened["eval"]["task"] == "unietp_tasks" and len(opened["samples"]) == 2
            for sample in opened["samples"]:
                assert sample["scores"]["goal_reached"]["value"] == 1
                assert sample["messages"][0]["role"] == "system" and sample["messages"][1]["role"] == "user"
        finally:
            viewer.terminate()
