"""Thalweg from Python: cases, runs, sweeps, particle files and tables. The programs in Python use it too.

    import thalweg
    case = thalweg.Case.read("cases/louvain")
    case["numerics.spacing"] = "10 mm"
    run = thalweg.run(case, "out/coarse")
    run.series["scour"]

What needs NumPy is imported only when it is asked for, so that the programs run without it.
"""

import importlib

_FROM = {"Case": "case", "Run": "results", "Table": "results", "read_vtp": "vtp", "PolyData": "vtp", "run": "launch", "sweep": "launch",
         "check": "launch", "version": "launch", "program": "launch", "si": "units", "written": "units", "InputError": "faults"}
__all__ = sorted(_FROM)


def __getattr__(name):
    if name not in _FROM:
        raise AttributeError(f"module thalweg has no {name}")
    return getattr(importlib.import_module(f"thalweg.{_FROM[name]}"), name)


def __dir__():
    return __all__
