"""The other program of the comparison: DualSPHysics 5.4 built from its sources, and scenes written the way it reads them.

Its own generator of scenes comes as a program without sources, so the two files it would leave are written here: NAME.xml, what
is computed and how, and NAME.bi4, the particles, in the layout of its classes JBinaryData and JPartDataBi4.
"""

import re
import shutil
import struct
import subprocess
from array import array

from thalweg.programs import call

FLAGS = "-O3 -march=native -ffast-math"
MAKE = ["make", "-f", "Makefile_cpu", "USE_FAST_MATH=YES", "USE_NATIVE_CPU_OPTIMIZATIONS=YES", "COMPILE_CHRONO=NO",
        "COMPILE_WAVEGEN=NO", "COMPILE_MOORDYNPLUS=NO"]  # couplings that a dam break does not have
PROGRAM = "DualSPHysics5.4CPU_linux64"
TEXT, BOOL, INT, UINT, ULLONG, FLOAT, DOUBLE, FLOAT3, DOUBLE3 = 1, 2, 7, 8, 10, 11, 12, 22, 23  # JBinaryDataDef


def build(installation, folder, jobs):
    """Compiles the program in a copy of the sources below `installation`, once; returns its path."""
    program = folder / PROGRAM
    if program.exists():
        return program
    sources = next(installation.rglob("Makefile_cpu"), None)
    if sources is None:
        raise RuntimeError(f"{installation}: holds no Makefile_cpu; give the folder of DualSPHysics 5.4 with its sources")
    shutil.copytree(sources.parents[1], folder / "src", dirs_exist_ok=True)
    log = folder / "build.log"
    with log.open("w", encoding="utf-8") as output:
        done = subprocess.run([*MAKE, f"EXECS_DIRECTORY={folder}", f"-j{jobs}"], cwd=folder / "src" / sources.parent.name,
                              stdout=output, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0 or not program.exists():
        raise RuntimeError(f"DualSPHysics did not compile; see {log}")
    return program


def text(value):
    return struct.pack("<I", len(value)) + value.encode("ascii")


VALUE = {TEXT: text, BOOL: lambda v: struct.pack("<i", v), INT: lambda v: struct.pack("<i", v),
         UINT: lambda v: struct.pack("<I", v), ULLONG: lambda v: struct.pack("<Q", v),
         DOUBLE: lambda v: struct.pack("<d", v), DOUBLE3: lambda v: struct.pack("<3d", *v)}


def item(name, values, arrays, items):
    """An item of a .bi4 file: its head with its values, then its arrays, then the items in it."""
    plain = text("\nVALUES") + struct.pack("<I", len(values))
    plain += b"".join(text(key) + struct.pack("<i", kind) + VALUE[kind](value) for key, kind, value in values)
    head = text("\nITEM\n") + text(name) + struct.pack("<2i", 0, 0) + text("%.7E") + text("%.15E")
    head += struct.pack("<3I", len(arrays), len(items), len(plain))
    data = struct.pack("<I", len(head)) + head + plain
    for key, kind, count, content in arrays:
        definition = text("\nARRAY") + text(key) + struct.pack("<2i2I", 0, kind, count, len(content))
        data += struct.pack("<I", len(definition)) + definition + content
    return data + b"".join(items)


def particle_file(scene, walls, fluid, velocity, density):
    """The bytes of NAME.bi4; places [m] and velocities [m/s] as flat sequences, walls first."""
    places = array("d", [*walls, *fluid])
    n, n_walls = len(places) // 3, len(walls) // 3
    corner = [[pick(places[k::3]) for k in range(3)] for pick in (min, max)]
    zero = (0.0, 0.0, 0.0)
    part = item("PART_0000",
                [("Cpart", UINT, 0), ("TimeStep", DOUBLE, 0.0), ("Npok", UINT, n), ("Nout", UINT, 0), ("Step", UINT, 0),
                 ("RunTime", DOUBLE, 0.0), ("DomainMin", DOUBLE3, corner[0]), ("DomainMax", DOUBLE3, corner[1])],
                [("Idp", UINT, n, array("I", range(n)).tobytes()), ("Posd", DOUBLE3, n, places.tobytes()),
                 ("Vel", FLOAT3, n, array("f", [*[0.0] * len(walls), *velocity]).tobytes()),
                 ("Rhop", FLOAT, n, array("f", [*[scene["density"]] * n_walls, *density]).tobytes())], [])
    mass = scene["density"] * scene["spacing"] ** 3
    values = [("Piece", UINT, 0), ("Npiece", UINT, 1), ("RunCode", TEXT, ""), ("Date", TEXT, ""),
              ("AppName", TEXT, ""), ("CaseName", TEXT, scene["name"]), ("Data2d", BOOL, 0),
              ("Data2dPosY", DOUBLE, 0.0), ("MapPosMin", DOUBLE3, zero), ("MapPosMax", DOUBLE3, zero),
              ("PeriMode", INT, -1), ("PeriXinc", DOUBLE3, zero), ("PeriYinc", DOUBLE3, zero), ("PeriZinc", DOUBLE3, zero),
              ("AxisDiv", INT, 0), ("CaseNp", ULLONG, n), ("CaseNfixed", ULLONG, n_walls), ("CaseNmoving", ULLONG, 0),
              ("CaseNfloat", ULLONG, 0), ("CaseNfluid", ULLONG, n - n_walls), ("CasePosMin", DOUBLE3, corner[0]),
              ("CasePosMax", DOUBLE3, corner[1]), ("NpDynamic", BOOL, 0), ("ReuseIds", BOOL, 0),
              ("Dp", DOUBLE, scene["spacing"]), ("H", DOUBLE, scene["smoothing_length"]), ("B", DOUBLE, stiffness(scene)),
              ("Rhop0", DOUBLE, scene["density"]), ("Gamma", DOUBLE, 7.0), ("MassBound", DOUBLE, mass),
              ("MassFluid", DOUBLE, mass)]
    head = "#FileJBD JPartDataBi4".ljust(58).encode("ascii") + b"\n\0" + bytes(4)
    return head + item("JPartDataBi4", values, [], [part])


def stiffness(scene):
    """Tait's B [Pa]."""
    return scene["sound_speed"] ** 2 * scene["density"] / 7


def case_file(scene, n_walls, n_fluid):
    """NAME.xml: Wendland's kernel, symplectic steps, artificial viscosity and Fourtakas' diffusion, walls of particles that
    repel (DBC), the program's cheapest."""
    constants = {"cflnumber": scene["cfl"], "gamma": 7, "rhop0": scene["density"], "dp": scene["spacing"],
                 "h": scene["smoothing_length"], "b": stiffness(scene), "massbound": scene["density"] * scene["spacing"] ** 3,
                 "massfluid": scene["density"] * scene["spacing"] ** 3}
    parameters = {"StepAlgorithm": 2, "Kernel": 2, "ViscoTreatment": 1, "Visco": scene["artificial_viscosity"],
                  "ViscoBoundFactor": 1, "DensityDT": 2, "DensityDTvalue": scene["density_diffusion"], "Shifting": 0,
                  "Boundary": 1, "RigidAlgorithm": 1, "CoefDtMin": 0.001, "TimeMax": 1, "TimeOut": 1, "RhopOutMin": 500,
                  "RhopOutMax": 1500, "MinFluidStop": 0}
    lines = ['<?xml version="1.0" encoding="UTF-8" ?>', "<case><execution><parameters>"]
    lines += [f'<parameter key="{key}" value="{value}" />' for key, value in parameters.items()]
    lines += ["<simulationdomain>"]
    for corner, sign in (("posmin", "-"), ("posmax", "+")):
        lines += [f"<{corner} " + " ".join(f'{axis}="default{sign}50%"' for axis in "xyz").replace("default-", "default - ")
                  .replace("default+", "default + ") + " />"]
    lines += ["</simulationdomain></parameters>", "<constants>", '<data2d value="false" />',
              '<gravity x="0" y="0" z="-9.81" />']
    lines += [f'<{key} value="{value!r}" />' for key, value in constants.items()]
    lines += ["</constants>", f'<particles np="{n_walls + n_fluid}" nb="{n_walls}" nbf="{n_walls}" mkboundfirst="11" '
              'mkfluidfirst="1">', f'<fixed mkbound="0" mk="11" begin="0" count="{n_walls}" />',
              f'<fluid mkfluid="0" mk="1" begin="{n_walls}" count="{n_fluid}" />', "</particles></execution></case>"]
    return "\n".join(lines) + "\n"


def write_scene(folder, scene, walls, fluid, velocity, density):
    """Returns the path of the scene's files without their suffixes."""
    folder.mkdir(parents=True, exist_ok=True)
    case = folder / scene["name"]
    case.with_suffix(".xml").write_text(case_file(scene, len(walls) // 3, len(fluid) // 3), encoding="ascii")
    case.with_suffix(".bi4").write_bytes(particle_file(scene, walls, fluid, velocity, density))
    return case


def take_steps(program, case, steps, cells):
    """So many steps on one thread, particles sorted into cells ("full": as wide as the support, the program's own choice;
    "half": half as wide); processor time [s] of the whole process, and what the program wrote."""
    out = case.parent / "out"
    shutil.rmtree(out, ignore_errors=True)
    used = call(program, case, out, "-cpu", "-ompthreads:1", f"-nsteps:{steps}", f"-cellmode:{cells}",
                "-sv:none")
    log = (out / "Run.out").read_text(encoding="latin-1")
    taken = re.search(r"Steps of simulation\.+: ([\d,]+)", log)
    if taken is None or int(taken.group(1).replace(",", "")) != steps:
        raise RuntimeError(f"DualSPHysics did not take {steps} steps; see {out / 'Run.out'}\n{used.text[-2000:]}")
    return used.cpu, log


def version(log):
    found = re.search(r"DualSPHysics5? v([\d.]+)", log)
    return found.group(1) if found else "?"
