"""The problems with a known answer: the start of a run, and its error.

errors(run, finest) gives its measures by name; matrix.toml says which of them pictures and Pareto fronts show. `finest` is the run
from which distances count, None where the problem has none or the run is this one.
"""

import math

import water
import water_norms
from cavity import Cavity
from channel import Channel
from study import norms
from study.of_particles import front_of_water
from study.origin import ROOT
from thalweg.particle_file import SEDIMENT, WATER, arrays, of_fluid, replace_arrays
from study.results import Gauges, quantity, resolved, snapshots
from thalweg.tables import read_table
from wall_jet import WallJet

GRAVITY = 9.81  # [m/s^2] of every case but the slot


class Slot:
    """A Herschel-Bulkley-Papanastasiou fluid in a slot."""

    width = 0.1  # [m]

    def start(self, folder):
        """Without pressure: the weight along the slot is what drives the flow, not a column that rests."""
        file, case = folder / "particles.vtp", resolved(folder)
        particles = arrays(file, {"Type", "Density", "Pressure", "Mass"})
        density = quantity(case["materials"]["paste"]["grain_density"])
        spacing = quantity(case["numerics"]["spacing"])
        fluid = set(of_fluid(particles))
        count = range(len(particles["Type"]))
        replace_arrays(file, {
            "Density": [density if i in fluid else particles["Density"][i] for i in count],
            "Mass": [density * spacing ** 2 if i in fluid else particles["Mass"][i] for i in count],
            "Pressure": [0.0 for i in count]})

    def errors(self, run, finest=None):
        case = resolved(run.folder)
        paste = case["materials"]["paste"]
        law = [quantity(paste[key]) for key in ("cohesion", "regularisation", "consistency", "flow_index")]
        force = quantity(paste["grain_density"]) * -quantity(case["domain"]["gravity"][1])
        exact = norms.slot_velocity(self.width, force, law)
        particles = arrays(snapshots(run.folder)[-1], {"Type", "Points", "Velocity"})
        fluid = of_fluid(particles)
        largest = exact(self.width / 2)
        profile = [(particles["Points"][3 * i], -particles["Velocity"][3 * i + 2]) for i in fluid]
        distance = norms.rms(speed - exact(x) for x, speed in profile)
        deeper = quantity(case["numerics"]["spacing"]) / 2
        wider = norms.slot_velocity(self.width + 2 * deeper, force, law)
        from_wider = norms.rms(speed - wider(x + deeper) for x, speed in profile)
        flux = sum(speed for _, speed in profile) / len(profile)
        mean = sum(exact((k + 0.5) * self.width / 4000) for k in range(4000)) / 4000
        return {"velocity": distance / largest, "flux": flux / mean - 1,
                "walls half a spacing deeper": from_wider / largest}


class Vortex:
    """Taylor-Green vortex, in the plane or as a slab."""

    side, speed = 1.0, 1.0  # [m], [m/s]

    @staticmethod
    def viscosity(case):
        """Kinematic [m^2/s]."""
        water = case["materials"]["water"]
        return quantity(water["viscosity"]) / quantity(water["density"])

    def start(self, folder):
        file, case = folder / "particles.vtp", resolved(folder)
        numerics = case["numerics"]
        sound = quantity(numerics["sound_speed_factor"]) * quantity(numerics["maximum_speed"])
        places = arrays(file, {"Points"})["Points"]
        velocity, density, pressure = [], [], []
        for i in range(0, len(places), 3):
            u, w, over_density = norms.vortex(places[i], places[i + 2], 0.0, self.side, self.speed, self.viscosity(case))
            velocity += [u, 0.0, w]
            density.append(1000 * (1 + over_density / sound ** 2))
            pressure.append(1000 * over_density)
        replace_arrays(file, {"Velocity": velocity, "Density": density, "Pressure": pressure})

    def errors(self, run, finest=None):
        case = resolved(run.folder)
        end, viscosity = quantity(case["output"]["end"]), self.viscosity(case)
        particles = arrays(snapshots(run.folder)[-1], {"Points", "Velocity"})
        places, velocities = particles["Points"], particles["Velocity"]
        squares = energy = exact = 0.0
        for i in range(0, len(places), 3):
            u, w, _ = norms.vortex(places[i], places[i + 2], end, self.side, self.speed, viscosity)
            squares += (velocities[i] - u) ** 2 + velocities[i + 1] ** 2 + (velocities[i + 2] - w) ** 2
            energy += velocities[i] ** 2 + velocities[i + 1] ** 2 + velocities[i + 2] ** 2
            exact += u ** 2 + w ** 2  # at the same places: those of a disordered lattice are no even sample
        count = len(places) / 3
        decay = math.exp(-8 * math.pi ** 2 * end * viscosity / self.side ** 2)
        return {"velocity": math.sqrt(squares / count) / (self.speed * decay),
                "decay": abs(math.sqrt(energy / exact) - 1)}


class Still:
    """Water over a bed, both at rest; means over the snapshots of the run's second half."""

    start = None

    def errors(self, run, finest=None):
        case = resolved(run.folder)
        pvc = case["materials"]["pvc"]
        porosity = quantity(pvc["porosity"])
        bed = porosity * quantity(pvc["pore_density"]) + (1 - porosity) * quantity(pvc["grain_density"])
        layers = ((0.06, bed), (0.16, 1000.0))
        wanted = {"Type", "Points", "Velocity", "Pressure"}
        files = snapshots(run.folder)
        wrong, speeds = [], []
        for file in files[len(files) // 2:]:
            particles = arrays(file, wanted)
            fluid = of_fluid(particles)
            exact = [norms.layered_pressure(particles["Points"][3 * i + 2], layers, GRAVITY) for i in fluid]
            wrong.append(norms.rms(particles["Pressure"][i] - p for i, p in zip(fluid, exact)) / norms.rms(exact))
            water = [i for i in fluid if particles["Type"][i] == WATER]
            speeds.append(norms.rms(math.hypot(*particles["Velocity"][3 * i:3 * i + 3]) for i in water))
        return {"pressure": norms.rms(wrong), "speed": norms.rms(speeds) / math.sqrt(GRAVITY * layers[-1][0]),
                "creep": self.creep(files)}

    @staticmethod
    def creep(files):
        """Root mean square way of the sediment from first to last snapshot [m]."""
        first, last = (arrays(file, {"Type", "Points", "Id"}) for file in (files[0], files[-1]))
        begun = {first["Id"][i]: first["Points"][3 * i:3 * i + 3] for i in of_fluid(first) if first["Type"][i] == SEDIMENT}
        return norms.rms(math.dist(begun[last["Id"][i]], last["Points"][3 * i:3 * i + 3])
                         for i in of_fluid(last) if last["Type"][i] == SEDIMENT)


class DamBreak:
    """Front of a collapsing column, against the mean of four measured series (cases/dam_break/README.md)."""

    start = None
    width = 0.1  # [m]

    def fronts(self, run):
        """Over the column's width."""
        spacing = quantity(resolved(run.folder)["numerics"]["spacing"])
        times = [row["t_star"] for row in read_table(ROOT / "cases/dam_break/reference/front.csv")]
        by_time = {}
        for file in snapshots(run.folder):
            found = arrays(file, {"Type", "Points", "TimeValue"})
            by_time[found["TimeValue"][0] * math.sqrt(2 * GRAVITY / self.width)] = file
        fronts = []
        for t_star in times:
            particles = arrays(by_time[min(by_time, key=lambda t: abs(t - t_star))], {"Type", "Points"})
            fronts.append(front_of_water(particles, spacing) / self.width)
        return fronts

    def errors(self, run, finest=None):
        rows = read_table(ROOT / "cases/dam_break/reference/front.csv")
        series = [[value for key, value in row.items() if key.startswith(("martin", "koshizuka"))] for row in rows]
        measured = [sum(values) / len(values) for values in series]
        fronts = self.fronts(run)
        found = {"front": norms.rms(x / m - 1 for x, m in zip(fronts, measured))}
        if finest:
            found["from the finest"] = norms.rms(x - f for x, f in zip(fronts, self.fronts(finest)))
        return found


class Impact:
    """Pressures of a dam break on the far wall (reference/lobovsky_impact.csv), over rho g H.

    noise: root mean square of the three sensors, each less its running mean over 10 ms, on the plateau behind the peak, t* = 3.5 to 4;
    noise after the peak: that of the first sensor alone, t* = 2.5 to 4; peak: highest reading of the first sensor over the highest
    measured; release noise: as noise, of a sensor on the floor under the column in the first 0.2 s, before the wave of the
    release is there (a still tank has none of the release's sound)."""

    start = None
    depth = 0.3  # [m]
    table = ROOT / "bench/speed_vs_error/reference/lobovsky_impact.csv"
    arrival = 2.427  # [-] of the first sensor, t sqrt(g/H)
    peak = 2.843     # [-] highest value of the first sensor's curve, at t* = 2.45

    def pressures(self, run):
        gauges = Gauges(run)
        time, pressure = math.sqrt(self.depth / GRAVITY), 1000 * GRAVITY * self.depth
        return [norms.mean_between(gauges.series(f"{sensor}.pressure", time, pressure), row["from"], row["to"])
                for row in read_table(self.table) for sensor in ("p1", "p3", "p4")]

    def errors(self, run, finest=None):
        gauges = Gauges(run)
        time, pressure = math.sqrt(self.depth / GRAVITY), 1000 * GRAVITY * self.depth
        floor = gauges.series("floor.pressure", time, pressure)
        return self.of_sensors(run) | {"release noise": water_norms.noise(floor, 0.01 / time, 0, 0.2 / time),
                                       "energy rise": water.energy_rise(run)}

    def of_sensors(self, run):
        """What the sensors on the wall tell."""
        measured = [row[sensor] for row in read_table(self.table) for sensor in ("p1", "p3", "p4")]
        time, pressure = math.sqrt(self.depth / GRAVITY), 1000 * GRAVITY * self.depth
        gauges = Gauges(run)
        first = gauges.series("p1.pressure", time, pressure)

        def noise(sensor, begin, end):
            return water_norms.noise(gauges.series(f"{sensor}.pressure", time, pressure), 0.01 / time, begin, end)

        arrival = next((t for t, p in first if p > 0.2), math.inf)
        return {"pressure": norms.rms(p - m for p, m in zip(self.pressures(run), measured)),
                "arrival": abs(arrival - self.arrival),
                "noise": norms.rms(noise(sensor, 3.5, 4) for sensor in ("p1", "p3", "p4")),
                "noise after the peak": noise("p1", 2.5, 4),
                "peak": max(p for _, p in first) / self.peak}


class Box:
    """Heights over the depth, and pressures over rho g H, of SPHERIC's dam break against a box (cases/spheric02)."""

    start = None
    depth = 0.55  # [m]
    reference = ROOT / "cases/spheric02/reference"

    def heights(self, gauges):
        """Root mean square of the heights less those measured, over the depth."""
        return norms.rms(gauges.at(f"{probe}.level", row["time"]) - row[probe]
                         for row in read_table(self.reference / "heights.csv") for probe in ("h1", "h2", "h3", "h4")) / self.depth

    def errors(self, run, finest=None):
        gauges = Gauges(run)
        scale = 1000 * GRAVITY * self.depth
        wrong = [norms.mean_between(gauges.series(f"{sensor}.pressure"), row["from"], row["to"]) - row[sensor]
                 for row in read_table(self.reference / "pressures.csv") for sensor in ("p1", "p2", "p3", "p4")]
        return {"height": self.heights(gauges),
                "pressure": norms.rms(wrong) / scale}


class Louvain:
    """Nothing measured: root mean squares [m] of the profiles over four times, from the finest run's."""

    start = None

    def errors(self, run, finest=None):
        if not finest:
            return {}
        found = run.profile_distances([finest])
        return {name: norms.rms(distance for (_, curve, _), distance in found.items() if curve == whole)
                for name, whole in (("bed", "bed"), ("surface", "free_surface"))}


PROBLEMS = {"poiseuille": Slot(), "taylor_green": Vortex(), "taylor_green_100": Vortex(), "taylor_green_1000": Vortex(),
            "taylor_green_slab": Vortex(), "cavity": Cavity(), "cavity_1000": Cavity(),
            "still_water": Still(), "still_water_10s": Still(), "still_tank": water.StillTank(),
            "standing_wave": water.StandingWave(), "dry_bed": water.DryBed(), "dry_sand": water.DryBed(), "dry_wall": water.DryBed(),
            "drop": water.Falling(), "splash": water.Falling(), "dam_break": DamBreak(), "impact": Impact(), "spheric02": Box(),
            "louvain": Louvain(), "channel": Channel(), "wall_jet": WallJet()}
