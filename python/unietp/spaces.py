"""Gymnasium's spaces: observations as arrays of fixed sizes, actions as numbers."""

import json
from typing import Any

import numpy as np
from gymnasium import spaces

from unietp import _native
from unietp.task_source import TaskSource

INSTRUCTION_BYTES = 1024
MOST_SEED = 2**53 - 1

# The numbers of native/array_form.h.
KINDS = ("", "room", "furniture", "movable", "seen")


class EnvironmentSpaces:
    """How an environment with these settings looks to Gymnasium. docs/python.md has the tables."""

    def __init__(self, source: TaskSource, settings: dict[str, Any], max_things: int, channels: tuple[str, ...] = ()):
        self.settings = settings
        self.channels = channels
        self.text = json.dumps(settings)
        self.categories = ("", *source.catalog.categories)
        self.actions = tuple(_native.offered_actions(self.text, source.extended))
        self.names_boxes = "box" in (settings["reach"], settings["atomic"], settings["composite"])
        self.encoding = _native.Encoding(source.catalog, list(self.actions), max_things, INSTRUCTION_BYTES)
        width, height = source.image_size
        self.image_shape = (settings["image_height"] or height, settings["image_width"] or width, 3)
        self.observation_space = self._observation_space(max_things)
        self.action_space = self._action_space(max_things)

    def _observation_space(self, max_things: int) -> spaces.Dict:
        categories, failures = len(self.categories) - 1, len(_native.failure_names()) - 1
        side = max(self.image_shape) - 1
        steps = self.settings["steps"]
        thing_low = np.array([0, 0, 0, -1, -1, -1, -1], np.int32)
        thing_high = np.array([len(KINDS) - 1, categories, 1, side, side, side, side], np.int32)
        numbers: dict[str, spaces.Space[Any]] = {
            "things": spaces.Box(np.tile(thing_low, (max_things, 1)), np.tile(thing_high, (max_things, 1)), dtype=np.int32),
            "held": spaces.Box(0, np.tile(np.array([max_things, categories], np.int32), (2, 1)), dtype=np.int32),
            "last": spaces.Box(0, np.array([len(self.actions), 2, failures], np.int32), dtype=np.int32),
            "counts": spaces.Box(
                np.array([0, 0, -1], np.int32), np.array([steps, steps, self.settings["failures"]], np.int32), dtype=np.int32
            ),
            "instruction": spaces.Box(0, 255, (INSTRUCTION_BYTES,), np.uint8),
        }
        if self.settings["picture"]:
            numbers["image"] = spaces.Box(0, 255, self.image_shape, np.uint8)
        if "depth" in self.channels:
            numbers["depth"] = spaces.Box(0, np.inf, self.image_shape[:2], np.float32)
        if "normals" in self.channels:
            numbers["normals"] = spaces.Box(-1, 1, self.image_shape, np.float32)
        return spaces.Dict(numbers)

    def _action_space(self, max_things: int) -> spaces.Dict:
        parts: dict[str, spaces.Space[Any]] = {
            "action": spaces.Discrete(len(self.actions)),
            "argument": spaces.Discrete(max_things + 1),
        }
        if self.names_boxes:
            parts["box"] = spaces.Box(0, 1, (4,), np.float32)
        return spaces.Dict(parts)

    def padded(self, image: np.ndarray) -> np.ndarray:
        """The picture, or a channel of it, in the shape of the space: what a smaller one leaves free, right and below, is 0."""
        if image.shape[:2] == self.image_shape[:2]:
            return image
        framed = np.zeros((*self.image_shape[:2], *image.shape[2:]), image.dtype)
        framed[: image.shape[0], : image.shape[1]] = image
        return framed

    def bounded(self, name: str, channel: np.ndarray) -> np.ndarray:
        """A channel within the bounds of the space: rounding leaves normals a little longer than 1."""
        return np.clip(channel, -1, 1) if name == "normals" else channel


def action_bytes(action: Any) -> bytes:
    """An action that is no dict of numbers as bytes for the environment, which reads any. Never raises."""
    if isinstance(action, (bytes, bytearray, memoryview)):
        return bytes(action)
    if not isinstance(action, str):
        try:
            action = json.dumps(action)
        except (TypeError, ValueError, RecursionError):
            action = ""  # no JSON: a failed step
    return action.encode("utf-8", "surrogatepass")


def numbered(action: Any) -> tuple[int, int, list[float]] | None:
    """The action, argument and box of an element of an action space; None for anything else, such as a dict with the name
    of an action, numbers that are not whole or have more than 64 bits, or a box that is not four numbers."""
    if not isinstance(action, dict) or not {"action", "argument"} <= action.keys() <= {"action", "argument", "box"}:
        return None
    numbers = []
    for name in ("action", "argument"):
        value = action[name]
        if isinstance(value, np.ndarray) and value.ndim == 0:
            value = value.item()
        if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not -(2**63) <= value < 2**63:
            return None
        numbers.append(int(value))
    try:
        box = np.asarray(action.get("box", (0, 0, 0, 0)), np.float64)
    except (TypeError, ValueError, OverflowError):
        return None
    if box.shape != (4,):
        return None
    return numbers[0], numbers[1], box.tolist()


def is_batch(actions: Any) -> bool:
    """Whether it is an element of the action space of several environments: arrays by name."""
    return isinstance(actions, dict) and {"action", "argument"} <= actions.keys()
