"""`thalweg sweep`: a case over all combinations of some values, with the scatter of equal runs and the convergence in the spacing."""

import pathlib
import sys
from dataclasses import dataclass, field

from study.runs import compute_all
from validation import engine, headline, sweep_page
from thalweg.faults import Arguments, InputError, answer, run_program, say
from validation.pages import origin
from validation.runs_folder import prepare
from validation.variations import combinations, variation

DEFAULT_MEASURES = ("scour", "front")  # those of them that the runs have; else the first quantity


@dataclass
class Member:
    """One run of the sweep: its values, its number among equal runs (0: as the case has it), and what was measured."""
    values: tuple
    equal: int
    run: object
    found: dict = field(default_factory=dict)   # headline quantities
    measured: dict = field(default_factory=dict)  # --measure → (value, unit)


def arguments():
    parser = Arguments(prog="thalweg sweep", description="Runs a case with all combinations of some values, and writes a table, pictures and a "
                                                         "page: scatter of equal runs, order of convergence.")
    parser.add_argument("case", type=pathlib.Path, metavar="CASE", help="folder with case.toml, or the file")
    parser.add_argument("--vary", action="append", required=True, metavar="KEY=V1,V2,…",
                        help="a key and its values, numerics.spacing=20,10,5mm; may be repeated")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="changes a key for all runs; may be repeated")
    parser.add_argument("--repeats", type=int, default=1, metavar="N",
                        help="runs of each combination, whose Courant numbers differ by some ten-thousandths (default: 1)")
    parser.add_argument("--measure", action="append", default=[], metavar="QUANTITY",
                        help="quantity of the pictures and the convergence: a column of sweep.csv, or FILE.csv:COLUMN:STATISTIC, as "
                             "history.csv:kinetic_energy:largest; may be repeated (default: scour and front)")
    parser.add_argument("--out", "-o", type=pathlib.Path, help="where runs and tables go (default: out/sweep/<folder of the case>)")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="runs at a time, one thread each (default: %(default)s)")
    resume = parser.add_mutually_exclusive_group()
    resume.add_argument("--resume", action="store_true", help="goes on with the runs in OUT; what is finished is not run again")
    resume.add_argument("--force", action="store_true", help="replaces the runs in OUT")
    return parser


def members(thalweg, given, case, variations, runs):
    """All runs of the sweep, in order, each checked by gencase."""
    made_by = {"build": engine.build(thalweg), "case": engine.case_content(case)}
    found = []
    for values in combinations(variations, given.repeats):
        settings = [*given.set, *(each.setting(variation.key) for variation, each in zip(variations, values))]
        name = ", ".join(f"{variation.key.split('.')[-1]} {each.text}" for variation, each in zip(variations, values))
        run = engine.PipelineRun(thalweg, runs, case, name, settings, made_by)
        try:
            run.check()
            equal = [run.equal(runs, f"{name}, equal {number}", number) for number in range(1, given.repeats)]
        except InputError as error:
            raise InputError(f"{name}: {error}") from error
        found += [Member(values, number, each) for number, each in enumerate([run, *equal])]
    folders = [member.run.folder for member in found]
    if len(set(folders)) < len(folders):
        raise InputError("thalweg sweep: two combinations have names that would share a folder; write their values with other words")
    return found


def checked(given):
    """The folder of the case, and what varies; all that can be wrong without a run."""
    case = given.case.parent if given.case.name == "case.toml" else given.case
    if not (case / "case.toml").is_file():
        raise InputError(f"{given.case}: has no case.toml; give the folder of a case")
    if given.jobs < 1 or given.repeats < 1:
        raise InputError("thalweg sweep: --jobs and --repeats count runs; give 1 or more")
    for text in given.measure:
        headline.asked(text)
    for text in given.set:
        if "=" not in text:
            raise InputError(f"--set {text}: sets nothing; write KEY=VALUE")
    variations = [variation(text) for text in given.vary]
    both = {text.split("=")[0].strip() for text in given.set} & {each.key for each in variations}
    if both:
        raise InputError(f"--set {both.pop()}: the key is varied, too; leave one of the two out")
    return case.resolve(), variations


def compute(run, names):
    """Makes a run. A measure that it does not have is told after the first run, and not after the last."""
    run.compute()
    if not run.failure:
        found = headline.quantities(run)
        for name in names:
            headline.measure(run, name, found)


def measure_all(found, given):
    """Fills in what the runs have; the names of the measures."""
    done = [member for member in found if not member.run.failure]
    for member in done:
        member.found = headline.quantities(member.run)
    if not done:
        return []
    names = given.measure or [name for name in DEFAULT_MEASURES if name in done[0].found] or list(done[0].found)[:1]
    for member in done:
        member.measured = {name: headline.measure(member.run, name, member.found) for name in names}
    return names


def sweep():
    given = arguments().parse_args()
    case, variations = checked(given)
    thalweg = engine.program()
    shown = given.out or pathlib.Path("out/sweep") / case.name
    out = shown.resolve()
    runs = out / "runs"
    found = members(thalweg, given, case, variations, runs)
    prepare(out, shown, given.resume, given.force)
    say(f"{len(found)} runs, {sum(member.run.complete() for member in found)} of them finished")
    compute_all([member.run for member in found], given.jobs, lambda run: compute(run, given.measure))
    names = measure_all(found, given)
    sweep_page.write(out, case.name, variations, found, names, given.repeats, origin(thalweg, case))
    failed = [member.run for member in found if member.run.failure]
    for run in failed:
        print(f"FAILED: {run.name}: {run.failure}", file=sys.stderr)
    say(f"{len(found) - len(failed)} of {len(found)} runs finished; table and page: {shown / 'sweep.csv'}, {shown / 'sweep.md'}")
    status = 1 if failed else 0
    answer({"status": status, "table": str(shown / "sweep.csv"), "page": str(shown / "sweep.md"), "runs": len(found),
            "failed": [run.name for run in failed]})
    return status


def main():
    sys.exit(run_program(sweep))
