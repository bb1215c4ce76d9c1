#!/usr/bin/env python3
"""How often the 95 % interval of a run with repeats covers the true rate, by simulation; beside it, percentiles.

  build/statistics/bin/python checks/statistics/coverage.py [SIMULATIONS]     (numpy; as for reference.py)

Homes differ in how hard they are in four ways: not at all; of two kinds; by a beta distribution that gives two episodes
of one home a correlation of 0.1, or of 0.3. Each home has 1 to 5 tasks, each task four repeats. The formulas are those of
scores/bootstrap.cpp, written again.
"""

import math
import sys

import numpy

NORMAL = 1.959963984540054
DRAWS = 500


def student(freedom):
    z, f = NORMAL, freedom
    return (z + z * (z**2 + 1) / (4 * f) + z * ((5 * z**2 + 16) * z**2 + 3) / (96 * f**2)
            + z * (((3 * z**2 + 19) * z**2 + 17) * z**2 - 15) / (384 * f**3))


def wilson(rate, trials, quantile):
    z2 = quantile**2
    middle = (rate + z2 / (2 * trials)) / (1 + z2 / trials)
    half = quantile / (1 + z2 / trials) * math.sqrt(rate * (1 - rate) / trials + z2 / (4 * trials**2))
    return middle - half, middle + half


def intervals(sums, counts, rng):
    homes, mean = len(sums), sums.sum() / counts.sum()
    t = student(homes - 1)
    if mean in (0, 1):
        return wilson(mean, homes, t), wilson(mean, homes, NORMAL)
    drawn = rng.integers(0, homes, (DRAWS, homes))
    means = sums[drawn].sum(1) / counts[drawn].sum(1)
    variance = ((means - mean) ** 2).mean() * homes / (homes - 1)
    trials = min(counts.sum(), mean * (1 - mean) / variance) if variance > 0 else counts.sum()
    tail = math.erfc(math.sqrt(homes / (homes - 1)) * t / math.sqrt(2)) / 2
    return wilson(mean, trials, t), tuple(numpy.quantile(means, [tail, 1 - tail]))


def rates(kind, mean, homes, rng):
    if kind == "alike":
        return numpy.full(homes, mean)
    if kind == "two kinds":
        return mean + rng.choice([-1, 1], homes) * min(0.25, mean)
    spread = 1 / float(kind.split()[-1]) - 1
    return rng.beta(mean * spread, (1 - mean) * spread, homes)


def main():
    simulations = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    rng = numpy.random.default_rng(5)
    print("kind,homes,mean,covered,covered_by_percentiles")
    for kind in ("alike", "two kinds", "correlation 0.1", "correlation 0.3"):
        for homes in (10, 20, 40):
            for mean in (0.02, 0.05, 0.1, 0.2, 0.3):
                covered = numpy.zeros(2)
                for _ in range(simulations):
                    counts = 4.0 * rng.integers(1, 6, homes)
                    sums = rng.binomial(counts.astype(int), rates(kind, mean, homes, rng)).astype(float)
                    covered += [low <= mean <= high for low, high in intervals(sums, counts, rng)]
                print(f"{kind},{homes},{mean},{','.join(f'{100 * share / simulations:.1f}' for share in covered)}", flush=True)


if __name__ == "__main__":
    main()
