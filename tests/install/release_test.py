#!/usr/bin/env python3
"""The version that git gives a build, what tools/release refuses, and what tools/build says of an old CMake: release_test.py"""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]


class Repository(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.root)
        for folder in ("cmake", "tools"):
            (self.root / folder).mkdir()
        for file in ("cmake/version_of.cmake", "cmake/build_version.cmake", "cmake/git_archive.txt", ".gitattributes", "tools/release", "tools/build"):
            shutil.copy(SOURCE / file, self.root / file)
        (self.root / "CMakeLists.txt").write_text("project(thalweg VERSION 0.2.0 LANGUAGES CXX)\n", encoding="utf-8")
        (self.root / "CITATION.cff").write_text("version: 0.2.0\n", encoding="utf-8")
        (self.root / "CHANGELOG.md").write_text("# Changes\n\n## 0.2.0, 2030-01-01\n\n- More.\n\n## 0.1.0, 2029-01-01\n\n- All.\n", encoding="utf-8")
        self.git("init", "-q")
        self.commit()

    def git(self, *words):
        return subprocess.run(["git", "-c", "user.name=A", "-c", "user.email=a@b.c", *words], cwd=self.root, check=True, capture_output=True,
                              text=True).stdout.strip()

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-q", "--allow-empty", "-m", "A step")

    def built(self, root=None):
        """The generated file's lines on version and commit."""
        root = root or self.root
        subprocess.run(["cmake", "-D", f"SOURCE={root}", "-D", "RELEASE=0.2.0", "-D", f"OUTPUT={root}/made.cpp", "-P",
                        root / "cmake/build_version.cmake"], check=True)
        text = (root / "made.cpp").read_text(encoding="utf-8")
        (root / "made.cpp").unlink()
        return [line.split('"')[1] for line in text.splitlines() if "return" in line]

    def release(self, *words):
        done = subprocess.run(["tools/release", *words], cwd=self.root, capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def test_a_commit_without_tags_has_the_release_and_its_hash(self):
        version, commit = self.built()
        self.assertEqual(version, "0.2.0+1.g" + self.git("rev-parse", "--short=9", "HEAD"))
        self.assertTrue(commit.startswith(self.git("rev-parse", "--short=9", "HEAD") + " of "))

    def test_a_tag_is_the_version_and_later_commits_are_counted(self):
        self.git("tag", "-a", "v0.3.1", "-m", "x")
        self.assertEqual(self.built()[0], "0.3.1")
        self.commit()
        self.assertEqual(self.built()[0], "0.3.1+1.g" + self.git("rev-parse", "--short=9", "HEAD"))

    def test_changes_show(self):
        self.git("tag", "-a", "v0.3.1", "-m", "x")
        (self.root / "CHANGELOG.md").write_text("other\n", encoding="utf-8")
        self.assertEqual(self.built()[0], "0.3.1+0.modified")

    def test_an_archive_knows_where_it_comes_from_and_a_bare_tree_has_the_release(self):
        self.git("tag", "-a", "v0.3.1", "-m", "x")
        other = self.root / "other"
        other.mkdir()
        archive = subprocess.run(["git", "archive", "HEAD"], cwd=self.root, check=True, capture_output=True).stdout
        subprocess.run(["tar", "-xf", "-", "-C", other], input=archive, check=True)
        version, commit = self.built(other)
        self.assertEqual(version, "0.3.1")
        self.assertTrue(commit.startswith(self.git("log", "-1", "--format=%h")), commit)
        shutil.copy(SOURCE / "cmake/git_archive.txt", other / "cmake/git_archive.txt")
        self.assertEqual(self.built(other), ["0.2.0", "unknown"])

    def test_a_release_needs_files_that_agree(self):
        self.assertEqual(self.release("0.2.0", "--check"), (0, "the files agree on version 0.2.0\n"))
        for words, part in ((["0.2", "--check"], "is no version"), (["0.3.0", "--check"], "CMakeLists.txt"), (["0.2.0", "--nonsense"], "--help")):
            with self.subTest(words=words):
                status, text = self.release(*words)
                self.assertEqual(status, 2)
                self.assertIn(part, text)
        for file, text in (("CITATION.cff", "version: 0.1.0\n"), ("CHANGELOG.md", "# Changes\n"), ("CHANGELOG.md", "## 0.2.0, not released yet\n\n- x\n")):
            with self.subTest(file=file, text=text):
                kept = (self.root / file).read_text(encoding="utf-8")
                (self.root / file).write_text(text, encoding="utf-8")
                status, said = self.release("0.2.0", "--check")
                self.assertEqual((status, file in said), (2, True), said)
                (self.root / file).write_text(kept, encoding="utf-8")

    def test_a_release_is_newer_than_the_last_one(self):
        self.git("tag", "-a", "v0.2.0", "-m", "x")
        self.assertIn("the tag v0.2.0 exists", self.release("0.2.0", "--check")[1])
        self.git("tag", "-d", "v0.2.0")
        self.git("tag", "-a", "v0.10.0", "-m", "x")
        self.assertIn("older than the last release, 0.10.0", self.release("0.2.0", "--check")[1])

    def test_an_old_cmake_is_told_before_anything_is_built(self):
        old = self.root / "old"
        old.mkdir()
        (old / "cmake").write_text("#!/bin/sh\necho cmake version 3.22.1\n", encoding="utf-8")
        (old / "cmake").chmod(0o755)
        done = subprocess.run(["tools/build", "programs"], cwd=self.root, capture_output=True, text=True,
                              env={**os.environ, "PATH": f"{old}:{os.environ['PATH']}"})
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"^error: CMake 3\.22\.1 is too old, 3\.25 is needed; get a newer one with: .*\n$")
        self.assertNotIn("Configuring", done.stdout)


if __name__ == "__main__":
    unittest.main()
