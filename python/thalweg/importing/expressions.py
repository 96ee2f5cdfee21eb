"""The arithmetic of GenCase's attributes: "#Dp*4", "#x[1]+cosdg(30)" and texts with "[name]"."""

import ast
import math
import operator

from thalweg.faults import InputError

OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv, ast.Mod: math.fmod,
             ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge, ast.Eq: operator.eq,
             ast.NotEq: operator.ne}
FUNCTIONS = {"float": float, "int": int, "floor": math.floor, "ceil": math.ceil, "round": round, "min": min, "max": max, "abs": abs,
             "fmod": math.fmod, "sqrt": math.sqrt, "exp": math.exp, "log": math.log, "log10": math.log10, "pow": math.pow,
             "sin": math.sin, "cos": math.cos, "tan": math.tan, "asin": math.asin, "acos": math.acos, "atan": math.atan,
             "atan2": math.atan2, "sinh": math.sinh, "cosh": math.cosh, "tanh": math.tanh, "pi": lambda: math.pi, "e": lambda: math.e,
             "sindg": lambda a: math.sin(math.radians(a)), "cosdg": lambda a: math.cos(math.radians(a)),
             "tandg": lambda a: math.tan(math.radians(a)), "eval": lambda condition, a, b: a if condition else b}
LONGEST = 500  # characters
LARGEST = 1e12


class Variables:
    """Names and numbers of a definition; names do not tell capitals from small letters."""

    def __init__(self):
        self._values = {"true": 1.0, "false": 0.0}

    def set(self, name, value):
        self._values[name.lower()] = value

    def number(self, text, where):
        """The number that an attribute means, with or without #. `where` is "file:line" for messages."""
        plain = text.strip().lstrip("#").strip()
        try:
            if len(plain) > LONGEST:
                raise ValueError("it is too long")
            try:
                value = float(plain)
            except ValueError:
                value = float(self._value(ast.parse(self._python(plain), mode="eval").body))
            if not abs(value) <= LARGEST:
                raise ValueError(f"it is not within {LARGEST:g}")
            return value
        except (SyntaxError, ValueError, TypeError, KeyError, ArithmeticError, RecursionError) as error:
            reason = f"{error.args[0]} is not known" if isinstance(error, KeyError) else str(error).split(" (<")[0]
            raise InputError(f"{where}: {plain[:80]} is no number ({reason}); write a number or variables that the file sets") from error

    @staticmethod
    def _python(text):
        return text.replace("&&", " and ").replace("||", " or ").replace("!=", "≠").replace("!", " not ").replace("≠", "!=")

    def _value(self, node):
        if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
            return node.value
        if isinstance(node, ast.Name):
            return self._values[node.id.lower()]
        if isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name):  # x[2] is x2
            return self._values[f"{node.value.id}{self._value(node.slice):g}".lower()]
        if isinstance(node, ast.UnaryOp):
            value = self._value(node.operand)
            return -value if isinstance(node.op, ast.USub) else float(not value) if isinstance(node.op, ast.Not) else value
        if isinstance(node, ast.BinOp):
            return OPERATORS[type(node.op)](self._value(node.left), self._value(node.right))
        if isinstance(node, ast.BoolOp):
            values = [self._value(each) for each in node.values]
            return float(all(values) if isinstance(node.op, ast.And) else any(values))
        if isinstance(node, ast.Compare) and len(node.ops) == 1:
            return float(OPERATORS[type(node.ops[0])](self._value(node.left), self._value(node.comparators[0])))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
            return FUNCTIONS[node.func.id.lower()](*map(self._value, node.args))
        raise ValueError("it is no arithmetic that is known here")
