"""`thalweg import`: a definition of DualSPHysics' GenCase becomes a folder with a commented case.toml (docs/import.md)."""

import pathlib
import re
import sys

from thalweg.faults import Arguments, InputError, answer, run_program, say
from thalweg.importing.document import convert
from thalweg.importing.xml_tree import read_xml


def arguments():
    parser = Arguments(prog="thalweg import", description="Writes a case from a case definition of DualSPHysics' GenCase (_Def.xml), and lists "
                                                          "by line what has no counterpart.")
    parser.add_argument("definition", type=pathlib.Path, metavar="FILE", help="the definition, Case_Def.xml")
    parser.add_argument("--out", "-o", type=pathlib.Path, metavar="FOLDER", help="folder of the case; default: the name of the file")
    parser.add_argument("--force", action="store_true", help="writes over the case that the folder holds")
    parser.add_argument("--rigid", action="store_true", help="makes floating bodies fixed walls instead of refusing them")
    return parser


def case_name(file):
    """The name of the case: that of the file without _Def, fit for a folder."""
    return re.sub(r"[^A-Za-z0-9_.-]+", "_", re.sub(r"_?Def$", "", file.stem)).strip("._-") or "case"


def write(imported, folder):
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in imported.files.items():
            (folder / name).write_bytes(content)
        (folder / "case.toml").write_text(imported.text, encoding="utf-8")
    except OSError as error:
        raise InputError(f"{folder}: cannot be written ({error.strerror}); give a folder that may be written with --out") from error


def import_case():
    given = arguments().parse_args()
    if given.definition.is_dir():
        raise InputError(f"{given.definition}: is a folder; give the file _Def.xml in it")
    name = case_name(given.definition)
    folder = given.out or pathlib.Path(name)
    if (folder / "case.toml").exists() and not given.force:
        raise InputError(f"{folder}: holds a case already; give --out FOLDER, or --force to write over it")
    imported = convert(read_xml(given.definition, str(given.definition)), given.definition.parent, given.definition.name, name, given.rigid)
    write(imported, folder)
    for line, text in imported.remarks:
        say(f"{given.definition}:{line}: {text}")
    counted = ", ".join(f"{number} {what}" for what, number in imported.counts.items() if number)
    answer({"status": 0, "case": str(folder / "case.toml"), "counts": imported.counts,
            "remarks": [{"line": line, "message": text} for line, text in imported.remarks]})
    say(f"{folder / 'case.toml'}: {counted}; {len(imported.remarks) or 'no'} remarks. Look at it, then thalweg gencase {folder} --check")
    return 0


def main():
    sys.exit(run_program(import_case))
