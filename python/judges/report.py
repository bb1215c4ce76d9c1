"""What the judges have in common: a CSV file of one row a task, and what went wrong on standard output."""

import csv
import sys
from collections.abc import Callable
from pathlib import Path

Row = dict[str, object]


def finish(rows: list[Row], out: Path, summary: str, is_right: Callable[[Row], bool]) -> None:
    """Writes the rows, which need not all have the columns of the first, prints the summary and the rows that are wrong,
    and ends the program: with exit code 1 when there is one, or when nothing was judged."""
    columns = list(dict.fromkeys(name for row in rows for name in row))
    with out.open("w", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    print(summary)
    wrong = [row for row in rows if not is_right(row)]
    for row in wrong:
        print(row)
    sys.exit(1 if wrong or not rows else 0)
