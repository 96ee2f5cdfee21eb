"""`thalweg validate`: runs cases, measures them against nature, and writes one page with numbers and verdicts."""

import pathlib
import sys

from study.runs import compute_all
from validation import engine, outcome, pages
from validation.expected import NAME, read_expected
from thalweg.faults import Arguments, InputError, answer, run_program, say
from validation.finished import Finished
from validation.measure_reference import reference_page
from validation.runs_folder import prepare

CASES = pathlib.Path("cases")


def arguments():
    parser = Arguments(prog="thalweg validate", description="Runs cases, measures them against what is known of nature (expected.toml of "
                                                            "each case), and writes tables with errors, uncertainties and verdicts.")
    parser.add_argument("cases", nargs="*", type=pathlib.Path, metavar="CASE",
                        help=f"folders of cases; default: all below {CASES} that have an {NAME}")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/validation"), help="where runs and tables go (default: %(default)s)")
    parser.add_argument("--full", action="store_true", help="also the runs marked as full: hours")
    parser.add_argument("--no-repeats", action="store_true", help="without the repeated runs that show the scatter")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="runs at a time, one thread each (default: %(default)s)")
    resume = parser.add_mutually_exclusive_group()
    resume.add_argument("--resume", action="store_true", help="goes on with the runs in OUT; what is finished is not run again")
    resume.add_argument("--force", action="store_true", help="replaces the runs in OUT")
    parser.add_argument("--page", type=pathlib.Path, metavar="FILE", help="writes the page also there, without links to reports")
    parser.add_argument("--add", action="store_true", help="with --page: keeps the sections of other cases that FILE holds")
    parser.add_argument("--measures", action="store_true", help=f"prints the keys of {NAME} and all measures as the page docs/expected.md")
    return parser


def chosen(given):
    folders = given or sorted(file.parent for file in CASES.glob(f"*/{NAME}"))
    if not folders:
        raise InputError(f"{CASES}: there is no case with an {NAME} here; give folders of cases")
    found = [read_expected(folder.parent if folder.name == "case.toml" else folder, str(folder).removesuffix("/case.toml")) for folder in folders]
    for expected in found:
        if not expected.name:
            expected.case = expected.case.resolve()
            expected.name = expected.case.name
    names = [expected.name for expected in found]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise InputError(f"{twice}: two cases have this name, and their runs would share a folder; give one of them")
    return found


def plan_runs(thalweg, expected, folder, full, repeated):
    """(RunPlan, run, its repeats) of a case; every run is checked by gencase."""
    made_by = {"build": engine.build(thalweg), "case": engine.case_content(expected.case)}
    planned = []
    for plan in expected.runs:
        if plan.full and not full:
            continue
        run = engine.PipelineRun(thalweg, folder / expected.name, expected.case, plan.name, plan.set, made_by)
        try:
            run.check()
            repeats = [run.equal(folder / expected.name, f"{plan.name}, equal {number}", number)
                       for number in range(1, 1 + plan.repeats if repeated else 1)]
        except InputError as error:
            raise InputError(f"{expected.file}:{plan.line}: run {plan.name}: {error}") from error
        planned.append((plan, run, repeats))
    folders = [member.folder for _, run, repeats in planned for member in (run, *repeats)]
    twice = next((each for each in folders if folders.count(each) > 1), None)
    if twice is not None:
        raise InputError(f"{expected.file}: the names of two runs give the same folder {twice.name}; write one of them with other letters")
    return planned


def compute(run, plan, expected):
    """Makes a run. A column that it does not have is told after the first run, and not after the last."""
    run.compute()
    if not run.failure:
        finished = Finished(run)
        for entry in expected.entries:
            if entry.concerns(plan):
                outcome.measured(finished, entry, None)


def validate():
    given = arguments().parse_args()
    if given.measures:
        print(reference_page(), end="")
        return 0
    if given.jobs < 1:
        raise InputError(f"thalweg validate: --jobs is {given.jobs}; give 1 or more")
    if given.add and not given.page:
        raise InputError("thalweg validate: --add goes with --page; give the page that sections are added to")
    cases = chosen(given.cases)
    thalweg = engine.program()
    out = given.out.resolve()
    runs = out / "runs"
    planned = [(expected, plan_runs(thalweg, expected, runs, given.full, not given.no_repeats)) for expected in cases]
    for expected, found in planned:
        if not found:
            say(f"{expected.name}: all its runs are long; make them with --full")
    planned = [(expected, found) for expected, found in planned if found]
    if not planned:
        return 0
    prepare(out, given.out, given.resume, given.force)
    rows = []
    for expected, found in planned:
        plans = {member: plan for plan, run, repeats in found for member in (run, *repeats)}
        compute_all(list(plans), given.jobs, lambda run, plans=plans, expected=expected: compute(run, plans[run], expected))
        for row in outcome.rows_of(expected, found):
            rows.append(row)
            say(pages.line(row))
    pages.write(out, planned, rows, pages.origin(thalweg, planned[0][0].case), given.page, given.add)
    failed = [row for row in rows if row.verdict == outcome.FAIL]
    misfits = [row for row in rows if row.verdict == outcome.MISFIT]
    passed = sum(row.verdict == outcome.PASS for row in rows)
    without = sum(row.verdict == outcome.NO_VERDICT for row in rows)
    say(f"{len(rows)} figures: {passed} pass, {len(misfits)} known misfits, {len(failed)} fail, {without} without a verdict")
    say(f"page: {given.out / 'validation.md'}")
    status = 1 if failed else 0
    answer({"status": status, "page": str(given.out / "validation.md"), "figures": len(rows), "pass": passed, "misfit": len(misfits),
            "fail": len(failed), "no_verdict": without})
    return status


def main():
    sys.exit(run_program(validate))
