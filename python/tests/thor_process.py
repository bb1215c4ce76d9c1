#!/usr/bin/env python3
"""The stand-in for AI2-THOR as a process in the place of Unity's: what the package's controller starts, by the variable
AI2THOR_EXECUTABLE, and talks to through two pipes. The same messages as those of AI2-THOR 5.0.0 (its fifo_server.py). The
variable RECORDED_PLANS names the recording of iTHOR's floor plans (recorded_plans.py), which it then has."""

import json
import os
import struct
from pathlib import Path
from typing import Any, BinaryIO

import msgpack
from recorded_plans import recorded_plans
from simulated_thor import SimulatedThor

Json = dict[str, Any]
HEADER = "!BI"  # type of a field, length
METADATA, IMAGE, END = 1, 4, 255
PHYSICS = "_physics"  # which the package adds to the names of floor plans


def received(pipe: BinaryIO) -> Json | None:
    """The next action; None at the end."""
    action: Json | None = None
    while header := pipe.read(struct.calcsize(HEADER)):
        kind, length = struct.unpack(HEADER, header)
        body = pipe.read(length)
        if kind == END:
            return action
        action = json.loads(body)
    return None


class Process:
    def __init__(self) -> None:
        self.thor = SimulatedThor()
        self.size = (300, 300)
        self.scene = ""
        if file := os.environ.get("RECORDED_PLANS"):
            SimulatedThor.recorded.update(recorded_plans(Path(file)))

    def answer(self, action: Json) -> Json:
        """The metadata of the agent after an action."""
        name, arguments = action["action"], {k: v for k, v in action.items() if k not in ("action", "sequenceId")}
        state: Json = {"objects": [], "agent": {}, "lastActionSuccess": True, "errorMessage": "", "actionReturn": None}
        code = ""
        if name == "GetScenesInBuild":
            state["actionReturn"] = ["FloorPlan1_physics", *(name + PHYSICS for name in self.thor.recorded)]
        elif name == "ChangeResolution":
            self.size = (arguments["x"], arguments["y"])
        elif name == "CreateHouse":
            state = self.thor.reset(arguments["house"]).metadata
        elif name == "Reset":
            self.scene = arguments["sceneName"].removesuffix(PHYSICS)
        elif name == "Initialize":
            if self.scene in self.thor.recorded:
                state = self.thor.reset(self.scene).metadata
        else:
            try:
                state = self.thor.step(name, **arguments).metadata
            except ValueError as error:
                code = "InvalidAction"
                state |= {"lastActionSuccess": False, "errorMessage": str(error)}
        width, height = self.size
        return {
            **state, "agentId": 0, "errorCode": code, "lastAction": name, "sceneName": "Procedural", "screenWidth": width,
            "screenHeight": height, "colors": None, "colorBounds": None,
            "thirdPartyCameras": None,
        }  # fmt: skip

    def send(self, pipe: BinaryIO, sequence: int, metadata: Json) -> None:
        whole = {"agents": [metadata], "thirdPartyCameras": [], "sequenceId": sequence, "activeAgentId": 0}
        width, height = self.size
        for kind, body in ((METADATA, msgpack.dumps(whole)), (IMAGE, bytes(3 * width * height)), (END, b"")):
            pipe.write(struct.pack(HEADER, kind, len(body)) + body)
        pipe.flush()


def main() -> None:
    process = Process()
    with open(os.environ["AI2THOR_FIFO_SERVER_PIPE_PATH"], "wb") as out:
        process.send(out, 0, process.answer({"action": "Initialize"}))
        with open(os.environ["AI2THOR_FIFO_CLIENT_PIPE_PATH"], "rb") as calls:  # which is opened for the first action
            while (action := received(calls)) is not None:
                process.send(out, action["sequenceId"], process.answer(action))


if __name__ == "__main__":
    main()
