"""Origin of a measurement: machine, commit and command, the lines that stand above every record."""

import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
VECTORS = (("avx512f", "AVX-512"), ("avx2", "AVX2"))  # flag of the processor, name


def commit():
    """The commit of the sources, and "with changes" if they differ from it; "unknown" outside a repository."""
    described = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty=, with changes"],
                               capture_output=True, text=True, check=False)
    return described.stdout.strip() or "unknown"


def processor(key):
    """The first value of a key in /proc/cpuinfo; "?" without one."""
    found = re.search(rf"^{key}\s*:\s*(.*)$", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.MULTILINE)
    return found.group(1).strip() if found else "?"


def caches():
    """The data caches of one processor: "L1 48K, L2 1024K"."""
    folder = pathlib.Path("/sys/devices/system/cpu/cpu0/cache")
    return ", ".join(f"L{(index / 'level').read_text().strip()} {(index / 'size').read_text().strip()}"
                     for index in sorted(folder.glob("index*")) if (index / "type").read_text().strip() != "Instruction")


def machine():
    """The kind of machine, its processors and memory, and the compiler, as text."""
    flags = processor("flags").split()
    widest = next((name for flag, name in VECTORS if flag in flags), "no AVX2")
    memory = int(re.search(r"MemTotal:\s*(\d+)", pathlib.Path("/proc/meminfo").read_text()).group(1)) / 1e6
    system = re.search(r'PRETTY_NAME="([^"]*)"', pathlib.Path("/etc/os-release").read_text())
    compiler = subprocess.run(["g++", "-dumpfullversion"], capture_output=True, text=True, check=False).stdout.strip()
    return (f"{len(os.sched_getaffinity(0))} processors of {processor('model name')} (family {processor('cpu family')}, "
            f"model {processor('model')}), {widest}, {caches()}, {memory:.0f} GB, "
            f"{system.group(1) if system else '?'}, g++ {compiler}")


def load():
    """Mean number of processes that wanted a processor in the last minute."""
    return os.getloadavg()[0]


def command_line(script, ignored=()):
    """The command that started this run, without folders of the machine and without the `ignored` words; `script`: below bench/."""
    words = [pathlib.Path(word).name if word.startswith("/") else word for word in sys.argv[1:] if word not in ignored]
    return " ".join([f"bench/{script}", *words])


def lines(script, ignored=()):
    """Machine, commit and command, a line each: the comment above a table."""
    return f"{machine()}; load {load():.1f} when written\ncommit {commit()}\n{command_line(script, ignored)}"
