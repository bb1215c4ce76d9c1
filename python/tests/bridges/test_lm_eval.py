"""lm-evaluation-harness prints its table from the lm_eval.json of an evaluation."""

import json

import pytest
from lm_eval.utils import make_table

import unietp


@pytest.fixture(scope="module")
def results(folder, tmp_path_factory):
    out = tmp_path_factory.mktemp("evaluation") / "run"
    unietp.run_program("evaluate", folder, "--policy", "noisy:0.1", "--modes", "M1,M2", "--out", out)
    return [json.loads((out / name).read_text()) for name in ("lm_eval.json", "results.json")]


def test_its_table_has_the_rates_of_all_modes_and_splits(results):
    ours, figures = results
    table = make_table(ours)
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines()[2:] if line.startswith("|")]
    rates = {}
    for task, _, _, _, metric, better, value, _, error in rows:
        name = task.removeprefix("- ") or name
        if metric == "success_rate":
            assert better == "↑" and float(error) >= 0
            rates[name] = float(value)
    for mode in figures["modes"]:
        assert rates.pop(f"unietp_{mode['mode']}") == pytest.approx(mode["all"]["success_rate"], abs=1e-4)
        for split in mode["by_split"]:
            assert rates.pop(f"unietp_{mode['mode']}_{split['name']}") == pytest.approx(split["success_rate"], abs=1e-4)
    assert not rates
