"""A plane wall jet below still water, against the decay of its largest velocity that was measured."""

import math

from study import norms
from study.results import quantity, resolved, snapshots
from thalweg.particle_file import WATER, arrays, of_fluid


class WallJet:
    """decay: root mean square of the largest velocity at x/b = 15, 17 … 25 over the measured U 3.5/sqrt(x/b), less 1 (Rajaratnam 1976,
    Turbulent Jets); mean: the mean of the same. The largest velocity is that of the fastest row, a row a spacing high and b wide, in
    the mean from `begin` on."""

    start = None
    opening = 0.015    # [m] b
    velocity = 1.2     # [m/s] U
    height = 0.1       # [m] of the rows that are looked at
    places = (15, 17, 19, 21, 23, 25)
    begin = 5.0        # [s] of 8; the mesh's jet takes 3 s to reach the last place

    def errors(self, run, finest=None):
        samples = []
        for file in snapshots(run.folder):
            particles = arrays(file, {"Type", "Points", "Velocity", "TimeValue"})
            if particles["TimeValue"][0] < self.begin:
                continue
            points = particles["Points"]
            samples += [(points[3 * i], points[3 * i + 2], particles["Velocity"][3 * i], 1.0) for i in of_fluid(particles)
                        if particles["Type"][i] == WATER]
        return self.of_samples(samples, quantity(resolved(run.folder)["numerics"]["spacing"]))

    def of_samples(self, samples, row_height):
        """Errors of samples (x [m], height [m], velocity [m/s], weight)."""
        rows = {}
        for x, z, u, weight in samples:
            place = next((n for n in self.places if abs(x / self.opening - n) <= 0.5), None)
            if place is not None and z < self.height:
                flow, all_of_it = rows.get((place, int(z / row_height)), (0.0, 0.0))
                rows[place, int(z / row_height)] = (flow + weight * u, all_of_it + weight)
        largest = [max(flow / weight for (there, _), (flow, weight) in rows.items() if there == place) for place in self.places]
        shares = [u / (self.velocity * 3.5 / math.sqrt(place)) for u, place in zip(largest, self.places)]
        return {"decay": norms.rms(share - 1 for share in shares), "mean": sum(shares) / len(shares) - 1}
