"""Wrong input, and the way a program in Python ends: like the other programs, one line and a status."""

import argparse
import difflib
import json
import os
import pathlib
import signal
import sys

from thalweg import programs

LONGEST = 300  # characters of a message


class Voice:
    """How a program speaks, as the others do (common/console.hpp)."""
    quiet = False
    json = False
    result = None


def say(text):
    """Text for the user; on stderr with --json, which keeps stdout for one object, and nowhere with --quiet."""
    if not Voice.quiet:
        print(text, file=sys.stderr if Voice.json else sys.stdout, flush=True)


def answer(result):
    """What --json prints at the end: whatever json can write."""
    Voice.result = result


class InputError(Exception):
    """What is wrong and what to do, in one line: exit status 2."""


def nearest(word, words):
    """The cure for a wrong word: the one that was meant, or all of them."""
    near = difflib.get_close_matches(word, words, 1)
    return f"did you mean {near[0]}?" if near else f"there are {', '.join(sorted(words))}"


class Arguments(argparse.ArgumentParser):
    """Options whose errors are one line, as those of the other programs, and that --describe tells for completion and manual."""

    def __init__(self, *args, **options):
        super().__init__(*args, **options)
        self.add_argument("--quiet", action="store_true", help="says nothing but warnings and errors")
        self.add_argument("--json", action="store_true", help="prints one JSON object at the end, and speaks on stderr")
        self.add_argument("--version", action="store_true", help="prints version, commit and what is installed")

    def parse_args(self, args=None, namespace=None):
        given = sys.argv[1:] if args is None else args
        if given == ["--describe"]:
            print(json.dumps(self.description_of_options()))
            raise SystemExit(0)
        if "--version" in given:
            thalweg = str(pathlib.Path(sys.argv[0]).resolve().parent / "thalweg")
            os.execv(thalweg, [thalweg, "--version"])
        Voice.quiet, Voice.json, Voice.result = "--quiet" in given, "--json" in given, None
        return super().parse_args(args, namespace)

    def description_of_options(self):
        """What common/command_line.cpp tells of a program in C++."""
        options = []
        for action in self._actions:
            takes_value = action.nargs != 0
            words = "|".join(map(str, action.choices or [])) or action.metavar or action.dest.upper()
            options.append({"names": action.option_strings, "place": "" if action.option_strings else words,
                            "value": words if takes_value and action.option_strings else "",
                            "meaning": (action.help or "") % {**vars(action), "prog": self.prog}})
        return {"name": self.prog, "meaning": self.description or "", "options": options}

    def error(self, message):
        raise InputError(f"{self.prog}: {message}; see {self.prog} --help")


def end(signum, _):
    raise SystemExit(128 + signum)


def failed(status, text):
    """Tells an error and returns the status."""
    text = text if len(text) <= LONGEST else text[:LONGEST - 1] + "…"
    print(f"error: {text}", file=sys.stderr)
    if Voice.json:
        print(json.dumps({"status": status, "errors": [{"message": text}]}))
    return status


def run_program(program):
    """Calls program() and returns its exit status. A signal ends what it has started, each with a checkpoint."""
    signal.signal(signal.SIGTERM, end)
    signal.signal(signal.SIGHUP, end)
    try:
        status = program()
        if Voice.json:
            print(json.dumps({"status": status} if Voice.result is None else Voice.result))
        return status
    except InputError as error:
        return failed(2, str(error))
    except OSError as error:
        return failed(1, f"{error.filename or 'a file'}: {error.strerror}; make room or access for it, and go on with --resume")
    except RuntimeError as error:
        return failed(1, f"{str(error).splitlines()[-1]}; look at that program's own message, and go on with --resume")
    except KeyboardInterrupt:
        print("stopped; the same command with --resume goes on from here", file=sys.stderr)
        return 128 + signal.SIGINT
    finally:
        programs.stop_all()
