"""Shared by all measurements: programs and their costs, runs that go on where they stopped, tables, particle files, records."""
