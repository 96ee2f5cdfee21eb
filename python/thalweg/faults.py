"""Wrong input, and the way a program in Python ends: like the other programs, one line and a status."""

import argparse
import difflib
import signal
import sys

from thalweg import programs

LONGEST = 300  # characters of a message


class InputError(Exception):
    """What is wrong and what to do, in one line: exit status 2."""


def nearest(word, words):
    """The cure for a wrong word: the one that was meant, or all of them."""
    near = difflib.get_close_matches(word, words, 1)
    return f"did you mean {near[0]}?" if near else f"there are {', '.join(sorted(words))}"


class Arguments(argparse.ArgumentParser):
    """Options whose errors are one line, as those of the other programs."""

    def error(self, message):
        raise InputError(f"{self.prog}: {message}; see {self.prog} --help")


def end(signum, _):
    raise SystemExit(128 + signum)


def run_program(program):
    """Calls program() and returns its exit status. A signal ends what it has started, each with a checkpoint."""
    signal.signal(signal.SIGTERM, end)
    signal.signal(signal.SIGHUP, end)
    try:
        return program()
    except InputError as error:
        text = str(error)
        print(f"error: {text if len(text) <= LONGEST else text[:LONGEST - 1] + '…'}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"error: {error.filename or 'a file'}: {error.strerror}; make room or access for it, and go on with --resume", file=sys.stderr)
        return 1
    except RuntimeError as error:
        print(f"error: {str(error).splitlines()[-1]}; look at that program's own message, and go on with --resume", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("stopped; the same command with --resume goes on from here", file=sys.stderr)
        return 128 + signal.SIGINT
    finally:
        programs.stop_all()
