#!/usr/bin/env python3
"""How often the 95 % interval of a run with repeats covers the true rate, by simulation; beside it, bootstrap percentiles.

  build/statistics/bin/python checks/statistics/coverage.py [SIMULATIONS]     (numpy; as for reference.py)

Homes differ in how hard they are in four ways: not at all; of two kinds; by a beta distribution that gives two episodes
of one home a correlation of 0.1, or of 0.3. Each home has 1 to 5 tasks, each task four repeats. The formulas are those of
scores/clustered_interval.cpp, written again.
"""

import sys

import numpy

DRAWS = 500
STEPS = 400
MOST = 20  # episodes of a home
RATES = numpy.sin((numpy.arange(STEPS) + 0.5) / STEPS * numpy.pi / 2) ** 2
CORRELATIONS = (numpy.arange(20)[:, None] / 20) ** 2
PRIOR = numpy.log([0.25] + [0.75 * i / 190 for i in range(1, 20)])[:, None]
# A factor of the likelihood for each k below a home's successes; that for its failures is the same from the other end.
FACTORS = numpy.array([numpy.log(RATES * (1 - CORRELATIONS) + k * CORRELATIONS) for k in range(MOST)])
TOTALS = numpy.array([numpy.log(1 - CORRELATIONS + k * CORRELATIONS) for k in range(MOST)])


def exceeding(counts):
    return (counts[:, None] > numpy.arange(MOST)).sum(0).astype(float)


def clustered(sums, counts):
    logs = PRIOR + numpy.tensordot(exceeding(sums), FACTORS, 1)
    logs += numpy.tensordot(exceeding(counts - sums), FACTORS[:, :, ::-1], 1) - numpy.tensordot(exceeding(counts), TOTALS, 1)
    below = numpy.concatenate([[0], numpy.cumsum(numpy.exp(logs - logs.max()).sum(0))])
    low, high = numpy.sin(numpy.interp([0.025, 0.975], below / below[-1], numpy.arange(STEPS + 1) / STEPS) * numpy.pi / 2) ** 2
    return low if sums.any() else 0, high if (sums < counts).any() else 1


def percentiles(sums, counts, rng):
    drawn = rng.integers(0, len(sums), (DRAWS, len(sums)))
    return numpy.quantile(sums[drawn].sum(1) / counts[drawn].sum(1), [0.025, 0.975])


def rates(kind, mean, homes, rng):
    if kind == "alike":
        return numpy.full(homes, mean)
    if kind == "two kinds":
        return mean + rng.choice([-1, 1], homes) * min(0.25, mean)
    spread = 1 / float(kind.split()[-1]) - 1
    return rng.beta(mean * spread, (1 - mean) * spread, homes)


def main():
    simulations = int(sys.argv[1]) if len(sys.argv) > 1 else 4000
    rng = numpy.random.default_rng(5)
    print("kind,homes,mean,covered,covered_by_percentiles")
    for kind in ("alike", "two kinds", "correlation 0.1", "correlation 0.3"):
        for homes in (10, 20, 40):
            for mean in (0.02, 0.05, 0.1, 0.2, 0.3):
                covered = numpy.zeros(2)
                for _ in range(simulations):
                    counts = 4 * rng.integers(1, 6, homes)
                    sums = rng.binomial(counts, rates(kind, mean, homes, rng))
                    found = clustered(sums, counts), percentiles(sums, counts, rng)
                    covered += [low <= mean <= high for low, high in found]
                print(f"{kind},{homes},{mean},{','.join(f'{100 * share / simulations:.1f}' for share in covered)}", flush=True)


if __name__ == "__main__":
    main()
