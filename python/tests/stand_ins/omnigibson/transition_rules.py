"""OmniGibson's rule for cutting: a thing becomes two halves, which have its states and lie where it lay."""

import copy
from types import SimpleNamespace

REGISTERED_RULES = {}
TransitionRuleAPI = None


class SlicingRule:
    def transition(self, candidates):
        (whole,) = candidates["sliceable"]
        halves = []
        for number in range(2):
            half = type(whole)(whole.scene, f"half_{whole.name}_{number}", f"half_{whole.category}")
            half.place = whole.place
            for kind, state in whole.states.items():
                if kind in half.states:
                    values = {key: copy.copy(value) for key, value in vars(state).items() if key not in ("obj", "parameters")}
                    vars(half.states[kind]).update(values)
            halves.append(half)
        return SimpleNamespace(add=halves, remove=[whole])
