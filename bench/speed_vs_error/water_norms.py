"""What judges water: standing waves, noise of a signal, energies, contact with a bed. Pure functions, SI units."""

import bisect
import math

from study.norms import slope

GRAVITY = 9.81  # [m/s^2]


def wave_number(length, modes=1):
    """[1/m] of the standing mode with this many half waves between the walls of a tank of this length [m]."""
    return modes * math.pi / length


def standing_period(wave_number, depth, amplitude, gravity=GRAVITY):
    """Period [s] of a standing wave, to the second order in its steepness (Tadjbakhsh & Keller 1960):
    omega = sqrt(g k) [s + (k a)^2/2 w2],  s = sqrt(tanh k d),  w2 = (9/s^7 - 12/s^3 - 3 s - 2 s^5)/32.
    In deep water this is Rayleigh's omega = sqrt(g k) (1 - (k a)^2/8). amplitude a: half the height from trough to crest [m]."""
    s = math.sqrt(math.tanh(wave_number * depth))
    second = (9 / s ** 7 - 12 / s ** 3 - 3 * s - 2 * s ** 5) / 32
    omega = math.sqrt(gravity * wave_number) * (s + (wave_number * amplitude) ** 2 / 2 * second)
    return 2 * math.pi / omega


def mode_displacement(x, z, wave_number, depth, amplitude):
    """Displacement (dx, dz) [m] of the particle that rests at (x, z) when the linear mode is at its turning point, where the surface
    stands at amplitude * cos(k x): free of divergence, along the walls at the walls."""
    over = amplitude / math.sinh(wave_number * depth)
    return (-over * math.cosh(wave_number * z) * math.sin(wave_number * x),
            over * math.sinh(wave_number * z) * math.cos(wave_number * x))


def mode_pressure(x, z, wave_number, depth, amplitude, density, gravity=GRAVITY):
    """Pressure [Pa] of the linear mode at its turning point, of the particle that rests at (x, z): 0 at the surface. The weight of
    the water over the place it is moved to, less what accelerates the water below a crest downwards."""
    under = wave_number * depth
    wave = math.cosh(wave_number * z) / math.cosh(under) - math.sinh(wave_number * z) / math.sinh(under)
    return density * gravity * (depth - z + amplitude * math.cos(wave_number * x) * wave)


def wave_energy(length, amplitude, density, gravity=GRAVITY):
    """Energy [J/m] of a standing wave of any number of half waves over that of water at rest: density g a^2 L/4."""
    return density * gravity * amplitude ** 2 * length / 4


def vertex(points):
    """The vertex (time, value) of the parabola through samples (time, value), least squares; three samples or more."""
    middle = sum(t for t, _ in points) / len(points)
    half = max(abs(t - middle) for t, _ in points)
    sums = [sum(((t - middle) / half) ** n for t, _ in points) for n in range(5)]
    right = [sum(v * ((t - middle) / half) ** n for t, v in points) for n in range(3)]
    c = solve3([[sums[i + j] for j in range(3)] for i in range(3)], right)
    at = -c[1] / (2 * c[2])
    return middle + half * at, c[0] + c[1] * at + c[2] * at * at


def solve3(matrix, right):
    """Three linear equations, by Cramer's rule."""
    def determinant(m):
        return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))

    whole = determinant(matrix)
    return [determinant([[right[i] if j == k else matrix[i][j] for j in range(3)] for i in range(3)]) / whole for k in range(3)]


def decay_of_swing(kinetic, period):
    """(loss, period, disorder) of a wave that swings from rest, from its kinetic energy as samples (time [s], energy).

    The kinetic energy of a standing wave is E sin^2(2 pi t/T): a peak in each half period, nothing between. `period` is the expected
    one [s]; each peak lies in its own half. Peaks are vertices of parabolas through the samples within T/12.
    loss: share of the wave's energy that goes in a period, 1 - exp(-rate T), the rate from the straight line through the logarithms of
    the peaks, each less what is left of kinetic energy at the turning points beside it, which is motion without order.
    period [s]: twice the mean distance of peaks, from the straight line through their times.
    disorder: kinetic energy at the last turning point over the last peak."""
    half = period / 2
    peaks, dips = [], []
    for n in range(int(kinetic[-1][0] / half)):
        inside = [(t, k) for t, k in kinetic if n * half <= t < (n + 1) * half]
        top = max(inside, key=lambda point: point[1])[0]
        peaks.append(vertex([(t, k) for t, k in kinetic if abs(t - top) <= period / 12]))
    for (before, _), (after, _) in zip(peaks, peaks[1:]):
        dips.append(min(k for t, k in kinetic if before < t < after))
    beside = [dips[0], *((a + b) / 2 for a, b in zip(dips, dips[1:])), dips[-1]]
    times = [t for t, _ in peaks]
    half_found = slope(range(len(peaks)), times)
    rate = slope(times, [math.log(k - dip) for (_, k), dip in zip(peaks, beside)])
    return 1 - math.exp(rate * 2 * half_found), 2 * half_found, dips[-1] / peaks[-1][1]


def noise(series, window, begin, end):
    """Root mean square of samples (time, value) less their running mean over a centred window [s], for begin <= time < end."""
    times, values = [t for t, _ in series], [v for _, v in series]
    before = [0.0]
    for value in values:
        before.append(before[-1] + value)
    squares, count = 0.0, 0
    for t, value in series:
        if begin <= t < end:
            low = bisect.bisect_left(times, t - window / 2 * (1 + 1e-9))
            high = bisect.bisect_right(times, t + window / 2 * (1 + 1e-9))
            squares += (value - (before[high] - before[low]) / (high - low)) ** 2
            count += 1
    return math.sqrt(squares / count)


def deviation(series, begin, end):
    """Root mean square of samples (time, value) about their mean, for begin <= time < end."""
    values = [value for t, value in series if begin <= t < end]
    mean = sum(values) / len(values)
    return math.sqrt(sum((value - mean) ** 2 for value in values) / len(values))


def rise_above_start(energies):
    """Largest rise of an energy above its first value; 0 if it never rises."""
    return max(0.0, max(energies) - energies[0])


def quantile(values, share):
    """The value below which this share of the values lies, linear between them."""
    ordered = sorted(values)
    place = share * (len(ordered) - 1)
    low = int(place)
    high = min(low + 1, len(ordered) - 1)
    return ordered[low] + (place - low) * (ordered[high] - ordered[low])
