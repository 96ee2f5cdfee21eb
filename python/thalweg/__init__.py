"""Thalweg from Python: cases, runs, sweeps, particle files and tables. The programs in Python use it too.

What needs NumPy is imported only when it is asked for, so that the programs run without it.
"""
