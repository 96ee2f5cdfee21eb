"""Uniform flow down a rough channel, against the logarithmic law of the wall."""

import math

from study import norms
from study.results import quantity, resolved, snapshots
from thalweg.particle_file import WATER, arrays, of_fluid


class Channel:
    """rows: root mean square of the rows' velocities, less the law's at their middle, over the mean velocity of the law; mean: relative
    error of the mean velocity; both over the last third of the run. The lowest and the highest row are left out of the rows: half of
    the lowest lies in the wall's element, and the highest is not full."""

    start = None
    depth = 0.1            # [m]
    gravity = 9.81         # [m/s^2]
    slope = 1.97349643e-3  # [-] of matrix.toml: a friction velocity of 44 mm/s
    roughness = 1e-3       # [m] of the floor
    viscosity = 1e-6       # [m^2/s] of the water
    begin = 30.0           # [s] of 45

    def errors(self, run, finest=None):
        samples = []
        for file in snapshots(run.folder):
            particles = arrays(file, {"Type", "Points", "Velocity", "TimeValue"})
            if particles["TimeValue"][0] < self.begin - 1e-6:
                continue
            samples += [(particles["Points"][3 * i + 2], particles["Velocity"][3 * i], 1.0) for i in of_fluid(particles)
                        if particles["Type"][i] == WATER]
        return self.of_samples(samples, quantity(resolved(run.folder)["numerics"]["spacing"]))

    def law(self):
        return norms.LogLaw(math.sqrt(self.gravity * self.depth * self.slope), self.viscosity, self.roughness)

    def of_samples(self, samples, row_height):
        """Errors of samples (height [m], velocity [m/s], weight)."""
        law = self.law()
        mean = law.mean(self.depth)
        count = round(self.depth / row_height)
        flow, weight = [0.0] * count, [0.0] * count
        all_flow = all_weight = 0.0
        for z, u, w in samples:
            row = min(max(int(z / row_height), 0), count - 1)
            flow[row] += w * u
            weight[row] += w
            all_flow += w * u
            all_weight += w
        rows = [flow[row] / weight[row] - law.velocity((row + 0.5) * row_height) for row in range(1, count - 1)]
        return {"rows": norms.rms(rows) / mean, "mean": all_flow / all_weight / mean - 1}
