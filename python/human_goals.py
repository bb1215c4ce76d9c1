"""Fits the figures of how people ask for things, which `unietp stats --words` shows beside those of a data set.

    python3 python/human_goals.py ../shared/upstream/ai2thor/alfred_goal_texts.jsonl.gz data/english

Reads the goals that people wrote for ALFRED's demonstrations and writes `human_goals.csv` and `human_bigrams.csv`. Of the
demonstrations every second one is used, and of the kinds of goals those that data sets of unietp have, too: all but
`look_at_obj_in_light`. Only figures are written, and how often pairs of neighboring words occur; pairs that occur once are
only counted, so that no sentence can be made again from them.
"""

import collections
import gzip
import json
import pathlib
import re
import sys

FRAMES = (
    "make sure|ensure|see to it|see to the|i want you|i need you|i would like you|i'd like you|you should|you need to|you have to|"
    "your task|your job|the task is|the goal is|what counts|what is wanted|take care|at the end|in the end|by the end|"
    "when you are done"
).split("|")
POLITE = "please|kindly|could you|can you|would you|will you|thank you|would you mind".split("|")
SOURCE = (
    "# ALFRED (askforalfred, data/json_2.1.0/train, MIT licence): goals that people wrote; every second demonstration, without\n"
    "# look_at_obj_in_light. Made by python/human_goals.py.\n"
)


def words_in(text: str) -> list[str]:
    return re.findall(r"[a-z0-9'-]+", text.lower())


def has_one_of(words: list[str], phrases: list[str]) -> bool:
    spaced = f" {' '.join(words)} "
    return any(f" {phrase} " in spaced for phrase in phrases)


def training_texts(file: pathlib.Path) -> list[list[str]]:
    with gzip.open(file, "rt", encoding="utf-8") as lines:
        goals = [json.loads(line) for line in lines]
    texts = [words_in(text) for goal in goals[::2] if goal["kind"] != "look_at_obj_in_light" for text in goal["texts"]]
    return [words for words in texts if words]


def main() -> None:
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    texts = training_texts(pathlib.Path(sys.argv[1]))
    openings = collections.Counter(" ".join(words[:3]) for words in texts)
    pairs = collections.Counter(pair for words in texts for pair in zip(words, words[1:]))
    figures = {
        "texts": len(texts),
        "mean_words": round(sum(map(len, texts)) / len(texts), 3),
        "at_most_10_words": round(sum(len(words) <= 10 for words in texts) / len(texts), 4),
        "ten_openings": round(sum(count for _, count in openings.most_common(10)) / len(texts), 4),
        "frames": round(sum(has_one_of(words, FRAMES) for words in texts) / len(texts), 4),
        "polite": round(sum(has_one_of(words, POLITE) for words in texts) / len(texts), 4),
        "pairs_that_occur_once": sum(count == 1 for count in pairs.values()),
    }
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    rows = "".join(f"{name},{value}\n" for name, value in figures.items())
    (folder / "human_goals.csv").write_text(SOURCE + "figure,value\n" + rows, encoding="utf-8")
    rows = "".join(f"{a},{b},{count}\n" for (a, b), count in sorted(pairs.items()) if count > 1)
    (folder / "human_bigrams.csv").write_text(SOURCE + "first,second,count\n" + rows, encoding="utf-8")


if __name__ == "__main__":
    main()
