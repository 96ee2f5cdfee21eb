"""Keys of a table: declared once, with their kind and one sentence; the check and the documentation follow."""

from dataclasses import dataclass

from thalweg.faults import InputError, nearest


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and value == value and abs(value) < 1e300


def list_of(kind):
    return lambda value: isinstance(value, list) and bool(value) and all(map(kind, value))


def is_text(value):
    return isinstance(value, str) and bool(value.strip())


KINDS = {
    "number": (is_number, "a number"),
    "positive number": (lambda value: is_number(value) and value > 0, "a number above 0"),
    "limit": (lambda value: is_number(value) and value >= 0, "a number, 0 or more"),
    "count": (lambda value: isinstance(value, int) and not isinstance(value, bool) and value >= 0, "a whole number, 0 or more"),
    "numbers": (list_of(is_number), "a list of numbers"),
    "number or numbers": (lambda value: is_number(value) or list_of(is_number)(value), "a number or a list of numbers"),
    "pairs": (list_of(lambda value: list_of(is_number)(value) and len(value) == 2), "a list of pairs of numbers"),
    "text": (is_text, "a text"),
    "text or texts": (lambda value: is_text(value) or list_of(is_text)(value), "a text or a list of texts"),
    "texts": (list_of(is_text), "a list of texts"),
    "flag": (lambda value: isinstance(value, bool), "true or false"),
    "scale": (lambda value: value in ("reference", "range", "rms", "spacing") or (is_number(value) and value > 0),
              'a number above 0, "reference", "range", "rms" or "spacing"'),
}


@dataclass
class Key:
    name: str
    kind: str
    meaning: str
    required: bool = False
    words: tuple = ()  # those a text may be


def check(table, keys, where):
    """Throws InputError for an unknown, a missing or a wrong key; where(key) is "file:line" of it, where(None) of the table."""
    known = {key.name: key for key in keys}
    for name, value in table.items():
        if name not in known:
            raise InputError(f"{where(name)}: unknown key {name}; {nearest(name, known)}")
        fits, words = KINDS[known[name].kind]
        if not fits(value):
            raise InputError(f"{where(name)}: {name} is {value!r}; give {words}")
        if known[name].words and value not in known[name].words:
            raise InputError(f"{where(name)}: there is no {name} {value}; {nearest(value, known[name].words)}")
    for key in keys:
        if key.required and key.name not in table:
            raise InputError(f"{where(None)}: {key.name} is missing; give it: {key.meaning}")


def documented(keys):
    """The rows of a table of documentation."""
    return [[f"`{key.name}`" + ("" if key.required else " (optional)"), ", ".join(key.words) or KINDS[key.kind][1], key.meaning] for key in keys]
