#!/usr/bin/env python3
"""Installs a build below a folder, moves the folder, and uses it: install_test.py BUILD SCRATCH"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

BUILD, SCRATCH = map(pathlib.Path, sys.argv[1:3])
SOURCE = pathlib.Path(__file__).resolve().parents[2]
TREE = SCRATCH / "moved"
BIN = TREE / "bin"
# A coarse dam break, over after a second or two.
SMALL = ["--set", "numerics.spacing=10 mm", "--set", "output.end=0.1 s", "--set", "compare.times=[]", "--set", "output.times=[]"]


def run(*command, folder=SCRATCH, status=0):
    done = subprocess.run(list(map(str, command)), cwd=folder, capture_output=True, text=True, env={**os.environ, "PATH": "/usr/bin:/bin"})
    assert done.returncode == status, (command, done.returncode, done.stdout, done.stderr)
    return done.stdout


def elf_files():
    return [file for folder in (BIN, TREE / "lib" / "thalweg") for file in sorted(folder.iterdir()) if file.read_bytes()[:4] == b"\x7fELF"]


class Tree(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        SCRATCH.mkdir(parents=True)
        run("cmake", "--install", BUILD, "--prefix", SCRATCH / "first")
        (SCRATCH / "first").rename(TREE)

    def test_a_user_runs_an_installed_example(self):
        before = {file for file in TREE.rglob("*")}
        told = json.loads(run(BIN / "thalweg", "run", TREE / "share/thalweg/cases/dam_break", "--no-foam", "--out", "own", "--json", *SMALL))
        self.assertEqual(told["status"], 0)
        self.assertEqual([stage["stage"] for stage in told["stages"]], ["gencase", "solver", "postproc"])
        self.assertAlmostEqual(told["summary"]["physical_time"]["value"], 0.1)
        self.assertTrue((SCRATCH / told["report"]).is_file())
        self.assertEqual({file for file in TREE.rglob("*")}, before, "the installed tree was written to")

    def test_the_programs_carry_no_path_of_the_build(self):
        for file in elf_files():
            with self.subTest(file=file.name):
                self.assertNotIn(str(BUILD).encode(), file.read_bytes())
                self.assertNotIn(str(SOURCE).encode(), file.read_bytes())
                paths = re.findall(r"(?:RPATH|RUNPATH).*\[(.*)\]", run("readelf", "-d", file))
                for path in paths:
                    for element in path.split(":"):
                        self.assertTrue(element.startswith("$ORIGIN"), f"{file.name}: {path}")

    def test_every_command_has_a_page_of_the_manual_and_answers_for_itself(self):
        commands = re.findall(r"^  ([a-z]+) ", run(BIN / "thalweg", "help"), re.M)
        self.assertGreaterEqual(len(commands), 12)
        self.assertLess(commands.index("run"), commands.index("postproc"), "the order of use")
        for command in commands:
            with self.subTest(command=command):
                page = (TREE / f"share/man/man1/thalweg-{command}.1").read_text(encoding="utf-8")
                self.assertIn("\\-\\-help", page, "the options of the command")
                self.assertIn("--help", run(BIN / "thalweg", "help", command))
        self.assertIn("thalweg", (TREE / "share/man/man1/thalweg.1").read_text(encoding="utf-8"))

    def test_bash_completes_commands_options_words_and_keys(self):
        script = TREE / "share/bash-completion/completions/thalweg"
        for words, expected in ((["so"], ["solver"]), (["run", "--re"], ["--resume"]), (["solver", "--backend", "cu"], ["cuda"]),
                                (["run", "--set", "numerics.sp"], ["numerics.spacing="]), (["explain", "output.e"], ["output.end"])):
            with self.subTest(words=words):
                line = " ".join(f"'{word}'" for word in ["thalweg", *words])
                found = run("bash", "-c", f"compopt() {{ :; }}; source '{script}'; COMP_WORDS=({line}); COMP_CWORD={len(words)}; "
                                          f"_thalweg; printf '%s\\n' \"${{COMPREPLY[@]}}\"").split()
                self.assertEqual(found, expected)

    def test_all_programs_tell_the_same_version(self):
        told = run(BIN / "thalweg", "--version").splitlines()
        self.assertRegex(told[0], r"^thalweg \d+\.\d+\.\d+")
        self.assertTrue(any(re.match(r"CPU cores .*baseline", line) for line in told), told)
        for program in sorted(BIN.glob("thalweg-*")):
            self.assertEqual(run(program, "--version").splitlines()[0].split()[-1], told[0].split()[-1], program.name)

    def test_documents_and_their_links_are_there(self):
        folder = TREE / "share/doc/thalweg"
        for link in re.findall(r"\]\(((?:docs|cases)/[^)#]*)\)", (folder / "README.md").read_text(encoding="utf-8")):
            self.assertTrue((folder / link).exists(), link)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
