"""The folder of many runs: neither replaced nor gone on with unasked."""

import shutil

from thalweg.faults import InputError


def prepare(out, shown, resume, force):
    """The folder of the runs below `out`, which messages call `shown`."""
    runs = out / "runs"
    if out.exists() and not out.is_dir():
        raise InputError(f"{shown}: is no folder; give another --out")
    if runs.exists() and any(runs.iterdir()):
        if force:
            shutil.rmtree(runs)
        elif not resume:
            raise InputError(f"{shown}: holds runs; go on with them with --resume, replace them with --force, or give another --out")
    runs.mkdir(parents=True, exist_ok=True)
    return runs
