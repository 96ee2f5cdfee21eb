#!/usr/bin/env python3
"""The checks themselves, on trees with one mistake planted: each has to be found, and the tree without it to pass."""

import json
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import formatting
import headers
import includes
import links
import readability
import tracked_files

CLEAN = {
    "common/particles.hpp": '#pragma once\n\n#include <vector>\n\n#include "physics/law.hpp"\n',
    "common/io/file.hpp": '#pragma once\n\n#include "common/particles.hpp"\n',
    "common/io/file.cpp": '#include "common/io/file.hpp"\n\n#include <vtkPolyData.h>\n',
    "gencase/fill.cpp": '#include <CGAL/Surface_mesh.h>\n\n#include "common/io/file.hpp"\n',
    "physics/law.hpp": "#pragma once\n\n#include <cmath>\n",
    "solver/state/record.hpp": '#pragma once\n\n#include "physics/law.hpp"\n',
    "solver/passes/pass.hpp": '#pragma once\n\n#include "solver/state/record.hpp"\n',
    "solver/backend/device.cu": '#include "solver/state/record.hpp"\n\n#include <cuda_runtime.h>\n\n'
                                "void launch() { sweep<<<1, 2>>>(); cudaDeviceSynchronize(); }\n",
    "solver/step.hpp": '#pragma once\n\n#include "solver/passes/pass.hpp"\n',
    "postproc/surface.cpp": "#include <vtkPolyData.h>\n",
    "foam_reference/write.cpp": '#include "common/particles.hpp"\n',
    "tests/any.cpp": '#include <CGAL/Surface_mesh.h>\n\n#include "solver/step.hpp"\n',
}


class Tree(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp(prefix="thalweg-guards-")).resolve()
        self.addCleanup(shutil.rmtree, self.root)
        for name, text in CLEAN.items():
            self.write(name, text)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


class Links(Tree):
    def test_links_that_lead_nowhere(self):
        self.write("docs/b.md", "# Two words\n")
        self.write("README.md", "[a](docs/b.md) [b](docs/b.md#two-words) [c](docs) [d](https://nowhere.example) [e](#the-end)\n\n## The end\n")
        self.assertEqual(links.check(self.root), ([], 2))
        self.write("docs/c.md", "[a](b.md)\n[b](none.md)\n[c](b.md#three-words)\n")
        violations, _ = links.check(self.root)
        self.assertEqual([violation.split(";")[0] for violation in violations],
                         ["docs/c.md:2: the link none.md leads nowhere", "docs/c.md:3: b.md has no heading three-words"])


class Includes(Tree):
    def found(self):
        violations, checked = includes.check(self.root)
        self.assertGreaterEqual(checked, len(CLEAN))
        return violations

    def plant(self, name, line):
        """Puts a line into a file of the clean tree and expects exactly that file to be blamed."""
        self.assertEqual(self.found(), [])
        self.write(name, CLEAN.get(name, "#pragma once\n") + line + "\n")
        edges = [violation for violation in self.found() if "includes itself" not in violation]
        self.assertTrue(edges, f"'{line}' in {name} was not found")
        self.assertTrue(all(edge.startswith(f"{name}:") for edge in edges), edges)

    def test_every_forbidden_edge_is_found(self):
        for name, line in (
            ("physics/law.hpp", '#include "solver/passes/pass.hpp"'),
            ("physics/law.hpp", '#include "common/io/file.hpp"'),
            ("solver/passes/pass.hpp", '#include "solver/step.hpp"'),
            ("solver/passes/other.hpp", '  #  include "common/io/file.hpp"'),
            ("solver/state/record.hpp", '#include "solver/passes/pass.hpp"'),
            ("solver/backend/device.cu", '#include "solver/step.hpp"'),
            ("solver/step.hpp", '#include "tests/any.cpp"'),
            ("common/particles.hpp", '#include "common/io/file.hpp"'),
            ("common/other.hpp", '#include "solver/passes/pass.hpp"'),
            ("gencase/fill.cpp", '#include "solver/passes/pass.hpp"'),
            ("postproc/surface.cpp", '#include "solver/step.hpp"'),
            ("foam_reference/write.cpp", '#include "gencase/fill.cpp"'),
        ):
            with self.subTest(file=name, line=line):
                self.tearDownFiles()
                self.plant(name, line)

    def test_libraries_stay_in_their_rooms(self):
        for name, line in (
            ("common/particles.hpp", "#include <vtkPolyData.h>"),
            ("gencase/fill.cpp", "#include <vtkPolyData.h>"),
            ("postproc/surface.cpp", "#include <CGAL/Surface_mesh.h>"),
            ("foam_reference/write.cpp", "#include <cuda_runtime.h>"),
            ("solver/passes/pass.hpp", "#include <cub/cub.cuh>"),
            ("solver/passes/pass.hpp", "#include <omp.h>"),
            ("physics/law.hpp", "#include <Eigen/Core>"),
        ):
            with self.subTest(file=name, line=line):
                self.tearDownFiles()
                self.plant(name, line)

    def test_device_syntax_stays_in_the_backend(self):
        for name, line in (
            ("solver/passes/pass.hpp", "inline void go() { sweep<<<1, 2>>>(); }"),
            ("solver/step.hpp", "inline void go() { cudaDeviceSynchronize(); }"),
            ("physics/law.hpp", "__device__ inline float one() { return 1; }"),
            ("solver/passes/pass.hpp", "#pragma omp parallel for"),
        ):
            with self.subTest(file=name, line=line):
                self.tearDownFiles()
                self.plant(name, line)

    def test_comments_and_strings_are_no_code(self):
        self.write("solver/passes/pass.hpp", '#pragma once\n// sweep<<<1, 2>>>();  #include <vtkPolyData.h>\n'
                                             '/*\n#include "solver/step.hpp"\n*/\n'
                                             'inline const char* name() { return "cudaMalloc"; }\n')
        self.assertEqual(self.found(), [])

    def test_a_missing_file_and_a_relative_path_are_found(self):
        self.plant("solver/step.hpp", '#include "passes/pass.hpp"')

    def test_vtk_does_not_reach_the_device_through_a_header(self):
        self.write("solver/state/record.hpp", CLEAN["solver/state/record.hpp"] + '#include "physics/law.hpp"\n')
        self.assertEqual(self.found(), [])
        self.write("physics/law.hpp", CLEAN["physics/law.hpp"] + "#include <vtkPolyData.h>\n")
        self.assertTrue(any(violation.startswith("solver/backend/device.cu:1: reaches <vtkPolyData.h>")
                            for violation in self.found()))

    def test_a_circle_of_headers_is_found(self):
        self.write("solver/passes/one.hpp", '#pragma once\n#include "solver/passes/two.hpp"\n')
        self.write("solver/passes/two.hpp", '#pragma once\n#include "solver/passes/one.hpp"\n')
        self.assertEqual(len(self.found()), 2)

    def tearDownFiles(self):
        """Back to the clean tree between the cases of one test."""
        shutil.rmtree(self.root)
        for name, text in CLEAN.items():
            self.write(name, text)


class Headers(Tree):
    def compile_commands(self):
        build = self.root / "build"
        build.mkdir(exist_ok=True)
        units = [path for path in self.root.rglob("*.cpp")]
        command = f"ccache c++ -I{self.root} -std=c++20 -Wall -Werror -o x -c"
        (build / "compile_commands.json").write_text(json.dumps([
            {"directory": str(build), "file": str(unit), "command": f"{command} {unit}"} for unit in units]))
        return build

    def test_a_header_that_needs_another_first_is_found(self):
        self.write("solver/step.cpp", "\n")
        self.assertEqual(headers.check(self.root, self.compile_commands())[0], [])
        self.write("solver/step.hpp", "#pragma once\ninline std::vector<int> steps() { return {}; }\n")
        violations, _ = headers.check(self.root, self.compile_commands())
        self.assertEqual(len(violations), 1)
        self.assertTrue(violations[0].startswith("solver/step.hpp:1: does not compile alone"))

    def test_a_header_that_a_unit_includes_first_is_left_to_the_build(self):
        self.write("solver/step.hpp", "#pragma once\ninline std::vector<int> steps() { return {}; }\n")
        self.write("solver/step.cpp", '#include <vector>\n\n#include "solver/step.hpp"\n')
        self.assertEqual(len(headers.check(self.root, self.compile_commands())[0]), 1)
        self.write("solver/step.cpp", '#include "solver/step.hpp"\n\n#include <vector>\n')
        self.assertEqual(headers.check(self.root, self.compile_commands())[0], [])

    def test_a_warning_is_an_error(self):
        self.write("solver/step.cpp", "\n")
        self.write("solver/step.hpp", "#pragma once\ninline int one() { int unused = 2; return 1; }\n")
        self.assertEqual(len(headers.check(self.root, self.compile_commands())[0]), 1)

    def test_a_room_without_units_is_said(self):
        violations, _ = headers.check(self.root, self.compile_commands())
        self.assertIn("no unit of solver", violations[0])


@unittest.skipUnless(shutil.which("clang-format-14"), "clang-format-14 is not installed")
class Formatting(Tree):
    def test_a_misplaced_brace_is_found_with_its_line(self):
        self.write(".clang-format", "BasedOnStyle: Google\n")
        self.write("solver/backend/device.cu", "\n")
        self.assertEqual(formatting.check(self.root)[0], [])
        self.write("solver/step.hpp", "#pragma once\n\ninline int one()\n{ return 1; }\n")
        violations, _ = formatting.check(self.root)
        self.assertEqual(len(violations), 1)
        self.assertTrue(violations[0].startswith("solver/step.hpp:3:"))


class Readability(Tree):
    def test_a_long_file_and_a_riddle_are_found(self):
        self.assertEqual(readability.check(self.root)[0], [])
        self.write("solver/step.hpp", "#pragma once\n" + "\n" * readability.MOST_LINES)
        self.write("solver/passes/pass.hpp", "#pragma once\n\n/// What a pass is.\n\n// True. Where it is not.\n")
        self.assertEqual([violation.split(":")[0] for violation in readability.check(self.root)[0]],
                         ["solver/passes/pass.hpp", "solver/step.hpp"])


@unittest.skipUnless(shutil.which("clang-tidy-14"), "clang-tidy-14 is not installed")
class StaticAnalysis(Tree):
    def test_the_checks_that_are_switched_on_find_mistakes(self):
        settings = pathlib.Path(__file__).resolve().parents[2] / ".clang-tidy"
        for mistake, check in (("int BadName() { return 1; }", "readability-identifier-naming"),
                               ("int f(int a) {\n  if (a);\n  a = 1;\n  return a;\n}", "bugprone-suspicious-semicolon"),
                               ("int* f() { return 0; }", "modernize-use-nullptr")):
            with self.subTest(check=check):
                self.write("common/mistake.cpp", mistake + "\n")
                command = ["clang-tidy-14", f"--config-file={settings}", "--quiet", self.root / "common/mistake.cpp",
                           "--", "-std=c++20"]
                result = subprocess.run(command, capture_output=True, text=True)
                self.assertEqual(result.returncode, 1, result.stdout)
                self.assertIn(check, result.stdout)


class TrackedFiles(Tree):
    def found(self):
        return tracked_files.check(self.root)[0]

    def test_every_forbidden_text_is_found(self):
        self.assertEqual(self.found(), [])
        for text in ("/ho" "me/somebody/file", "x = 1 ", "\tx", "TO" "DO later", "<" * 7 + " HEAD",
                     "https://" "deb.debian" ".org/x", "no end"):
            with self.subTest(text=text):
                self.write("docs/page.md", "# Page\n" + text + ("" if text == "no end" else "\n"))
                violations = self.found()
                self.assertEqual(len(violations), 1, violations)
                self.assertTrue(violations[0].startswith("docs/page.md"))

    def test_executable_bits_follow_the_first_line(self):
        self.write("tools/script", "#!/bin/sh\n")
        self.assertIn("may not be executed", self.found()[0])
        (self.root / "tools/script").chmod(0o755)
        self.assertEqual(self.found(), [])
        (self.root / "common/particles.hpp").chmod(0o755)
        self.assertIn("is no script", self.found()[0])

    def test_git_decides_what_is_tracked(self):
        git = ["git", "-C", self.root, "-c", "core.fileMode=false"]
        subprocess.run([*git, "init", "-q"], check=True)
        self.write("tools/script", "#!/bin/sh\n")
        self.write("build/untracked", "x \n")
        subprocess.run([*git, "add", "tools"], check=True)
        violations, checked = tracked_files.check(self.root)
        self.assertEqual(checked, 1)
        self.assertIn("tools/script:1", violations[0])

    def test_a_picture_is_no_text_and_a_big_file_is_refused(self):
        (self.root / "docs").mkdir()
        (self.root / "docs/picture.bin").write_bytes(b"\0 \t\n")
        self.assertEqual(self.found(), [])
        (self.root / "docs/picture.bin").write_bytes(b"\0" * (tracked_files.LARGEST + 1))
        self.assertEqual(len(self.found()), 1)


if __name__ == "__main__":
    unittest.main()
