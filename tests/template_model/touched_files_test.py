#!/usr/bin/env python3
"""ARCHITECTURE.md says which files one touches to add an array, a case key, a law or a model: touched_files_test.py ROOT

The template model (tests/template_model) compiles with the solver as it is. So the files that name it are the files that
a model costs, and the page has to list just those.
"""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else ".").resolve()
TEMPLATE = "tests/template_model"
# Where the template's files lie once it is copied into the solver and the case.
HOME = {f"{TEMPLATE}/tracer/model.hpp": "solver/models/NAME/model.hpp",
        f"{TEMPLATE}/tracer/table.hpp": "case/tables/NAME.hpp",
        f"{TEMPLATE}/solver/models/list.hpp": "solver/models/list.hpp"}
# What the template does not need, because its test makes the scene by hand and has a case of its own.
BY_HAND = {"solver/models/NAME/make.cpp", "case/case.hpp"}


def listed_files(heading):
    """The files in the list under "**A model**" … of ARCHITECTURE.md: the code spans that open its bullet points."""
    page = (ROOT / "ARCHITECTURE.md").read_text()
    section = re.search(rf"^### {re.escape(heading)}\n(.*?)(?=^### |^## )", page, re.MULTILINE | re.DOTALL)
    if section is None:
        raise AssertionError(f"ARCHITECTURE.md has no section '{heading}'")
    return [match[1] for match in re.finditer(r"^- `([^`]+)`", section[1], re.MULTILINE)]


class TouchedFiles(unittest.TestCase):
    def test_a_model_costs_the_files_that_the_page_lists(self):
        named = {path.relative_to(ROOT).as_posix()
                 for folder in ("case", "common", "gencase", "physics", "solver", "postproc", "foam_reference", TEMPLATE)
                 for path in (ROOT / folder).rglob("*")
                 if path.suffix in (".hpp", ".cpp", ".cu", ".cuh") and "tracer" in path.read_text().lower()}
        named -= {f"{TEMPLATE}/template_model_test.cpp"}
        self.assertEqual(named, set(HOME), "files that name the template model")
        self.assertEqual(set(listed_files("A model")), set(HOME.values()) | BY_HAND)

    def test_the_list_is_the_solvers_and_one_model_more(self):
        def models(name):
            return re.findall(r"\w+", re.search(r"ModelList<([^>]*)>", (ROOT / name).read_text())[1])

        solvers = models("solver/models/list.hpp")
        self.assertGreater(len(solvers), 5)
        self.assertEqual(models(f"{TEMPLATE}/solver/models/list.hpp"), [*solvers, "TracerModel"])

    def test_the_listed_files_exist(self):
        for heading in ("An array", "A case key", "A material law", "A model", "A case table"):
            for name in listed_files(heading):
                with self.subTest(heading=heading, file=name):
                    if "NAME" not in name:
                        self.assertTrue((ROOT / name).exists(), f"{name} in '{heading}' does not exist")
                    else:
                        self.assertTrue((ROOT / name).parent.parent.is_dir() or (ROOT / name).parent.is_dir())

    def test_an_array_costs_one_file(self):
        files = listed_files("An array")
        self.assertEqual(files, ["solver/models/NAME/model.hpp"])
        # The template's array is declared and described in that file alone.
        text = (ROOT / TEMPLATE / "tracer/model.hpp").read_text()
        self.assertIn("v.array(field::tracer, tracer", text)
        self.assertIn("v.shown(", text)

    def test_a_key_costs_one_file(self):
        self.assertEqual(listed_files("A case key"), ["case/tables/NAME.hpp"])
        # A key of a table stands in its table's file and where it is read, nowhere in the readers.
        for key in ("checkpoint_interval", "wall_friction", "excluded_limit"):
            readers = [path for path in (ROOT / "case/reader").rglob("*") if path.is_file() and key in path.read_text()]
            self.assertEqual(readers, [], f"{key} is named in case/reader")


if __name__ == "__main__":
    unittest.main()
