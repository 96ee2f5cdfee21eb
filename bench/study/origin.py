"""Where a measurement was made, and of what: the lines that stand over every table of results."""

import pathlib
import platform
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
VECTORS = (("avx512f", "AVX-512"), ("avx2", "AVX2"))  # flag of the processor, name


def commit():
    """Of the sources, with "+" if they differ from it."""
    def git(*words):
        return subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True, check=True).stdout.strip()
    return git("rev-parse", "--short", "HEAD") + ("+" if git("status", "--porcelain", "--untracked-files=no") else "")


def processor():
    """Its maker's name, vectors and number of cores, as the system reports them."""
    described = {}
    for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        key, _, value = line.partition(":")
        described.setdefault(key.strip(), []).append(value.strip())
    flags = set(described.get("flags", [""])[0].split())
    vectors = next((name for flag, name in VECTORS if flag in flags), "no AVX2")
    name = described.get("model name", ["unknown"])[0]
    return f"{name}, {platform.machine()}, {vectors}, {len(described.get('processor', []))} processors"


def load():
    """Mean number of processes that wanted a processor in the last minute."""
    return float(pathlib.Path("/proc/loadavg").read_text(encoding="utf-8").split()[0])
