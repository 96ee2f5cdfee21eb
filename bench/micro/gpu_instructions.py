#!/usr/bin/env python3
"""Counts what the CUDA core's kernels were compiled to.

usage: bench/micro/gpu_instructions.py [--arch sm_90] [KERNEL ...]

Compiles solver/simulation/core_cuda_3d.cu with the flags of cmake/ThalwegCuda.cmake (some minutes; needs nvcc, no GPU) and
prints, for every kernel whose name contains one of the words (default: pair sweeps and list building): registers, bytes
spilled, and of its innermost loop with loads: instructions and loads a pair. A machine instruction has 16 bytes; its lowest
12 bits are its code, and bits 73 to 75 of a load its size (looked up in what nvcc makes of known sources).
"""

import argparse
import pathlib
import re
import struct
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FLAGS = ["-forward-unknown-to-host-compiler", "-DEIGEN_NO_CUDA", '-DTHALWEG_VERSION="counted"', f"-I{ROOT}",
         "-isystem=/usr/include/eigen3", "-O3", "-DNDEBUG", "--extended-lambda", "--expt-relaxed-constexpr", "--ftz=true",
         "--prec-div=false", "--prec-sqrt=false", "-Xptxas=-v", "-std=c++20", "-x", "cu"]
BRANCH, LOAD, CONVERT = 0x947, (0x981, 0x381), (0x245, 0x306, 0x312)
SIZES = {0: 1, 1: 1, 2: 2, 3: 2, 4: 4, 5: 8, 6: 16}  # bytes of a load


def compiled(arch, folder):
    """The machine code and ptxas' remarks."""
    cubin = folder / "core.cubin"
    done = subprocess.run(["nvcc", *FLAGS, f"-arch={arch}", "-cubin", ROOT / "solver/simulation/core_cuda_3d.cu", "-o", cubin],
                          capture_output=True, text=True, check=True)
    return cubin.read_bytes(), done.stderr


def remarks(text):
    """{kernel: {"registers", "spilled"}} of ptxas -v."""
    found, name = {}, None
    for line in text.splitlines():
        if match := re.search(r"Compiling entry function '(\S+)'", line):
            name = match[1]
            found[name] = {"registers": 0, "spilled": 0}
        if match := re.search(r"(\d+) bytes spill stores, (\d+) bytes spill loads", line):
            found[name]["spilled"] = int(match[1]) + int(match[2])
        if match := re.search(r"Used (\d+) registers", line):
            found[name]["registers"] = int(match[1])
    return found


def kernels(elf):
    """{kernel: [(low, high) 64 bits of every instruction]} of a cubin, an ELF file."""
    (table,) = struct.unpack_from("<Q", elf, 0x28)
    size, number, names = struct.unpack_from("<HHH", elf, 0x3A)
    sections = [struct.unpack_from("<IIQQQQ", elf, table + i * size) for i in range(number)]
    text = sections[names][4]
    found = {}
    for name, _, _, _, at, length in sections:
        title = elf[text + name:elf.index(b"\0", text + name)].decode()
        if title.startswith(".text."):
            found[title[6:]] = list(struct.iter_unpack("<QQ", elf[at:at + length]))
    return found


def target(n, low, high):
    """The instruction to which the branch at n jumps; its distance is counted in quarters of 16 bytes."""
    far = low >> 34 | (high & 0x3FFFF) << 30
    far -= (1 << 48) if far >> 47 else 0
    return n + 1 + ((far << 8) + (low >> 16 & 0xFF)) // 4


def loops(code):
    """(first, last) instruction of every loop, without the one that ends a kernel."""
    back = [(target(n, *i), n) for n, i in enumerate(code) if i[0] & 0xFFF == BRANCH]
    return [(a, b) for a, b in back if 0 <= a < b]


def loads(code):
    """Sizes [bytes] of the loads from memory."""
    return [SIZES.get(high >> 9 & 7, 0) for low, high in code if low & 0xFFF in LOAD]


def innermost(code):
    """The innermost loops that load, longest first."""
    every = loops(code)
    inner = [(a, b) for a, b in every if not any((c, d) != (a, b) and a <= c and d <= b for c, d in every)]
    return sorted(((code[a:b + 1]) for a, b in inner if loads(code[a:b + 1])), key=len, reverse=True)


def short(name):
    """A kernel's name as it is spoken of."""
    name = re.sub(r"thalweg::|\(anonymous namespace\)::|unsigned int, ", "", name)
    for word in ("CountPass", "WritePass", "count_entries", "search_alone"):
        if word in name:
            return word
    match = re.search(r"SweepThread<3, \w+, ((?:\w+::)?\w+)(<3(?:, (?:true|false|field::\w+))*)?", name)
    if not match:
        return name[:60]
    coupling = re.search(r"(Mixture|Drag|Viscous)Coupling", name)
    arguments = match[2][1:].replace("3, ", "").replace("3", "") if match[2] else ""
    return " ".join(filter(None, (match[1], arguments, coupling[0] if coupling else "")))


def demangled(names):
    text = subprocess.run(["c++filt"], input="\n".join(names), capture_output=True, text=True, check=True).stdout
    return dict(zip(names, text.splitlines()))


def rows(elf, log, words):
    told, codes = remarks(log), kernels(elf)
    names = demangled(list(codes))
    for kernel, code in codes.items():
        if not any(word in names[kernel] for word in words):
            continue
        loop = innermost(code)[0] if innermost(code) else []
        sizes = loads(loop)
        yield {"kernel": short(names[kernel]), **told.get(kernel, {"registers": 0, "spilled": 0}),
               "instructions": len(code), "loop": len(loop), "wide": sizes.count(16), "loads": len(sizes),
               "convert": sum(low & 0xFFF in CONVERT for low, _ in loop)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--arch", default="sm_90")
    parser.add_argument("kernel", nargs="*", default=["SweepThread", "CountPass", "WritePass"])
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        elf, log = compiled(arguments.arch, pathlib.Path(folder))
    print("| kernel | registers | spilled [B] | instructions | of the inner loop | loads there | of 16 bytes |\n" + "|---" * 7 + "|")
    for row in sorted(rows(elf, log, arguments.kernel), key=lambda r: r["kernel"]):
        print("| {kernel} | {registers} | {spilled} | {instructions} | {loop} | {loads} | {wide} |".format(**row))


if __name__ == "__main__":
    main()
