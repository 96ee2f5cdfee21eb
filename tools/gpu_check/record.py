"""The rows that are done, on disk after each of them, and the tables made of them."""

import json
import tarfile
import time

LARGEST_LOG = 2_000_000  # bytes of a log that are kept


class Budget:
    """Seconds that this call may take."""

    def __init__(self, seconds):
        self.end = time.monotonic() + seconds

    def left(self):
        return self.end - time.monotonic()

    def allows(self, seconds):
        return self.left() >= seconds


class Record:
    """Outcomes by the name of the row. A row of another device, driver or code is not taken over."""

    def __init__(self, out, facts, anew):
        self.out = out
        self.file = out / "gpu-check.json"
        self.content = {"machine": facts, "rows": {}}
        if self.file.exists() and not anew:
            known = json.loads(self.file.read_text(encoding="utf-8"))
            same = all(known["machine"].get(key) == facts[key] for key in ("device", "driver", "code"))
            if same:
                self.content["rows"] = known["rows"]

    def has(self, row):
        """True if the row is done. One that failed, was cut short or skipped is run again."""
        return self.content["rows"].get(row.name, {}).get("passed") is True

    def failed(self, row):
        return self.content["rows"].get(row.name, {}).get("passed") is False

    def skipped(self, row):
        return self.content["rows"].get(row.name, {}).get("skipped", False)

    def note(self, row, outcome):
        self.content["rows"][row.name] = {"part": row.part, **outcome}
        write(self.file, json.dumps(self.content, indent=1))
        write(self.out / "gpu-check.md", page(self.content))
        pack_logs(self.out)
        print(f"{row.name}: {verdict(outcome)}", flush=True)


def verdict(outcome):
    word = "skipped" if outcome.get("skipped") else {True: "passed", False: "FAILED", None: "not finished"}[outcome["passed"]]
    return f"{word}: {outcome['why']}" if outcome.get("why") else word


def write(file, text):
    """Whole or not at all."""
    part = file.with_suffix(file.suffix + ".part")
    part.write_text(text, encoding="utf-8")
    part.replace(file)


def pack_logs(out):
    """All logs in one small file; of a long one its end."""
    part = out / "logs.tar.gz.part"
    with tarfile.open(part, "w:gz") as tar:
        for log in sorted((out / "logs").glob("*")):
            if log.stat().st_size > LARGEST_LOG:
                with log.open("rb+") as file:
                    file.seek(-LARGEST_LOG, 2)
                    end = file.read()
                log.write_bytes(end)
            tar.add(log, arcname=f"logs/{log.name}")
    part.replace(out / "logs.tar.gz")


def page(content):
    facts, rows = content["machine"], content["rows"]
    lines = ["# The solver on a GPU", "",
             f"{facts['device']} ({facts['memory_MiB']} MiB), driver {facts['driver']}, {facts['cores']} cores beside it; "
             f"{facts['when']}; `tools/gpu-check`, {facts['code']}", "", "| row | outcome | seconds |", "|---|---|---|"]
    for name, row in rows.items():
        lines.append(f"| {name} | {verdict(row)} | {row.get('seconds', 0):.0f} |")
    lines += bench_table(rows) + shares(rows)
    for name, row in rows.items():
        if row["part"] == "flume" and "flow_seconds" in row:
            lines += ["", f"{name}: {row['flow_seconds']:.3g} s of the flow in {row['wall_seconds']:.0f} s"]
    return "\n".join(lines) + "\n"


def bench_table(rows):
    figures = [(name, row["figures"]) for name, row in rows.items() if "figures" in row]
    if not figures:
        return []
    lines = ["", "From a developed flow; steps before those that count are taken off.", "",
             "| row | particles | fluid | at | steps | ns per fluid particle-step | M fluid particle-steps/s | neighbours | "
             "list entries a particle | steps a list | CG iterations | launched as one | B/particle | coefficients |",
             "|---" * 14 + "|"]
    for name, f in figures:
        lines.append(
            f"| {name} | {f['particles']} | {f['fluid_particles']} | {f['time']:.3g} s | {f['steps']} | "
            f"{f['ns_per_fluid_particle_step']:.3g} | {1e3 / f['ns_per_fluid_particle_step']:.4g} | "
            f"{f['neighbours_mean']:.1f} | {f['list_entries_per_particle']:.1f} | {f['steps_per_list']:.1f} | "
            f"{f['viscous_iterations_per_step']:.1f} | {100 * f['fixed_launches']:.0f} % | "
            f"{f['bytes_per_particle']:.0f} | {f['coefficients']} |")
    return lines


def shares(rows):
    lines = []
    for name, row in rows.items():
        headings = row.get("headings")
        if not headings:
            continue
        total = sum(headings.values())
        lines += ["", f"Shares of {name} (each heading waited for):", "", "| heading | share |", "|---|---|"]
        lines += [f"| {k} | {100 * v / total:.1f} % |" for k, v in sorted(headings.items(), key=lambda kv: -kv[1])]
    return lines
