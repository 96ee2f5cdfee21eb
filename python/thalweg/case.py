"""Case files read and edited: a change replaces the text of one value, so that comments and order stay."""

import copy
import pathlib
import re
import tomllib

from thalweg.faults import InputError, nearest
from thalweg.toml_files import HEADER, KEY, MULTILINE, read_toml
from thalweg.units import si, written

NAMED = ("shape", "motion", "inlet", "outlet", "gauge", "line")  # tables of which there may be several, told apart by their names


class Case:
    """A case file. Keys are named as on the command line: "numerics.spacing", "shape.pier.radius", "materials.pvc.porosity".

    case["numerics.spacing"] is the text or number as it stands there, case.si("numerics.spacing") the SI number.
    case["numerics.spacing"] = "5 mm", or (0.005, "m"), changes it; a key or table that is not there yet is added.
    """

    def __init__(self, text, folder=None):
        self.text, self.folder = text, folder
        self.data = tomllib.loads(text)

    @classmethod
    def read(cls, path):
        """Reads a case.toml, or the one in a folder. Raises InputError with file and line."""
        path = pathlib.Path(path)
        file = path / "case.toml" if path.is_dir() else path
        _, text = read_toml(file, str(file))
        return cls(text, file.parent)

    def __getitem__(self, path):
        table, key, _ = self._table(path)
        if table is None or key not in table:
            raise KeyError(f"{path} is not in the case; {nearest(key, table or {}) if table else 'its table is not there'}")
        return table[key]

    def __contains__(self, path):
        table, key, _ = self._table(path)
        return table is not None and key in table

    def si(self, path, of=None):
        """The SI number, or list of numbers, of a key. `of`: a unit that it has to be of the kind of."""
        return si(self[path], of)

    def names(self, kind):
        """Names of all shapes, motions, inlets, outlets, gauges or lines."""
        return [entry.get("name", "") for entry in self.data.get(kind, [])]

    def _table(self, path):
        """(table or None, key, (header, index of equal headers)) of a key's path."""
        parts = path.split(".")
        if len(parts) == 3 and parts[0] in NAMED:
            names = self.names(parts[0])
            if parts[1] not in names:
                raise KeyError(f"there is no {parts[0]} {parts[1]}; there are {', '.join(names) or 'none'}")
            index = names.index(parts[1])
            return self.data[parts[0]][index], parts[2], (parts[0], index)
        if len(parts) not in (2, 3):
            raise KeyError(f"{path} is no key; write table.key, or shape.NAME.key")
        here = self.data
        for part in parts[:-1]:
            here = here.get(part) if isinstance(here, dict) else None
        return here, parts[-1], (".".join(parts[:-1]), 0)

    def __setitem__(self, path, value):
        value = _plain(value)
        table, key, header = self._table(path)
        wanted = copy.deepcopy(self.data)
        lines = self.text.splitlines(keepends=True)
        statements = list(_statements(lines))
        own = [each for each in statements if each[0] == header]
        if table is None or not own:
            ending = "" if self.text.endswith("\n") else "\n"
            text = f"{self.text}{ending}\n[{header[0]}]\n{key} = {toml(value)}\n"
        elif key in table:
            first, last = next((first, last) for _, name, first, last in own if name == key)
            lines[first:last + 1] = [_replaced("".join(lines[first:last + 1]), value)]
            text = "".join(lines)
        else:
            after = own[-1][3]
            lines[after] = lines[after] if lines[after].endswith("\n") else lines[after] + "\n"
            lines.insert(after + 1, f"{key} = {toml(value)}\n")
            text = "".join(lines)
        _put(wanted, header, key, value)
        self._take(text, wanted, path)

    def add(self, kind, **keys):
        """Adds a shape, motion, inlet, outlet, gauge or line at the end of the file: case.add("gauge", name="toe", at=["0.3 m", "0 m"])."""
        if kind not in NAMED:
            raise KeyError(f"there is no table {kind} of which there may be several; {nearest(kind, NAMED)}")
        keys = {key: _plain(value) for key, value in keys.items()}
        wanted = copy.deepcopy(self.data)
        wanted.setdefault(kind, []).append(keys)
        body = "".join(f"{key} = {toml(value)}\n" for key, value in keys.items())
        self._take(f"{self.text.rstrip()}\n\n[[{kind}]]\n{body}", wanted, kind)

    def _take(self, text, wanted, what):
        try:
            found = tomllib.loads(text)
        except tomllib.TOMLDecodeError:
            found = None
        if found != wanted:
            raise InputError(f"{what}: cannot be changed in this file; write the key in a line of its own under its [table]")
        self.text, self.data = text, found

    def save(self, path):
        """Writes the case to a file, or as case.toml into a folder, which is made. Files that shapes name are not copied."""
        path = pathlib.Path(path)
        file = path if path.suffix == ".toml" else path / "case.toml"
        try:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(self.text, encoding="utf-8")
        except OSError as error:
            raise InputError(f"{file}: cannot be written ({error.strerror}); give a folder that may be written") from error
        return file


def _plain(value):
    """The value as TOML has it: (0.005, "mm") is the text "5 mm"."""
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str) and not isinstance(value[0], str):
        return written(float(value[0]), value[1])
    if isinstance(value, (list, tuple)):
        return [_plain(each) for each in value]
    if hasattr(value, "item"):  # a number of NumPy
        return value.item()
    return value


def toml(value):
    """A text, number, flag or list as TOML."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    if isinstance(value, str):
        escaped = value.replace("\\", "\\\\").replace('"', '\\"')
        return '"' + "".join(c if c >= " " else f"\\u{ord(c):04x}" for c in escaped) + '"'
    if isinstance(value, (int, float)):
        return repr(value)
    raise InputError(f"{value!r}: is no value of a case; give a text with a unit, a number, a flag or a list")


def _put(data, header, key, value):
    name, index = header
    if name in NAMED:
        data[name][index][key] = value
        return
    here = data
    for part in name.split("."):
        here = here.setdefault(part, {})
    here[key] = value


def _statements(lines):
    """((header, index), key or None, first line, last line) of every header and key; values may go over several lines."""
    here, counts, at = ("", 0), {}, 0
    while at < len(lines):
        if header := HEADER.match(lines[at]):
            name = next(group for group in header.groups()[1:] if group is not None)
            here = (name, counts.get(name, 0))
            counts[name] = here[1] + 1
            yield here, None, at, at
        elif match := KEY.match(lines[at]):
            last = at
            while last + 1 < len(lines) and not _ends("".join(lines[at:last + 1]).split("=", 1)[1]):
                last += 1
            yield here, next(group for group in match.groups() if group is not None), at, last
            at = last
        at += 1


def _scan(text):
    """(place, character) outside of texts; comments end the line."""
    at = 0
    while at < len(text):
        mark = next((m for m in MULTILINE if text.startswith(m, at)), None)
        if mark:
            at = text.find(mark, at + 3)
            at = len(text) if at < 0 else at + 3
        elif text[at] in "\"'":
            quote, end = text[at], at + 1
            while end < len(text) and text[end] != quote:
                end += 2 if text[end] == "\\" and quote == '"' else 1
            at = end + 1
        elif text[at] == "#":
            yield at, "#"
            at = text.find("\n", at) if "\n" in text[at:] else len(text)
        else:
            yield at, text[at]
            at += 1


def _ends(value):
    """Whether the text of a value is complete: brackets are closed, and so are texts of several lines."""
    open_brackets = sum({"[": 1, "{": 1, "]": -1, "}": -1}.get(c, 0) for _, c in _scan(value))
    return open_brackets == 0 and all(value.count(mark) % 2 == 0 for mark in MULTILINE)


def _replaced(statement, value):
    """The statement with another value; what stands before it and the comment after it stay."""
    before = re.match(r"\s*(?:\"[^\"]*\"|'[^']*'|[\w-]+)\s*=\s*", statement).group()
    comments = [at for at, c in _scan(statement) if c == "#"]
    last_line = statement.rstrip("\n").rfind("\n") + 1
    behind = next((at for at in comments if at >= last_line), None)
    gap = ""
    if behind is not None:
        bare = statement[:behind]
        gap = bare[len(bare.rstrip()):] or " "
    return before + toml(value) + (gap + statement[behind:].rstrip("\n") if behind is not None else "") + "\n"
