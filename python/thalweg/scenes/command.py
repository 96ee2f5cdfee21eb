"""`thalweg new`: writes a commented case.toml of a scene that runs as it is (docs/tutorial.md)."""

import importlib.resources
import pathlib
import re
import sys

from thalweg.case import Case
from thalweg.faults import Arguments, InputError, answer, nearest, run_program, say

SCENES = {
    "walljet": "a jet under a gate, over an apron and a bed of sand",
    "pier": "a round pier in a current over sand, in space",
    "channel": "a current over a bed of sand, between an inlet and a tail water",
    "dam-break": "a reservoir let go over a bed of light grains",
    "column": "a column of dry sand let go",
    "dike": "a dike of sand that is overtopped",
}
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]{0,79}$")


def text_of(scene):
    return importlib.resources.files("thalweg.scenes").joinpath(f"{scene}.toml").read_text(encoding="utf-8")


def arguments():
    parser = Arguments(prog="thalweg new", description="Writes a commented case that runs as it is; change it to your own scene. Scenes: "
                                                       + "; ".join(f"{name}: {what}" for name, what in SCENES.items()) + ".")
    parser.add_argument("case", type=pathlib.Path, metavar="CASE", help="folder of the new case; its name names the case")
    parser.add_argument("--from", dest="scene", default="walljet", metavar="SCENE", help=f"{', '.join(SCENES)} (default: %(default)s)")
    parser.add_argument("--force", action="store_true", help="writes over the case that the folder holds")
    return parser


def new():
    given = arguments().parse_args()
    if given.scene not in SCENES:
        raise InputError(f"thalweg new: there is no scene {given.scene}; {nearest(given.scene, SCENES)}")
    name = given.case.resolve().name
    if not NAME.match(name):
        raise InputError(f"{given.case}: cannot name a case; use letters, digits, \"-\", \"_\" and \".\"")
    file = given.case / "case.toml"
    if file.exists() and not given.force:
        raise InputError(f"{given.case}: holds a case already; give another folder, or --force to write over it")
    if given.case.exists() and not given.case.is_dir():
        raise InputError(f"{given.case}: is a file; give a folder that is not there yet")
    case = Case(text_of(given.scene))
    case["case.name"] = name
    case.save(given.case)
    answer({"status": 0, "case": str(file)})
    say(f"{file}: {SCENES[given.scene]}. Lines marked with <- are the first to change. Next:\n"
        f"  thalweg gencase {given.case} --check\n  thalweg run {given.case} --no-foam")
    return 0


def main():
    sys.exit(run_program(new))
