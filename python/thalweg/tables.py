"""CSV tables as the program writes them, and tables of a page."""

import csv


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def text_rows(file):
    """Rows of a CSV table of ours as they stand in it: full headings, values as texts."""
    with file.open(encoding="utf-8") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def read_table(file):
    """Rows of a CSV table of ours, units taken off the headings, numbers as numbers."""
    return [{heading.split(" [")[0]: number(value) for heading, value in row.items()} for row in text_rows(file)]


def write_table(file, rows, comment):
    """Writes rows with the same keys under them as headings; a comment of several lines stands before."""
    with file.open("w", encoding="utf-8", newline="") as to:
        to.writelines(f"# {line}\n" for line in comment.splitlines())
        table = csv.DictWriter(to, rows[0].keys(), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def markdown(columns, rows):
    """The lines of a table in Markdown."""
    yield "| " + " | ".join(columns) + " |"
    yield "|" + "---|" * len(columns)
    for row in rows:
        yield "| " + " | ".join(str(cell) for cell in row) + " |"
