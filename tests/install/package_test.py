#!/usr/bin/env python3
"""Makes the Debian package of a build and reads what is in it: package_test.py BUILD SCRATCH. Skipped (77) without dpkg-dev and file."""

import pathlib
import re
import shutil
import subprocess
import sys
import unittest

BUILD, SCRATCH = map(pathlib.Path, sys.argv[1:3])
SOURCE = pathlib.Path(__file__).resolve().parents[2]


def output(*command):
    done = subprocess.run(list(map(str, command)), cwd=SOURCE, capture_output=True, text=True)
    assert done.returncode == 0, (command, done.stdout, done.stderr)
    return done.stdout


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        made = output(SOURCE / "tools/package", BUILD, "--out", SCRATCH).split("\n")
        cls.package = next(pathlib.Path(line) for line in made if pathlib.Path(line).name.startswith("thalweg_"))
        cls.files = {re.sub(r"^\./", "/", line.split()[5]) for line in output("dpkg-deb", "--contents", cls.package).splitlines()}

    def test_it_holds_what_a_user_needs(self):
        for file in ("bin/thalweg", "bin/thalweg-gencase", "bin/thalweg-solver", "bin/thalweg-postproc", "bin/thalweg-foam", "bin/thalweg-sweep",
                     "lib/thalweg/thalweg_core_openmp_baseline.so", "share/man/man1/thalweg-run.1", "share/bash-completion/completions/thalweg",
                     "share/doc/thalweg/README.md", "share/thalweg/cases/louvain/case.toml", "share/thalweg/tools/foam-library"):
            self.assertIn("/usr/" + file, self.files)

    def test_it_holds_nothing_of_the_build_or_the_tests(self):
        strays = [file for file in self.files if re.search(r"\.(o|a|cmake|pyc)$|_test\b|/tests/|/include/|thalweg_core_cuda", file)]
        self.assertEqual(strays, [])
        self.assertTrue(all(file.startswith("/usr") or file == "/" for file in self.files))

    def test_it_asks_for_libraries_and_for_no_headers(self):
        depends = output("dpkg-deb", "--field", self.package, "Depends")
        for library in ("libvtk9.1", "libudunits2-0", "libudunits2-data", "libstdc++6", "libfmt9", "libgomp1", "python3"):
            self.assertRegex(depends, rf"(^|, ){re.escape(library)}\b")
        self.assertNotRegex(depends, r"-dev\b")
        self.assertIn("gnuplot-nox", output("dpkg-deb", "--field", self.package, "Recommends"))

    def test_it_carries_the_version_of_the_programs(self):
        told = output(BUILD / "bin" / "thalweg", "--version").splitlines()[0].split()[-1]
        packaged = output("dpkg-deb", "--field", self.package, "Version").strip()
        # The package's version is taken when it is made, the program's when that is built.
        self.assertEqual(re.split(r"[+]", packaged)[0], re.split(r"[+]", told)[0])


if __name__ == "__main__":
    if not all(map(shutil.which, ("cpack", "dpkg-shlibdeps", "file"))):
        print("skipped: dpkg-dev and file are not installed")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
