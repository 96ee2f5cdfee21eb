"""The first difference between two tables or two particle files of runs that should be equal bit for bit."""

from thalweg.particle_file import numbers, stored_arrays
from thalweg.tables import text_rows


def common_rows(name, left, right):
    """The rows of both tables at steps, or times, that both have: a restarted run writes rows of its own."""
    key = "step [-]" if name == "history.csv" else "time [s]"
    common = {row[key] for row in left} & {row[key] for row in right}
    return [row for row in left if row[key] in common], [row for row in right if row[key] in common]


def first_table_difference(name, a, b, one_sided, restarted=False):
    """Compares the table `name` of two run folders row by row, as text, in the columns that both have.

    `one_sided` receives the columns that only one has; `restarted`: one of the two runs was stopped on its way. None if equal.
    """
    left, right = (text_rows(folder / name) if (folder / name).exists() else [] for folder in (a, b))
    if not left and not right:
        return None
    if not left or not right:
        return f"{name} is missing or empty on one side"
    columns = [column for column in left[0] if column in right[0]]
    one_sided |= {f"column {column} of {name}" for column in left[0].keys() ^ right[0].keys()}
    if restarted:
        left, right = common_rows(name, left, right)
    for row, other in zip(left, right):
        for column in columns:
            if row[column] != other[column]:
                at = "step [-]" if "step [-]" in row else "time [s]"
                return f"{name}: {column} {row[column]} ≠ {other[column]}, {at.split(' [')[0]} {row[at]}"
    return f"{name}: {len(left)} ≠ {len(right)} rows" if len(left) != len(right) else None


def first_value_difference(left, right):
    """Position and both values of the first difference between two arrays (VTK type, bytes) of one type and length."""
    (kind, plain), (_, other) = left, right
    values, others = numbers(kind, plain), numbers(kind, other)
    size = len(plain) // len(values)
    at = next(i for i in range(len(values)) if plain[i * size:(i + 1) * size] != other[i * size:(i + 1) * size])
    return at, len(values), values[at], others[at]


def first_array_difference(a, b, one_sided):
    """Compares the arrays that two particle files both have, bit by bit, particles in the order of the files.

    `one_sided` receives the arrays that only one has. None if equal.
    """
    if not a.exists() or not b.exists():
        return f"{a.name} is missing on one side" if a.exists() != b.exists() else None
    left, right = stored_arrays(a), stored_arrays(b)
    of = "snapshots" if a.parent.name == "snapshots" else a.name
    one_sided |= {f"array {name} of {of}" for name in left.keys() ^ right.keys()}
    step, ids = numbers(*left["Step"])[0], numbers(*left["Id"])
    for name, mine in left.items():
        other = right.get(name, mine)
        if mine == other:
            continue
        if (mine[0], len(mine[1])) != (other[0], len(other[1])):
            return f"{a.name}: {name}: {mine[0]}, {len(mine[1])} bytes ≠ {other[0]}, {len(other[1])} bytes, step {step}"
        at, size, value, other_value = first_value_difference(mine, other)
        components = max(1, size // len(ids))
        component = f"[{at % components}]" if components > 1 else ""
        particle = f" of particle {ids[at // components]}" if size >= len(ids) else ""
        return f"{a.name}: {name}{component}{particle} {value!r} ≠ {other_value!r}, step {step}"
    return None
