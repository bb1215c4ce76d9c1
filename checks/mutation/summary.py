"""What a run found: one line of JSON a mutant, and the counts."""

import json
from collections import Counter

CAUGHT = {"caught", "crashed", "hung"}
FILE, EQUIVALENT = "mutants.jsonl", "equivalent_mutants.jsonl"


def write(results, folder):
    """Writes folder/mutants.jsonl from the file `results`, with the verdict `equivalent` for those that
    folder/equivalent_mutants.jsonl names with a reason, and gives the counts as a Markdown table."""
    found = sorted((json.loads(line) for line in results.read_text().splitlines()), key=lambda line: line["id"])
    judged = folder / EQUIVALENT
    reasons = {key(line): line["reason"] for line in map(json.loads, judged.read_text().splitlines())} \
        if judged.is_file() else {}
    for line in found:
        if key(line) in reasons and line["verdict"] not in CAUGHT:
            line |= {"verdict": "equivalent", "by": reasons[key(line)]}
    folder.mkdir(parents=True, exist_ok=True)
    (folder / FILE).write_text("".join(json.dumps(line, ensure_ascii=False) + "\n" for line in found))
    return table(found)


def key(line):
    return line["file"], line["original"], line["mutated"]


def table(found):
    rows = [("room", *counts_of(found, "room")), ("kind", *counts_of(found, "kind"))]
    text = ""
    for head, *lines in rows:
        text += f"| {head} | mutants | caught | equivalent | survived |\n|---|---|---|---|---|\n"
        text += "".join(f"| {name} | {c['all']} | {c['caught']} | {c['equivalent']} | {c['survived']} |\n"
                        for name, c in lines)
        text += "\n"
    whole = tally(found)
    return text + (f"{whole['caught']} of {whole['all']} caught ({percent(whole['caught'], whole['all'])}), "
                   f"{whole['equivalent']} equivalent ({percent(whole['equivalent'], whole['all'])}), "
                   f"{whole['survived']} survived.")


def counts_of(found, field):
    names = dict.fromkeys(line[field] for line in found)
    return [(name, tally([line for line in found if line[field] == name])) for name in names]


def tally(lines):
    caught = sum(line["verdict"] in CAUGHT for line in lines)
    verdicts = Counter(line["verdict"] for line in lines)
    return {"all": len(lines), "caught": caught, "equivalent": verdicts["equivalent"],
            "survived": len(lines) - caught - verdicts["equivalent"]}


def percent(part, whole):
    return f"{100 * part / whole:.1f} %"
