"""A planning task as Fast Downward's translator grounds it (the format of its output.sas, version 3), and what plans do in it.
So other code than ours decides which actions there are, what they need and what they change."""

from collections.abc import Iterator, Sequence
from pathlib import Path

Facts = list[tuple[int, int]]  # variable, value
State = tuple[int, ...]
Effect = tuple[Facts, int, int]  # under these conditions this variable gets this value


def holds(facts: Facts, state: Sequence[int]) -> bool:
    return all(state[variable] == value for variable, value in facts)


class SasTask:
    def __init__(self, path: Path):
        self._lines = iter(path.read_text().splitlines())
        while next(self._lines) != "end_metric":
            pass
        variables = [self._variable() for _ in range(self._number())]
        for _ in range(self._number()):
            self._skip(1)  # a group of facts that exclude each other
            self._skip(self._number() + 1)
        self._skip(1)
        first = [self._number() for _ in variables]
        self._skip(2)
        self.goal = self._facts()
        self._skip(1)
        self.operators = dict(self._operator() for _ in range(self._number()))
        axioms = [self._rule() for _ in range(self._number())]
        self._layers = [  # of axioms, each with those variables
            [one for one in axioms if variables[one[1]] == layer] for layer in sorted({v for v in variables if v >= 0})
        ]
        self._derived = {variable: first[variable] for variable, layer in enumerate(variables) if layer >= 0}
        self.start = self._with_axioms(first)

    def _skip(self, count: int) -> None:
        for _ in range(count):
            next(self._lines)

    def _number(self) -> int:
        return int(next(self._lines))

    def _variable(self) -> int:
        """The layer of the axioms that decide a variable; -1 for one that operators change."""
        self._skip(2)
        layer = self._number()
        self._skip(self._number() + 1)
        return layer

    def _facts(self) -> Facts:
        pairs = [next(self._lines).split() for _ in range(self._number())]
        return [(int(variable), int(value)) for variable, value in pairs]

    def _operator(self) -> tuple[str, tuple[Facts, list[Effect]]]:
        self._skip(1)
        name = next(self._lines).strip()  # without arguments it ends in a space
        needs, effects = self._facts(), []
        for _ in range(self._number()):
            numbers = [int(one) for one in next(self._lines).split()]
            variable, before, after = numbers[-3:]
            conditions = list(zip(numbers[1:-3:2], numbers[2:-3:2], strict=True))
            effects.append((conditions, variable, after))
            needs += [(variable, before)] if before >= 0 else []
        self._skip(2)  # cost
        return name, (needs, effects)

    def _rule(self) -> Effect:
        self._skip(1)
        conditions = self._facts()
        variable, _, after = (int(one) for one in next(self._lines).split())
        self._skip(1)
        return conditions, variable, after

    def _with_axioms(self, values: list[int]) -> State:
        for variable, value in self._derived.items():
            values[variable] = value
        for layer in self._layers:
            changed = True
            while changed:
                changed = False
                for conditions, variable, after in layer:
                    if values[variable] != after and holds(conditions, values):
                        values[variable], changed = after, True
        return tuple(values)

    def states(self, plan: Sequence[str], state: State | None = None) -> list[State]:
        """The state before each action and after the last; shorter where an action cannot be done."""
        states = [self.start if state is None else state]
        for action in plan:
            needs, effects = self.operators.get(action, ([(0, -1)], []))
            if not holds(needs, states[-1]):
                break
            after = list(states[-1])
            for conditions, variable, value in effects:
                if holds(conditions, states[-1]):
                    after[variable] = value
            states.append(self._with_axioms(after))
        return states

    def reaches(self, plan: Sequence[str], state: State | None = None) -> bool:
        states = self.states(plan, state)
        return len(states) == len(plan) + 1 and holds(self.goal, states[-1])


def actions_of(plan: str) -> Iterator[str]:
    """The actions of a plan's text as operators are named: without parentheses."""
    for line in plan.splitlines():
        if line.startswith("("):
            yield line[1 : line.index(")")].strip().lower()
