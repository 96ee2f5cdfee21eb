"""An XML file as a tree that knows its lines, without entities and document types: bad input is one line, not a bomb."""

import re
import xml.parsers.expat
from dataclasses import dataclass, field

from thalweg.faults import InputError

LARGEST = 20_000_000  # [bytes] of a definition; those of GenCase have some ten thousand
DEEPEST = 60
COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
QUOTED = re.compile(r'="[^"]*"')
BARE_AND = re.compile(r"&(?!#?\w+;)")


@dataclass
class Node:
    """An element: its name, attributes, text, children and line."""
    tag: str
    attributes: dict
    line: int
    children: list = field(default_factory=list)
    text: str = ""

    def find(self, path):
        """The first element at a path as a/b/c, or None."""
        here = self
        for tag in path.split("/"):
            here = next((child for child in here.children if child.tag == tag), None)
            if here is None:
                return None
        return here

    def all(self, tag):
        return [child for child in self.children if child.tag == tag]

    def get(self, name, default=None):
        return self.attributes.get(name, default)

    def active(self):
        """GenCase leaves out what is marked so; a tag that begins with _ it leaves out too."""
        return self.get("active", "true").strip().lower() not in ("false", "0")


def read_xml(file, shown):
    """The root of the file. GenCase's own reader takes <!---x---> for a comment, and < and & in values as they stand; XML does not."""
    try:
        if file.stat().st_size > LARGEST:
            raise InputError(f"{shown}: has more than {LARGEST // 1_000_000} MB; give a case definition (_Def.xml), not results")
        text = file.read_text(encoding="utf-8-sig", errors="replace")
    except OSError as error:
        raise InputError(f"{shown}: cannot be read ({error.strerror}); give a definition (_Def.xml) that is there") from error
    plain = COMMENT.sub(lambda found: "\n" * found.group().count("\n"), text)
    plain = QUOTED.sub(lambda found: BARE_AND.sub("&amp;", found.group()).replace("<", "&lt;"), plain)
    return _parsed(plain, shown)


def _parsed(text, shown):
    parser = xml.parsers.expat.ParserCreate("UTF-8")
    top = Node("", {}, 0)
    stack = [top]

    def begin(tag, attributes):
        if len(stack) > DEEPEST:
            raise InputError(f"{shown}:{parser.CurrentLineNumber}: elements are nested more than {DEEPEST} deep; give a case definition")
        node = Node(tag, attributes, parser.CurrentLineNumber)
        stack[-1].children.append(node)
        stack.append(node)

    def end(_):
        stack.pop()

    def characters(data):
        stack[-1].text += data

    def refuse(*_):
        raise InputError(f"{shown}:{parser.CurrentLineNumber}: declares a document type, which no case definition needs; take <!DOCTYPE …> out")

    parser.StartElementHandler, parser.EndElementHandler, parser.CharacterDataHandler = begin, end, characters
    parser.StartDoctypeDeclHandler = refuse
    try:
        parser.Parse(text.encode(), True)
    except xml.parsers.expat.ExpatError as error:
        words = xml.parsers.expat.errors.messages[error.code]
        raise InputError(f"{shown}:{error.lineno}: is no proper XML ({words}); correct it there") from error
    except (UnicodeError, ValueError) as error:
        raise InputError(f"{shown}: is no proper XML ({error}); save it as UTF-8") from error
    return top.children[0]
