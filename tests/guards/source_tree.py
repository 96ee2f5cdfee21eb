"""Which files of the repository are sources, and where violations are reported; shared by the checks beside it."""

import pathlib
import subprocess
import sys

ROOMS = ("physics", "common", "case", "gencase", "solver", "postproc", "foam_reference", "tests", "bench")
HEADERS = (".hpp", ".cuh")
UNITS = (".cpp", ".cu")
FOAM = (".H", ".C")  # what wmake compiles, in OpenFOAM's own suffixes


def sources(root, suffixes=HEADERS + UNITS + FOAM, rooms=ROOMS):
    """C++ and CUDA files of the rooms, in a fixed order, whether git knows them yet or not."""
    root = pathlib.Path(root)
    return sorted(path for room in rooms for path in (root / room).rglob("*") if path.suffix in suffixes)


def tracked_files(root):
    """(path, executable) of every file in git's index, or of every file outside build folders when this is no clone."""
    root = pathlib.Path(root)
    listing = subprocess.run(["git", "-c", f"safe.directory={root}", "-C", root, "ls-files", "--stage", "-z"],
                             capture_output=True, text=True)
    if (root / ".git").exists() and listing.returncode == 0:
        for entry in filter(None, listing.stdout.split("\0")):
            mode, name = entry.split(" ", 1)[0], entry.split("\t", 1)[1]
            if mode != "120000" and (root / name).is_file():
                yield root / name, mode == "100755"
        return
    for path in sorted(root.rglob("*")):
        if path.is_file() and path.relative_to(root).parts[0] not in ("build", "out", ".git", ".cache"):
            yield path, bool(path.stat().st_mode & 0o111)


def report(violations, checked):
    """Prints violations ("file:line: what; what to do") and returns the exit status."""
    for violation in violations:
        print(violation, file=sys.stderr)
    print(f"{checked} files checked, {len(violations)} violations")
    if checked == 0:
        print("nothing was checked: is the root right?", file=sys.stderr)
    return 1 if violations or checked == 0 else 0
