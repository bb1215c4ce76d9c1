"""verifiers' own evaluation plays with a model server that answers with the demonstrations."""

import asyncio
import shutil

import pytest
import verifiers.v1 as vf
from replaying import ReplayServer
from verifiers.v1.cli.eval.runner import run_eval
from verifiers.v1.configs.cli.eval import EvalConfig

import unietp


def episodes(folder, url, out, limit, mode="M2"):
    config = EvalConfig.model_validate(
        {
            "env": {"taskset": {"id": "unietp-verifiers", "dataset": str(folder), "mode": mode}},
            "model": "replay",
            "client": {"type": "eval", "base_url": url, "api_key_var": "NO_KEY"},
            "select": {"limit": limit},
            "output_dir": str(out),
            "rich": None,
        }
    )
    return asyncio.run(run_eval(config))


@pytest.mark.parametrize("mode", ["M1", "M2"])
def test_the_demonstrations_are_rewarded(folder, dataset, tmp_path, mode):
    with ReplayServer(dataset, mode) as server:
        played = episodes(folder, server.url, tmp_path / "out", 3, mode)
    assert len(played) == 3
    for episode in played:
        assert episode.ok, episode.errors
        [trace] = episode.traces
        assert trace.reward == 1 and trace.metrics["success"] == 1


def test_a_fault_of_the_environment_is_an_error_and_no_reward(folder, dataset, tmp_path):
    damaged = tmp_path / "set"
    shutil.copytree(folder, damaged)
    (damaged / "homes" / f"{dataset[0].layout}.scene.json.gz").unlink()
    with ReplayServer(unietp.load_dataset(damaged), "M2") as server:
        [episode] = episodes(damaged, server.url, tmp_path / "out", 1)
    assert not episode.ok and episode.errors
    assert all(not trace.rewards for trace in episode.traces)


def test_the_taskset_has_the_tasks(folder, dataset):
    from unietp.integrations.verifiers import UnietpConfig, UnietpTaskset

    taskset = UnietpTaskset(UnietpConfig(id="unietp-verifiers", dataset=str(folder)))
    assert [task.data.id for task in taskset] == [task.id for task in dataset]
    assert isinstance(taskset, vf.Taskset) and len({task.key for task in taskset}) == len(dataset)
