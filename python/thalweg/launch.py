"""Runs and sweeps started from Python."""

import os
import pathlib
import shutil
import subprocess

from thalweg.case import Case, _plain, toml
from thalweg.faults import InputError
from thalweg.programs import Failed, call
from thalweg.results import Run, Table


def program():
    """The program `thalweg`: the one that the variable THALWEG names, or the one on the PATH."""
    named = os.environ.get("THALWEG") or shutil.which("thalweg")
    if not named or not pathlib.Path(named).is_file():
        raise InputError("thalweg is not on the PATH; add its folder to PATH, or let the variable THALWEG name the program")
    return pathlib.Path(named).resolve()


def _setting(key, value):
    value = _plain(value)
    return f"{key}={value if isinstance(value, str) else toml(value)}"


def _call(*words):
    try:
        return call(program(), *words).text
    except Failed as failed:
        if failed.status == 2:
            raise InputError(failed.error_line()) from failed
        raise


def run(case, out, settings=None, threads=None, foam=False, force=False, resume=False):
    """Runs a case and returns its Run. `case`: a folder with case.toml, or a Case, which is saved in OUT/case first.
    `settings`: key → value for this run alone. Raises InputError for a wrong case, RuntimeError for a run that failed."""
    out = pathlib.Path(out)
    if isinstance(case, Case):
        case = _saved(case, out.parent / f"{out.name}.case")
    words = ["run", case, "--out", out]
    for key, value in (settings or {}).items():
        words += ["--set", _setting(key, value)]
    words += ["--threads", str(threads)] if threads else []
    words += [flag for flag, wanted in (("--no-foam", not foam), ("--force", force), ("--resume", resume)) if wanted]
    _call(*words)
    return Run(out)


def _saved(case, folder):
    """The case in a folder of its own, with the files it names."""
    case.save(folder)
    for entry in [each for kind in case.data.values() if isinstance(kind, list) for each in kind]:
        name = entry.get("file")
        if name and case.folder and (case.folder / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(case.folder / name, folder / name)
    return folder


def sweep(case, out, vary, settings=None, repeats=1, measures=(), jobs=1, force=False, resume=False):
    """Runs all combinations of values, key → list, and returns sweep.csv as a Table (`thalweg sweep`)."""
    words = ["sweep", case, "--out", out, "--repeats", str(repeats), "--jobs", str(jobs)]
    for key, values in vary.items():
        words += ["--vary", f"{key}={','.join(str(_plain(value)) for value in values)}"]
    for key, value in (settings or {}).items():
        words += ["--set", _setting(key, value)]
    for measure in measures:
        words += ["--measure", measure]
    words += [flag for flag, wanted in (("--force", force), ("--resume", resume)) if wanted]
    _call(*words)
    return Table(pathlib.Path(out) / "sweep.csv")


def check(case):
    """What gencase says of a case without writing anything. Raises InputError for a case that it refuses."""
    return _call("gencase", case, "--check")


def version():
    """The version of the program."""
    return subprocess.run([program(), "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
