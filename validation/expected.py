"""Reads a case's expected.toml: which runs are made, what is measured of them, and what must hold (docs/expected.md)."""

from dataclasses import dataclass, field

import validation.bed_measures  # noqa: F401  each fills the library
import validation.column_measures  # noqa: F401
import validation.law_measures  # noqa: F401
import validation.particle_measures  # noqa: F401
import validation.profile_measures  # noqa: F401
from thalweg.faults import InputError, nearest
from validation.keys import Key, check
from validation.library import MEASURES
from validation.references import Reference
from thalweg.toml_files import Lines, read_toml

NAME = "expected.toml"

RUN_KEYS = (
    Key("name", "text", "names the run in tables and folders", required=True),
    Key("set", "texts", "keys of the case that it changes, as with --set"),
    Key("variant", "text", "runs of one variant differ in the spacing alone: over them the order of convergence is taken"),
    Key("full", "flag", "true: only with --full"),
    Key("repeats", "count", "further runs, whose Courant numbers differ by some ten-thousandths, for the scatter"),
)

ENTRY_KEYS = (
    Key("measure", "text", "the word of a measure, below; it brings keys of its own", required=True),
    Key("title", "text", "the quantity in words; default: the table's name"),
    Key("unit", "text", "of the quantity", required=True),
    Key("runs", "texts", "names of the runs that it is measured of; default: all"),
    Key("error", "text", "what is held against the limit: largest (default), rmse or bias, over all points", words=("largest", "rmse", "bias")),
    Key("relative_to", "scale", "the error is divided by it before it is held against the limit: a number, reference (each point's own), "
                                "range or rms of the known values, spacing"),
    Key("limit", "limit", "most that the error may be; without one there is no verdict, and the page says so"),
    Key("uncertainty", "limit", "of the data, in the unit of the limit"),
    Key("uncertainty_of", "text", "where the uncertainty comes from"),
    Key("reason", "text", "why that limit, or why none", required=True),
    Key("known_misfit", "text", "why the limit is not met; shown as such, never as pass"),
    Key("misfit_limit", "limit", "most that a known misfit may be: beyond it has become worse, and the verdict is fail"),
)


@dataclass
class RunPlan:
    name: str = "as it is"
    set: list = field(default_factory=list)
    variant: str = ""
    full: bool = False
    repeats: int = 0
    line: int = 1


@dataclass
class Entry:
    """A quantity: the keys as given, the measure, and what is known."""
    name: str
    given: dict
    folder: object          # of the case
    lines: Lines
    shown_file: str
    measure: object = None
    reference: Reference = None

    def at(self, key=None):
        """"file:line" of a key, or of the table."""
        return f"{self.shown_file}:{self.lines.table(self.name) if key is None else self.lines.key(self.name, key)}"

    @property
    def title(self):
        return self.given.get("title", self.name.replace("_", " "))

    def concerns(self, run):
        return "runs" not in self.given or run.name in self.given["runs"]


@dataclass
class Expected:
    case: object            # folder
    name: str
    file: str               # as shown
    runs: list
    entries: list


def read_runs(table, lines, shown):
    given = table.get("run", [])
    if not isinstance(given, list) or not all(isinstance(entry, dict) for entry in given):
        raise InputError(f"{shown}:{lines.table('run')}: [run] is no list of runs; write [[run]]")
    plans, names = [], set()
    for number, entry in enumerate(given):
        def where(key, number=number):
            return f"{shown}:{lines.table('run', number) if key is None else lines.key('run', key, number)}"
        check(entry, RUN_KEYS, where)
        if entry["name"] in names:
            raise InputError(f"{where('name')}: the run {entry['name']} stands here twice; give each run a name of its own")
        names.add(entry["name"])
        for setting in entry.get("set", []):
            if "=" not in setting:
                raise InputError(f"{where('set')}: {setting!r} sets nothing; write KEY=VALUE, as with --set")
        plans.append(RunPlan(**entry, line=lines.table("run", number)))
    return plans or [RunPlan()]


def read_entry(name, given, folder, lines, shown, runs):
    entry = Entry(name, given, folder, lines, shown)
    if not isinstance(given, dict):
        raise InputError(f"{shown}:{lines.key('', name)}: {name} stands in no table; write [{name}] with the keys of a quantity")
    word = given.get("measure")
    if word is None:
        raise InputError(f"{entry.at()}: measure is missing; give it: the word of a measure (docs/expected.md)")
    if not isinstance(word, str) or word not in MEASURES:
        raise InputError(f"{entry.at('measure')}: there is no measure {word!r}; {nearest(str(word), list(MEASURES))}")
    entry.measure = MEASURES[word]
    check(given, ENTRY_KEYS + entry.measure.keys, entry.at)
    for run in given.get("runs", []):
        if run not in [plan.name for plan in runs]:
            raise InputError(f"{entry.at('runs')}: there is no run {run}; {nearest(run, [plan.name for plan in runs])}")
    if ("known_misfit" in given) != ("misfit_limit" in given):
        there, missing = ("known_misfit", "misfit_limit") if "known_misfit" in given else ("misfit_limit", "known_misfit")
        raise InputError(f"{entry.at(there)}: {there} stands without {missing}; give both, so that a misfit that grows is seen")
    if "misfit_limit" in given and given["misfit_limit"] <= given.get("limit", float("inf")):
        raise InputError(f"{entry.at('misfit_limit')}: misfit_limit is not above limit; give the limit a number below it")
    if entry.measure.has_reference:
        entry.reference = Reference(entry)
        if "limit" in given and entry.reference.columns == 0:
            raise InputError(f"{entry.at('limit')}: limit has nothing to be measured from; give value, between or reference")
        columns = given.get("column")
        if entry.reference.columns > 1 and (not isinstance(columns, list) or len(columns) != entry.reference.columns):
            raise InputError(f"{entry.at()}: there are {entry.reference.columns} columns of known values; give as many in column")
    return entry


def read_expected(folder, shown):
    """The Expected of the case in a folder; `shown` is the folder as messages write it."""
    file = folder / NAME
    shown_file = f"{shown}/{NAME}"
    if not (folder / "case.toml").is_file():
        raise InputError(f"{shown}: has no case.toml; give the folder of a case")
    table, text = read_toml(file, shown_file)
    lines = Lines(text)
    runs = read_runs(table, lines, shown_file)
    entries = [read_entry(name, given, folder, lines, shown_file, runs) for name, given in table.items() if name != "run"]
    if not entries:
        raise InputError(f"{shown_file}: has no quantity; add a table for each, such as [front]")
    return Expected(folder, folder.name, shown_file, runs, entries)
