"""What the programs have in common that act episodes out in a simulator for `unietp evaluate --backend NAME`.

They read lines of JSON-RPC 2.0 from standard input and answer each with one on standard output:

    begin {"task": ID, "folder": PATH, "rooms": [ID, ...], "start": FACTS}
        a task of `unietp export --format NAME`; its rooms in order; its start in our words, as below
    act {"action": "pick_up", "args": ["plate_1"], "ours": DELTA}
        an action of ours, and what it changed in our physics (docs/files.md has the form), the agent's pose among it

`act` answers with `success`, the simulator's `message` when it fails, and what changed of the simulator's state, in our
words: `states` (of each object those that are now true), `edges_added` and `edges_removed` (relation, from, to), and
`held` where that changed. Where an action consists of several steps, `moments` is a list of the same, from the state
after one step to that after the next: the goal is judged at each.
"""

import json
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any, Protocol

Json = dict[str, Any]
Edge = tuple[str, str, str]


@dataclass
class Facts:
    """A state in our words."""

    states: dict[str, list[str]] = field(default_factory=dict)  # by object
    edges: set[Edge] = field(default_factory=set)
    held: list[str] = field(default_factory=list)

    @classmethod
    def from_json(cls, json: Json) -> "Facts":
        return cls(json["states"], {(one[0], one[1], one[2]) for one in json["edges"]}, json["held"])

    def changes_to(self, now: "Facts") -> Json:
        """What an answer says of a change."""
        answer: Json = {
            "states": {name: states for name, states in now.states.items() if states != self.states.get(name)},
            "edges_added": sorted(now.edges - self.edges),
            "edges_removed": sorted(self.edges - now.edges),
        }
        return answer if now.held == self.held else answer | {"held": now.held}


def answer_of(message: str, before: Facts, moments: list[Facts]) -> Json:
    """The answer to an action: why it failed, or "", and the states that it led through, the last one last."""
    answer = {"success": not message, "message": " ".join(message.split()), **before.changes_to(moments[-1])}
    if len(moments) < 2:
        return answer
    return answer | {"moments": [one.changes_to(other) for one, other in pairwise([before, *moments])]}


class Acting(Protocol):
    """One task in a simulator."""

    def act(self, action: str, args: list[str], ours: Json) -> Json: ...


def answer_calls(begin: Callable[[Json], Acting], calls: Any, out: Any) -> None:
    """Answers the lines of `calls` on `out` until they end. `begin`: makes an episode of the parameters of `begin`."""
    episode: Acting | None = None
    for line in calls:
        call = json.loads(line)
        answer: Json = {"jsonrpc": "2.0", "id": call["id"]}
        try:
            params = call["params"]
            if call["method"] == "begin":
                episode = begin(params)
                answer["result"] = {}
            elif episode is None:
                raise ValueError("no episode has begun")
            else:
                answer["result"] = episode.act(params["action"], params["args"], params["ours"])
        except Exception as error:  # the caller records why
            answer["error"] = {"code": -32000, "message": f"{type(error).__name__}: {error}"}
        out.write(json.dumps(answer) + "\n")
        out.flush()


def serve(make: Callable[[], Callable[[Json], Acting]]) -> None:
    """Answers on standard output, where nothing else appears: what simulators print goes to standard error. `make`:
    starts the simulator and gives what begins an episode in it."""
    out, sys.stdout = sys.stdout, sys.stderr
    answer_calls(make(), sys.stdin, out)
