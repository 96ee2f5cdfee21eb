"""What is known of the GPU, and whether somebody else is using it."""

import os
import platform
import subprocess
import time

BUSY_PERCENT = 5  # utilisation of an idle GPU as nvidia-smi tells it, with a margin for a display


def text_of(command):
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=60, check=False).stdout.strip()
    except (OSError, subprocess.TimeoutExpired):
        return ""


def query(what, of="gpu"):
    return text_of(["nvidia-smi", f"--query-{of}={what}", "--format=csv,noheader,nounits"])


def facts(bundle):
    """Device, driver, host and code; None without a GPU."""
    line = query("name,driver_version,memory.total").splitlines()
    if not line or line[0].count(",") < 2:
        return None
    name, driver, memory = line[0].split(", ")[:3]
    return {"device": name, "driver": driver, "memory_MiB": memory, "host": platform.machine(),
            "cores": os.cpu_count(), "when": time.strftime("%Y-%m-%d"),
            "code": text_of([bundle / "bin" / "thalweg-solver", "--version"]).partition("\n")[0]}


def gpus():
    """How many there are."""
    return len(query("name,driver_version").splitlines())


def busy():
    """Why figures of this GPU would mean nothing now; an empty text if it is idle."""
    others = [line for line in query("pid,process_name,used_memory", "compute-apps").splitlines() if line.strip()]
    if others:
        return f"another process computes on the GPU: {others[0]}"
    used = query("utilization.gpu").splitlines()
    if used and used[0].strip().isdigit() and int(used[0]) > BUSY_PERCENT:
        return f"the GPU is {used[0].strip()} % busy"
    return ""
