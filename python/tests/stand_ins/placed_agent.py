"""The agent of habitat-sim, as far as stand-ins need it: it is where it was put."""

from types import SimpleNamespace


class Agent:
    def __init__(self):
        self.state = SimpleNamespace(position=[0.0, 0.0, 0.0], rotation=None)

    def get_state(self):
        return self.state

    def set_state(self, state):
        self.state = state
