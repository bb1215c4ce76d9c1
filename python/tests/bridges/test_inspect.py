"""Inspect AI evaluates with its mock model, which answers with the demonstrations."""

import shutil

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
    spoilt = tmp_path / "set"
    shutil.copytree(folder, spoilt)
    (spoilt / "homes" / f"{dataset[0].layout}.scene.json.gz").unlink()
    log = run(spoilt, replay(unietp.load_dataset(spoilt), "M2"), tmp_path, limit=1, fail_on_error=False)
    assert log.samples[0].error is not None and not log.samples[0].scores
