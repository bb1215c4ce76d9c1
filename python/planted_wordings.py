"""Wordings whose meaning was changed on purpose, for `python/model_server.py --plant SEED`: what is let through is an error.

A request for a wording shows some that are right. Of the first that can be changed so one word is, and asks for something else: a
thing becomes another thing of the home, a verb, state, number, place or color its opposite or another one. Which one is
drawn from the seed and the wording, so that the same request has the same answer.
"""

import random
import re

GOAL = "\nGoal as a formula: "
RIGHT = "\nWordings of this goal that are right:\n- "
HOME = "\nThe home:\n"

# Words of which each asks for something else than the other does.
SWAPS = (
    ("open", "close"),
    ("turn on", "turn off"),
    ("fill", "empty"),
    ("heat", "chill"),
    ("warm", "cold"),
    ("wash", "heat"),
    ("cook", "freeze"),
    ("slice", "wash"),
    ("soak", "dry"),
    ("both", "none of the"),
    ("two", "three"),
    ("all the", "one of the"),
    ("a couple of", "a few"),
    ("dirty", "clean"),
    ("larger", "smaller"),
    ("bigger", "smaller"),
    ("red", "blue"),
    ("white", "black"),
    ("water", "wine"),
    ("next to", "under"),
    ("first", "last"),
    ("nearest to", "farthest from"),
    ("kitchen", "bathroom"),
    ("dining room", "bedroom"),
    ("living room", "office"),
    ("hallway", "garage"),
)


def spots(wording: str, name: str) -> list[re.Match]:
    return list(re.finditer(rf"\b{re.escape(name)}\b", wording, re.IGNORECASE))


def things_of(home: str) -> list[str]:
    """Those of which a room of the home has one: "kitchen: mug, 2 plates"."""
    listed = [thing for room in home.splitlines() if ": " in room for thing in room.split(": ", 1)[1].split(", ")]
    return sorted({thing for thing in listed if thing and not thing[0].isdigit()})


def changed(wording: str, home: str, rng: random.Random) -> str | None:
    """The wording with one word, or name of a thing, changed; None where no word of it is known."""
    ways = []
    for pair in SWAPS:
        for word, other in (pair, pair[::-1]):
            ways += [(spot, other) for spot in spots(wording, word)]
    things = things_of(home)
    said = [thing for thing in things if spots(wording, thing)]
    # Of "dining table" and "table" the longer name is meant.
    said = [thing for thing in said if not any(thing != longer and spots(longer, thing) for longer in said)]
    others = [thing for thing in things if thing not in said and not any(spots(thing, one) for one in said)]
    if others:
        ways += [(spot, rng.choice(others)) for thing in said for spot in spots(wording, thing)[:1]]
    if not ways:
        return None
    spot, other = rng.choice(ways)
    if wording[spot.start()].isupper():
        other = other[0].upper() + other[1:]
    return wording[: spot.start()] + other + wording[spot.end() :]


def planted(prompt: str, seed: int) -> str | None:
    """The answer to a request for a wording, or None: another request, or no word of the wording is known."""
    if GOAL not in prompt or RIGHT not in prompt:
        return None
    right = [line.removeprefix("- ") for line in ("- " + prompt.split(RIGHT, 1)[1]).splitlines() if line.startswith("- ")]
    home = prompt.split(HOME, 1)[1].split(RIGHT, 1)[0]
    answers = (changed(wording, home, random.Random(f"{seed} {wording}")) for wording in right)
    return next((answer for answer in answers if answer is not None), None)
