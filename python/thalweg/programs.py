"""One way to start a program, and what it used."""

import os
import signal
import subprocess
import tempfile
from dataclasses import dataclass

_running = set()  # numbers of the processes that call() waits for, in any thread


@dataclass
class Used:
    """The resources that a process used, from its start to its end."""
    text: str     # its output and error output
    cpu: float    # [s] of all threads, system time included
    peak: int     # [bytes] largest resident memory; the kernel reports no less than that of the script which starts the program


class Failed(RuntimeError):
    """A program ended with another status than 0: `status` (minus the number of a signal), and `text`, what it printed."""

    def __init__(self, command, status, text):
        super().__init__(f"{' '.join(map(str, command))}\nexit status {status}\n{text}")
        self.status, self.text = status, text

    def error_line(self):
        """The program's own error message, or its last line."""
        lines = [line for line in self.text.splitlines() if line.strip()]
        errors = [line for line in lines if line.startswith("error: ")]
        return errors[-1].removeprefix("error: ") if errors else lines[-1] if lines else f"exit status {self.status}"


def call(*command):
    """Runs a command to its end. Raises Failed, a RuntimeError, with what it printed if it fails."""
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as output:
        process = subprocess.Popen([str(part) for part in command], stdin=subprocess.DEVNULL, stdout=output,
                                   stderr=subprocess.STDOUT)
        _running.add(process.pid)
        try:
            _, status, usage = os.wait4(process.pid, 0)
        except BaseException:
            os.kill(process.pid, signal.SIGTERM)
            os.waitpid(process.pid, 0)
            raise
        finally:
            _running.discard(process.pid)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        text = output.read()
    if process.returncode != 0:
        raise Failed(command, process.returncode, text)
    return Used(text, usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss)


def stop_all():
    """Asks every program that call() waits for to end; a solver writes its checkpoint first."""
    for number in list(_running):
        os.kill(number, signal.SIGTERM)
