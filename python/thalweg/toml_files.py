"""TOML files, with the lines of tables and keys, which tomllib does not keep: for messages."""

import re
import tomllib

from thalweg.faults import InputError

HEADER = re.compile(r"^\s*(\[\[?)\s*(?:\"([^\"]*)\"|'([^']*)'|([^\]\s]+))\s*\]\]?")
KEY = re.compile(r"^\s*(?:\"([^\"]*)\"|'([^']*)'|([\w-]+))\s*=")
MULTILINE = ('"""', "'''")


class Lines:
    """`table(name, index)` and `key(name, key, index)` give the number of a line; index counts the tables of one name."""

    def __init__(self, text):
        self._tables, self._keys = {}, {}
        here, counts, inside = ("", 0), {}, None
        for number, line in enumerate(text.splitlines(), 1):
            if inside:
                inside = None if inside in line else inside
                continue
            if match := HEADER.match(line):
                name = next(group for group in match.groups()[1:] if group is not None)
                here = (name, counts.get(name, 0))
                counts[name] = here[1] + 1
                self._tables[here] = number
            elif match := KEY.match(line):
                key = next(group for group in match.groups() if group is not None)
                self._keys.setdefault((*here, key), number)
                inside = next((mark for mark in MULTILINE if line.count(mark) % 2), None)

    def table(self, name, index=0):
        return self._tables.get((name, index), 1)

    def key(self, name, key, index=0):
        return self._keys.get((name, index, key), self.table(name, index))


def read_toml(file, shown):
    try:
        text = file.read_text(encoding="utf-8")
        return tomllib.loads(text), text
    except OSError as error:
        raise InputError(f"{shown}: cannot be read ({error.strerror}); give a file that is there") from error
    except UnicodeDecodeError as error:
        raise InputError(f"{shown}: is not UTF-8; save it as UTF-8") from error
    except tomllib.TOMLDecodeError as error:
        words = str(error).removesuffix(")").rsplit(" (at line ", 1)
        line = words[1].split(",")[0] if len(words) == 2 else str(text.count("\n") + 1)
        raise InputError(f"{shown}:{line}: {words[0].rstrip('.').lower()}; correct the TOML there") from error
