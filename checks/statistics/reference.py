#!/usr/bin/env python3
"""Computes with scipy and statsmodels what the statistics of scores/ should give on random inputs.

  python3 -m venv build/statistics && build/statistics/bin/pip install -r checks/statistics/requirements.txt
  build/statistics/bin/python checks/statistics/reference.py > tests/scores/data/statistics.json

tests/scores compares the program with this file.
"""

import json
import warnings

import numpy
from scipy import special, stats
from statsmodels.stats.contingency_tables import mcnemar
from statsmodels.stats.multitest import multipletests
from statsmodels.stats.proportion import proportion_confint


def wilson(rng):
    trials = int(rng.integers(1, 800))
    successes = int(rng.integers(0, trials + 1))
    low, high = proportion_confint(successes, trials, alpha=0.05, method="wilson")
    return {"successes": successes, "trials": trials, "low": float(low), "high": float(high)}


def paired(rng):
    first, second = (int(count) for count in rng.integers(0, rng.integers(2, 200), 2))
    table = [[10, first], [second, 10]]
    return {"only_first": first, "only_second": second, "p": float(mcnemar(table, exact=True).pvalue)}


def flips(rng, count, resamples):
    differences = rng.integers(-3, 4, count) / 4 + (0.25 if count > 16 else 0)
    test = stats.permutation_test((differences,), lambda x, axis: x.sum(axis=axis), permutation_type="samples",
                                  vectorized=True, n_resamples=resamples, rng=rng)
    return {"differences": differences.tolist(), "p": float(test.pvalue)}


def corrected(rng):
    raw = rng.random(int(rng.integers(1, 12))) ** 3
    return {"raw": raw.tolist(), "holm": multipletests(raw, method="holm")[1].tolist()}


def passes(rng):
    n = int(rng.integers(1, 20))
    c, k = int(rng.integers(0, n + 1)), int(rng.integers(1, n + 1))
    every = special.comb(c, k, exact=True) / special.comb(n, k, exact=True)
    some = 1 - special.comb(n - c, k, exact=True) / special.comb(n, k, exact=True)
    return {"n": n, "c": c, "k": k, "at": some, "all": every}


def bootstrap(rng):
    clusters = int(rng.integers(20, 180))
    counts = rng.integers(1, 8, clusters)
    sums = rng.binomial(counts, rng.beta(2, 3, clusters))
    found = stats.bootstrap((sums, counts), lambda s, c, axis: s.sum(axis=axis) / c.sum(axis=axis), paired=True,
                            vectorized=True, n_resamples=100_000, batch=10_000, method="percentile",
                            rng=rng).confidence_interval
    return {"sums": sums.tolist(), "counts": counts.tolist(), "low": float(found.low), "high": float(found.high)}


def clustered(rng):
    """The posterior of scores/clustered_interval.h, on ten times as many rates."""
    clusters = int(rng.integers(2, 60))
    counts = 4 * rng.integers(1, 6, clusters)
    mean, spread = rng.choice([0.02, 0.1, 0.3, 0.6, 0.95]), 1 / rng.uniform(0.02, 0.5) - 1
    sums = rng.binomial(counts, rng.beta(mean * spread, (1 - mean) * spread, clusters))
    steps = 4000
    rates = numpy.sin((numpy.arange(steps) + 0.5) / steps * numpy.pi / 2) ** 2
    logs = [numpy.log(0.25) + stats.binom.logpmf(sums[:, None], counts[:, None], rates).sum(axis=0)]
    for i in range(1, 20):
        c = (20 / i) ** 2 - 1
        logs.append(numpy.log(0.75 * i / 190) + stats.betabinom.logpmf(sums[:, None], counts[:, None], rates * c, (1 - rates) * c).sum(axis=0))
    below = numpy.concatenate([[0], numpy.cumsum(numpy.exp(numpy.array(logs) - numpy.max(logs)).sum(axis=0))])
    low, high = numpy.sin(numpy.interp([0.025, 0.975], below / below[-1], numpy.arange(steps + 1) / steps) * numpy.pi / 2) ** 2
    return {"sums": sums.tolist(), "counts": counts.tolist(), "low": float(low) if sums.any() else 0.0,
            "high": float(high) if (sums < counts).any() else 1.0}


def main():
    warnings.simplefilter("ignore")
    rng = numpy.random.default_rng(27)
    lists = {
        "wilson": [wilson(rng) for _ in range(80)],
        "mcnemar": [paired(rng) for _ in range(60)],
        "sign_flip_exact": [flips(rng, int(rng.integers(2, 13)), numpy.inf) for _ in range(30)],
        "sign_flip_drawn": [flips(rng, int(rng.integers(20, 80)), 400_000) for _ in range(6)],
        "holm": [corrected(rng) for _ in range(30)],
        "pass": [passes(rng) for _ in range(80)],
        "bootstrap": [bootstrap(rng) for _ in range(8)],
        "clustered": [clustered(rng) for _ in range(40)],
    }
    rows = ",\n".join(f'"{name}": [\n' + ",\n".join(map(json.dumps, cases)) + "]" for name, cases in lists.items())
    print("{" + rows + "}")


main()
