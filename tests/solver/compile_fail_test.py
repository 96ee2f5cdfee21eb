#!/usr/bin/env python3
"""Checks that a wrong body is refused with a readable message: compile_fail_test.py ROOT BUILD

Bodies of passes and sweeps declare their fields (solver/backend/device.hpp). A snippet with a right body compiles with
the flags of the solver's units. Each snippet that lacks one declaration has to fail, and one of the compiler's errors
has to be the sentence of the static_assert that says what is missing.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT, BUILD = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
sys.path.insert(0, str(ROOT / "tests/guards"))
from headers import flags_by_room  # noqa: E402, the folder has to be known first

SWEEP = {
    "fields": "using reads = Reads<>; using writes = Writes<>;",
    "neighbours": "using neighbours = Neighbours<field::place>;",
    "kernel": "static constexpr unsigned kernel = kernel_value;",
    "sum": "template <class L> struct Sum { L density; };",
    "pair": """template <class LaneT, class L>
               void pair(const LaneT&, const LaneT& b, const PairGeometry<2, L>& g, std::size_t, Sum<L>& sum) const {
                 sum.density += b.volume * g.W;
               }""",
    "end": "void end(Index, const Sum<float>&) const {}",
}
HEADERS = """
#include "solver/backend/openmp.hpp"
#include "tests/solver/guarded_runtime.hpp"
"""
SNIPPET = """
using namespace thalweg;
struct Body { %(body)s };
template <class Device>
void run(Device& on, const ClusterList& list, const Record* records, [[maybe_unused]] const PairMetric<2>& metric) {
  %(call)s
}
template void run(%(device)s&, const ClusterList&, const Record*, const PairMetric<2>&);
"""
DEVICES = ("OpenMp<4>", "Gpu<test::GuardedRuntime>")
SWEEP_CALL = "on.template sweep<2>(list, ClusterRange{}, records, metric, Body{});"
LAMBDA = "[=](Index i) { (void)records[i]; }"

NO_FIELDS = "a body declares its fields: `using reads = Fields<...>; using writes = Fields<...>;`"
NO_SWEEP_FIELDS = "a sweep's body declares its fields"
NO_NEIGHBOURS = "a sweep's body declares what it reads of both particles of a pair: `using neighbours = Fields<...>;`"
NO_SWEEP = "a sweep's body has `static constexpr unsigned kernel`, `template <class L> struct Sum`, "


class Bodies(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        compiler, flags = flags_by_room(ROOT, BUILD)["solver"]
        folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="thalweg-compile-")))
        # The headers are compiled once for all snippets.
        headers = folder / "headers.hpp"
        headers.write_text(HEADERS)
        subprocess.run([compiler, *flags, "-x", "c++-header", headers], cwd=ROOT, check=True)
        cls.command = [compiler, *flags, "-fsyntax-only", "-include", headers, "-x", "c++", "-"]

    def errors(self, body, call, device):
        """The compiler's errors, without the places they were found in."""
        snippet = SNIPPET % {"body": body, "call": call, "device": device}
        result = subprocess.run(self.command, input=snippet, capture_output=True, text=True, cwd=ROOT)
        found = [line.partition("error: ")[2] for line in result.stderr.splitlines() if "error: " in line]
        self.assertEqual(result.returncode != 0, bool(found), result.stderr)
        return found

    def expect_refused(self, message, body, call):
        for device in DEVICES:
            with self.subTest(device=device):
                found = self.errors(body, call, device)
                self.assertEqual(sum(message in error for error in found), 1, found or "it compiles")

    def sweep_without(self, part):
        return " ".join(text for name, text in SWEEP.items() if name != part)

    def test_right_bodies_compile(self):
        declared = f"on.for_each(list.count, declare<Reads<field::place>, Writes<>>({LAMBDA}));"
        for device in DEVICES:
            with self.subTest(device=device):
                self.assertEqual(self.errors(self.sweep_without(None), SWEEP_CALL + declared, device), [])

    def test_a_lambda_has_to_declare_its_fields(self):
        self.expect_refused(NO_FIELDS, "", f"on.for_each(list.count, {LAMBDA});")

    def test_a_reduction_has_to_declare_its_fields(self):
        of = "[=](Index i) { return int(records[i].kind); }"
        call = f"on.reduce(list.count, 0, {of}, [](int a, int b) {{ return a + b; }});"
        self.expect_refused(NO_FIELDS, "", call)

    def test_a_sweep_has_to_declare_its_fields(self):
        self.expect_refused(NO_SWEEP_FIELDS, self.sweep_without("fields"), SWEEP_CALL)

    def test_a_sweep_has_to_declare_its_neighbours_fields(self):
        self.expect_refused(NO_NEIGHBOURS, self.sweep_without("neighbours"), SWEEP_CALL)

    def test_a_sweep_has_to_be_whole(self):
        for part in ("kernel", "pair", "end"):
            with self.subTest(without=part):
                self.expect_refused(NO_SWEEP, self.sweep_without(part), SWEEP_CALL)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
