"""The machine code of the sweeps, read from a program or a core module with objdump."""

import re
import subprocess
from collections import Counter

STACK = re.compile(r"\(%r[sb]p")


def functions(binary):
    """(name, [(address, operation, operands)]) of every function in the machine code."""
    text = subprocess.run(["objdump", "-d", "-C", "--no-show-raw-insn", binary], check=True, capture_output=True, text=True).stdout
    for block in text.split("\n\n"):
        head, _, body = block.lstrip("\n").partition("\n")
        if name := re.match(r"[0-9a-f]+ <(.*)>:$", head):
            yield name[1], [(int(m[1], 16), m[2], m[3])
                            for m in re.finditer(r"^\s*([0-9a-f]+):\s+(\S+) *(.*)$", body, re.MULTILINE)]


def inner_loop(code):
    """The shortest loop that prefetches, or else that multiplies: the one over a cluster's neighbours. None if there is none."""
    position = {address: n for n, (address, _, _) in enumerate(code)}
    loops = []
    for n, (_, operation, operands) in enumerate(code):
        if not operation.startswith("j") or not (target := re.match(r"([0-9a-f]+)", operands)):
            continue
        start = position.get(int(target[1], 16), n + 1)
        if start <= n:
            loops.append(code[start:n + 1])
    for marks in (r"prefetch", r"v?(fn?m(add|sub)\w*|mul)ps"):
        found = [loop for loop in loops if any(re.match(marks, operation) for _, operation, _ in loop)]
        if found:
            return min(found, key=len)
    return None


def count(loop):
    """The instructions of a loop by kind."""
    operations = Counter(operation for _, operation, _ in loop)

    def total(pattern):
        return sum(n for operation, n in operations.items() if re.match(pattern, operation))

    return {
        "instructions": len(loop),
        "multiply": total(r"v?(fn?m(add|sub)\w*|mul)p[sd]"),
        "add": total(r"v?(add|sub)p[sd]|v?psubd"),
        "shuffle": total(r"v?(permil|shuf|unpck|insert|perm|movlh|movhl|movsh|movsl|pshuf)\w*"),
        "divide or root": total(r"v?(div|sqrt)p[sd]"),
        "on the stack": sum(1 for _, _, operands in loop if STACK.search(operands)),
    }


def first_argument(text):
    """The text up to the comma or bracket that ends the first of several template arguments."""
    depth = 0
    for at, letter in enumerate(text):
        if depth == 0 and letter in ",>":
            return text[:at]
        depth += {"<": 1, "(": 1, ">": -1, ")": -1}.get(letter, 0)
    return text


def sweeps(binary):
    """(dimension, name of the sweep's body without namespaces, code) of every pair sweep over a cluster."""
    for name, code in functions(binary):
        found = re.search(r"\bsweep(?:_cluster)?<(\d), [\w:]+, (.*)", name)
        if found and inner_loop(code):
            body = re.sub(r"\b\w+::", "", first_argument(found[2])).replace(" >", ">")
            yield found[1], re.sub(r", \w+<OpenMp<[^<>]*>>(::\w+)?", "", body).strip(), code  # without the device, which all share
