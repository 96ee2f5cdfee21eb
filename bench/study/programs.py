"""One way to start a program, and what it used."""

import os
import subprocess
import tempfile
from dataclasses import dataclass


@dataclass
class Used:
    """The resources that a process used, from its start to its end."""
    text: str     # its output and error output
    cpu: float    # [s] of all threads, system time included
    peak: int     # [bytes] largest resident memory; the kernel reports no less than that of the script which starts the program


def call(*command):
    """Runs a command to its end. Raises RuntimeError with what it printed if it fails."""
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as output:
        process = subprocess.Popen([str(part) for part in command], stdout=output, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        text = output.read()
    if process.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}\nexit status {process.returncode}\n{text}")
    return Used(text, usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss)
