#!/usr/bin/env python3
"""The static analysis itself, on a unit with planted mistakes: test_static_analysis.py CLANG_TIDY PLUGIN"""

import contextlib
import io
import json
import os
import pathlib
import shutil
import sys
import tempfile
import unittest

import static_analysis

CLANG_TIDY, PLUGIN = sys.argv[1:3]
CHECKS = pathlib.Path(__file__).resolve().parents[2] / ".clang-tidy"

HEADER = """#pragma once

#include <string>
#include <vector>

#include <library.hpp>

template <class T>
T first(const std::vector<T>& all) {
  return all.front();
}
"""
UNIT = """#include "common/law.hpp"

std::string law() { return first(std::vector<std::string>{"law"}); }
"""
LIBRARY = """#pragma once
inline int BadName(int* p) { return p == 0 ? 0 : *p; }
"""
# A check, the file that gets the mistake, and the mistake.
MISTAKES = {
    "readability-identifier-naming": ("common/law.hpp", "inline int BadName() { return 1; }\n"),
    "modernize-use-nullptr": ("common/law.hpp", "inline int* none() { return 0; }\n"),
    "bugprone-use-after-move": ("common/law.cpp", "#include <utility>\nstd::size_t moved(std::string a) {\n"
                                                  "  const std::string b = std::move(a);\n  return a.size() + b.size();\n}\n"),
    "performance-for-range-copy": ("common/law.cpp", "std::size_t sum(const std::vector<std::string>& all) {\n"
                                                     "  std::size_t n = 0;\n  for (const auto one : all) n += one.size();\n"
                                                     "  return n;\n}\n"),
}


class StaticAnalysis(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp(prefix="thalweg-analysis-")).resolve()
        self.addCleanup(shutil.rmtree, self.root)
        for folder in ("common", "library", "build"):
            (self.root / folder).mkdir()
        shutil.copy(CHECKS, self.root / ".clang-tidy")
        (self.root / "common/law.hpp").write_text(HEADER)
        (self.root / "common/law.cpp").write_text(UNIT)
        (self.root / "library/library.hpp").write_text(LIBRARY)
        unit = self.root / "common/law.cpp"
        (self.root / "build/compile_commands.json").write_text(json.dumps([{
            "directory": str(self.root / "build"), "file": str(unit),
            "command": f"c++ -I{self.root} -isystem {self.root}/library -std=c++20 -Wall -o law.o -c {unit}"}]))

    def findings(self):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            status = static_analysis.check(self.root, self.root / "build", self.root / "build", CLANG_TIDY, PLUGIN)
        return status, said.getvalue()

    def test_a_clean_unit_passes_whatever_its_libraries_do(self):
        status, said = self.findings()
        self.assertEqual(status, 0, said)

    def test_every_planted_mistake_is_found_in_its_file(self):
        for name, text in (("common/law.hpp", HEADER), ("common/law.cpp", UNIT)):
            planted = {check: mistake for check, (file, mistake) in MISTAKES.items() if file == name}
            (self.root / name).write_text(text + "\n" + "\n".join(planted.values()))
            status, said = self.findings()
            self.assertEqual(status, 1)
            for check in planted:
                with self.subTest(check=check):
                    self.assertTrue(any(line.startswith(f"{self.root / name}:") and f"[{check}" in line
                                        for line in said.splitlines()), said)
            (self.root / name).write_text(text)

    def test_a_unit_that_does_not_compile_fails(self):
        (self.root / "common/law.cpp").write_text("int law( {\n")
        self.assertEqual(self.findings()[0], 1)


class Memory(unittest.TestCase):
    """A unit counts as analysed while nothing that it was built from has changed."""

    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp(prefix="thalweg-analysis-")).resolve()
        self.addCleanup(shutil.rmtree, self.root)
        self.files = [self.root / "law.cpp", self.root / "law.hpp"]
        for file in (*self.files, self.root / "law.o"):
            file.write_text("one\n")
            os.utime(file, (1000, 1000))

    def mark(self, command="c++ -o law.o -c law.cpp"):
        entry = {"directory": str(self.root), "file": "law.cpp", "command": command}
        return static_analysis.fingerprint(entry, self.root / "law.o", self.files, static_analysis.Digests(self.root), b"checks")

    def test_content_and_flags_count(self):
        before = self.mark()
        self.assertEqual(self.mark(), before)
        self.assertNotEqual(self.mark("c++ -O3 -o law.o -c law.cpp"), before)
        self.files[1].write_text("two\n")
        os.utime(self.files[1], (1000, 1000))
        self.assertNotEqual(self.mark(), before)

    def test_files_newer_than_the_object_are_not_trusted(self):
        self.files[1].touch()
        self.assertIsNone(self.mark())

    def test_a_unit_that_was_never_built_is_not_trusted(self):
        self.files = []
        self.assertIsNone(self.mark())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
