"""Problems that judge the water: waves, contact with a bed, impacts, rest, energy. As problems.py: errors(run) gives measures by name."""

import math

import water_norms
from study.norms import rms
from thalweg.particle_file import SEDIMENT, WALL, WATER, arrays, of_fluid, replace_arrays
from study.results import Gauges, quantity, resolved, snapshots
from thalweg.tables import read_table
from water_norms import GRAVITY

ENERGIES = ("kinetic_energy", "potential_energy", "internal_energy")


def total_energies(run):
    """Kinetic, potential and internal energy [J] of history.csv, summed, as (time, sum)."""
    return [(row["time"], sum(row[name] for name in ENERGIES)) for row in read_table(run.folder / "history.csv")]


def energy_rise(run):
    """Largest rise of the total energy above its start, as the height in spacings by which it would lift all fluid
    (cases/stability/README.md: energy_above_start)."""
    first = read_table(run.folder / "history.csv")[0]
    weight = (first["water_mass"] + first["sediment_mass"]) * GRAVITY
    spacing = quantity(resolved(run.folder)["numerics"]["spacing"])
    return water_norms.rise_above_start([energy for _, energy in total_energies(run)]) / (weight * spacing)


def tait_density(pressure, sound_speed, at_rest=1000.0):
    """[kg/m^3] of water under this pressure [Pa] (physics/water/equation_of_state.hpp)."""
    return at_rest * (1 + 7 * pressure / (at_rest * sound_speed ** 2)) ** (1 / 7)


class StandingWave:
    """Half a wave in a closed tank, let go at its turning point.

    loss: share of the wave's energy lost a period, mean over the run; period: relative difference from the second-order theory;
    energy: largest |E - E0| of the total energy over the wave's energy rho g a^2 L/4; disorder: kinetic energy at the last turning
    point over the last peak (water_norms.decay_of_swing)."""

    length, depth, amplitude, density = 0.6, 0.3, 0.015, 1000.0  # [m], [m], [m]: a twentieth of the depth, [kg/m^3]

    def start(self, folder):
        """Moves the resting particles along the linear mode's displacements, under its pressure."""
        file, numerics = folder / "particles.vtp", resolved(folder)["numerics"]
        sound = quantity(numerics["sound_speed_factor"]) * quantity(numerics["maximum_speed"])
        particles = arrays(file, {"Type", "Points", "Density", "Pressure"})
        places, densities, pressures = (list(particles[name]) for name in ("Points", "Density", "Pressure"))
        k = water_norms.wave_number(self.length)
        for i in of_fluid(particles):
            x, z = places[3 * i], places[3 * i + 2]
            dx, dz = water_norms.mode_displacement(x, z, k, self.depth, self.amplitude)
            places[3 * i], places[3 * i + 2] = x + dx, z + dz
            pressures[i] = water_norms.mode_pressure(x, z, k, self.depth, self.amplitude, self.density)
            densities[i] = tait_density(pressures[i], sound, self.density)
        replace_arrays(file, {"Points": places, "Density": densities, "Pressure": pressures})

    def errors(self, run, finest=None):
        expected = water_norms.standing_period(water_norms.wave_number(self.length), self.depth, self.amplitude)
        kinetic = [(row["time"], row["kinetic_energy"]) for row in read_table(run.folder / "history.csv")]
        loss, period, disorder = water_norms.decay_of_swing(kinetic, expected)
        energies = [energy for _, energy in total_energies(run)]
        wave = water_norms.wave_energy(self.length, self.amplitude, self.density)
        return {"loss": loss, "period": period / expected - 1,
                "energy": max(abs(energy - energies[0]) for energy in energies) / wave,
                "energy rise": water_norms.rise_above_start(energies) / wave, "disorder": disorder}


class DryBed:
    """Contact of a dam-break wave with the bed it runs over, which was dry.

    In each snapshot after `settled` and each column of a spacing's width beyond the gate that has water: height of the lowest water over
    the bed's surface, in spacings. The bed's surface is half a spacing above its highest particle within a spacing of the column's
    middle, counted upwards without a gap of two spacings, so that the place of a lone missing grain is no void; contact is 0.5.
    contact, contact 90 %: median and 90 % of all. pressure, pressure 90 %: of that bed particle less that of the lowest water and the
    weight between, (rho_w + rho_s)/2 g dz: median, and 90 % of the magnitude [Pa]. front: of the water at the end [m], half a spacing
    beyond the third foremost particle."""

    start = None
    gate, settled = 0.25, 0.1   # [m], [s]

    def errors(self, run, finest=None):
        spacing = quantity(resolved(run.folder)["numerics"]["spacing"])
        heights, excesses = [], []
        for file in snapshots(run.folder):
            particles = arrays(file, {"Type", "Points", "Pressure", "Density", "TimeValue"})
            if particles["TimeValue"][0] >= self.settled:
                for height, excess in self.columns(particles, spacing):
                    heights.append(height)
                    excesses.append(excess)
        last = arrays(snapshots(run.folder)[-1], {"Type", "Points"})
        front = sorted(last["Points"][3 * i] for i in of_fluid(last) if last["Type"][i] == WATER)[-3] + spacing / 2
        return {"contact": water_norms.quantile(heights, 0.5), "contact 90 %": water_norms.quantile(heights, 0.9),
                "pressure": water_norms.quantile(excesses, 0.5),
                "pressure 90 %": water_norms.quantile([abs(e) for e in excesses], 0.9), "front": front,
                "energy rise": energy_rise(run)}

    def columns(self, particles, spacing):
        """(height in spacings, pressure excess [Pa]) of each bed column under water."""
        kinds, places, pressure, density = (particles[name] for name in ("Type", "Points", "Pressure", "Density"))
        bed_kind = SEDIMENT if SEDIMENT in kinds else WALL
        bed, water = {}, {}
        for i, kind in enumerate(kinds):
            x, z = places[3 * i], places[3 * i + 2]
            column = math.floor(x / spacing)
            if kind == bed_kind and (kind == SEDIMENT or z < 0):
                bed.setdefault(column, []).append((x, z, i))
            elif kind == WATER:
                water.setdefault(column, []).append((z, i))
        for column, near in sorted(water.items()):
            middle = (column + 0.5) * spacing
            grains = [(z, i) for beside in (column - 1, column, column + 1) for x, z, i in bed.get(beside, [])
                      if abs(x - middle) <= spacing]
            if middle < self.gate or not grains:
                continue
            top = self.top(sorted(grains), spacing) if bed_kind == SEDIMENT else max(grains)
            above = [place for place in near if place[0] > top[0]]
            if above:
                low = min(above)
                weight = (density[top[1]] + density[low[1]]) / 2 * GRAVITY * (low[0] - top[0])
                yield (low[0] - top[0]) / spacing - 0.5, pressure[top[1]] - pressure[low[1]] - weight

    @staticmethod
    def top(grains, spacing):
        """The highest of the particles (z, number), lowest first, before the first gap: grains that fly do not count."""
        for below, above in zip(grains, grains[1:]):
            if above[0] - below[0] > 2 * spacing:
                return below
        return grains[-1]


class StillTank:
    """Water at rest over a floor.

    pressure: root mean square of pressure less hydrostatic, over that of the hydrostatic pressure; speed: root mean square over
    sqrt(g H); both over the run's second half. start-up noise: root mean square of a sensor on the floor about its mean, over rho g H,
    from 0.25 to 0.5 s: sound of the start, which a damper should have quieted by then and which is slower than 10 ms (its longest
    tone has the period 4 H/c). noise: the same less the running mean over 10 ms, of the whole run."""

    start = None
    depth = 0.3  # [m]

    def errors(self, run, finest=None):
        wrong, speeds = [], []
        files = snapshots(run.folder)
        for file in files[len(files) // 2:]:
            particles = arrays(file, {"Type", "Points", "Velocity", "Pressure"})
            water = of_fluid(particles)
            exact = [1000 * GRAVITY * max(0.0, self.depth - particles["Points"][3 * i + 2]) for i in water]
            wrong.append(rms(particles["Pressure"][i] - p for i, p in zip(water, exact)) / rms(exact))
            speeds.append(rms(math.hypot(*particles["Velocity"][3 * i:3 * i + 3]) for i in water))
        floor = Gauges(run).series("floor.pressure", 1.0, 1000 * GRAVITY * self.depth)
        return {"pressure": rms(wrong), "speed": rms(speeds) / math.sqrt(GRAVITY * self.depth),
                "start-up noise": water_norms.deviation(floor, 0.25, 0.5),
                "noise": water_norms.noise(floor, 0.01, 0, floor[-1][0]), "energy rise": energy_rise(run)}


class Falling:
    """Water that falls and splashes: energy rise [spacings]; energy at the end less at the start, in the same unit."""

    start = None

    def errors(self, run, finest=None):
        first = read_table(run.folder / "history.csv")[0]
        unit = first["water_mass"] * GRAVITY * quantity(resolved(run.folder)["numerics"]["spacing"])
        energies = [energy for _, energy in total_energies(run)]
        return {"energy rise": energy_rise(run), "end": (energies[-1] - energies[0]) / unit}
