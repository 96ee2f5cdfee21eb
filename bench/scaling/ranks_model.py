#!/usr/bin/env python3
"""Predicts how a scene runs on many ranks: ranks_model.py [--spacings "20 mm" …]

The partition is counted, not guessed: list cells of a flume in the solver's own order (solver/lists/sort.hpp), cut into ranges of
equal numbers of particles, for each range the cells of others around it, and the cells of its own that have none of them near: its
interior. How often a step sends and how much was counted by scaling.py --part ranks. A sweep computes its interior while the copies
that it needs are on their way, as in_parts() of solver/backend/device.hpp does: of an exchange beside a sweep counts what the interior
leaves over. Exchanges that have no sweep beside them, and sums over all ranks, count whole. scaling.py --part flume measures the same.
"""

import argparse
import math
import sys
from dataclasses import dataclass

import numpy as np

FLUME = (5.0, 0.5, 0.3)  # [m]
REACH = 3.3  # of the lists, in spacings: support 3, skin a tenth
SLACK = 0.02  # of a rank's share, at either end
RANKS = (1, 2, 4, 8, 16, 64, 256, 1024, 4096)

# Measured (bench/records/scaling-space.md); rounded.
NS_STEP = {"water": 270.0, "bed": 320.0}  # CPU ns a particle-step, one core, lists and viscous solve apart
NS_LISTS = {"water": 430.0, "bed": 570.0}  # a particle, each time lists are made
NS_ITERATION = 50.0  # a particle and viscous iteration
STEPS_PER_LISTS = 15  # assumed
# Of a step without lists and viscous solve, the sweeps over the fluid that need copies (timing.csv of the scenes of scaling.py
# --part ranks): forces and density rates. The sweep of the walls' pressure is too short to hide anything.
SWEEPS = {"water": (0.51, 0.41), "bed": (0.36, 0.54)}
SUM_BLOCK = 512  # particles: in a viscous iteration, whose sweep has a sum, a block waits if one of its clusters does
# Counted (bench/records/scaling-ranks.md): of a step, what lists cost included, without the viscous solve; and of an iteration.
EXCHANGES = {"water": 4, "bed": 5}
QUADS = {"water": 8.5, "bed": 10}  # of 16 bytes that these carry, of each copy
COLLECTIVES = {"water": 5, "bed": 6}
COLLECTIVES_AN_ITERATION = 2
ITERATIONS = 8  # assumed
# Assumed of a cluster.
LATENCY = 2e-6  # [s] a message between machines
HOP = 3e-6  # [s] a collective takes for each doubling of the ranks
BANDWIDTH = 10e9  # [B/s] a rank


def hilbert(cells, bits):
    """The place along the curve of cells, an array of (n, 3): as solver/lists/hilbert.hpp."""
    x = [cells[:, k].astype(np.uint64) for k in range(3)]
    one = np.uint64(1)
    side = one << np.uint64(bits - 1)
    while side > 1:
        inside = side - one
        for k in range(3):
            is_set = (x[k] & side) != 0
            swapped = np.where(is_set, np.uint64(0), (x[0] ^ x[k]) & inside)
            x[0] ^= np.where(is_set, inside, swapped)
            x[k] ^= swapped
        side >>= one
    for k in (1, 2):
        x[k] ^= x[k - 1]
    flip = np.zeros_like(x[0])
    side = one << np.uint64(bits - 1)
    while side > 1:
        flip ^= np.where((x[2] & side) != 0, side - one, np.uint64(0))
        side >>= one
    code = np.zeros_like(x[0])
    for bit in range(bits - 1, -1, -1):
        for k in range(3):
            code = code << one | ((x[k] ^ flip) >> np.uint64(bit) & one)
    return code


class Partition:
    """The flume's list cells in their order."""

    def __init__(self, spacing):
        width = REACH * spacing
        self.shape = tuple(max(1, math.ceil(length / width)) for length in FLUME)
        self.particles = round(np.prod([length / spacing for length in FLUME]))
        self.per_cell = self.particles / np.prod(self.shape)
        grid = np.stack(np.meshgrid(*(np.arange(n) for n in self.shape), indexing="ij"), axis=-1).reshape(-1, 3)
        bits = int(max(self.shape) - 1).bit_length()
        longest = max(self.shape)
        eighth = (1 << bits) // 8
        part = grid * 8 // longest  # as HilbertKey
        on_curve = part * eighth + grid - (part * longest + 7) // 8 if longest >= 64 else grid
        codes = hilbert(on_curve, bits)
        order = np.argsort(codes, kind="stable")
        self.codes = codes[order]
        self.rank_order = np.empty(len(grid), dtype=np.int64)
        self.rank_order[order] = np.arange(len(grid))

    def begins(self, ranks):
        """Where the ranks' ranges begin, within the slack of their shares: as cut_by_weight()."""
        share = len(self.codes) / ranks
        begins = []
        for rank in range(1, ranks):
            low, high = (int(self.codes[round(rank * share + sign * SLACK * share)]) for sign in (-1, 1))
            bits = max(0, (low ^ high).bit_length() - 1)
            begins.append(np.searchsorted(self.codes, high >> bits << bits))
        return np.array(begins, dtype=np.int64)

    def cut(self, ranks):
        """Of the rank with most copies, and the mean of the copies over the particles."""
        begins = self.begins(ranks)
        owner = np.searchsorted(begins, self.rank_order, side="right").reshape(self.shape)
        number = np.arange(owner.size, dtype=np.int64).reshape(self.shape)
        pairs, meetings, borders = [], [], []
        for offset in np.ndindex(3, 3, 3):
            here = tuple(slice(max(0, 1 - o), n - max(0, o - 1)) for o, n in zip(offset, self.shape))
            there = tuple(slice(max(0, o - 1), n - max(0, 1 - o)) for o, n in zip(offset, self.shape))
            differ = owner[here] != owner[there]
            if not differ.any():
                continue
            pairs.append(np.unique(owner[here][differ] * owner.size + number[there][differ]))
            meetings.append(np.unique(owner[here][differ] * ranks + owner[there][differ]))
            borders.append(np.unique(number[here][differ]))
        if not pairs:
            return Cut()
        copies = np.bincount(np.unique(np.concatenate(pairs)) // owner.size, minlength=ranks) * self.per_cell
        partners = np.bincount(np.unique(np.concatenate(meetings)) // ranks, minlength=ranks)
        rank = int(copies.argmax())
        ends = np.concatenate([[0], begins, [owner.size]])
        at_border = np.sort(self.rank_order[np.unique(np.concatenate(borders))])
        at_border = at_border[slice(*np.searchsorted(at_border, ends[rank:rank + 2]))] - ends[rank]
        size = int(ends[rank + 1] - ends[rank])
        block = max(1, round(SUM_BLOCK / self.per_cell))
        return Cut(copies.max(), int(partners.max()), copies.sum() / self.particles, 1 - len(at_border) / size,
                   1 - len(np.unique(at_border // block)) / math.ceil(size / block))


@dataclass
class Cut:
    """Of the rank with most copies; nothing to exchange: one rank."""
    copies: float = 0
    partners: int = 0             # at most, of any rank
    mean_copies: float = 0        # of all ranks, a particle
    interior: float = 1           # share of the particles that have no copy near
    interior_blocks: float = 1    # share of the blocks of sums that have no such particle


def seconds_of_step(kind, particles, cut, ranks):
    """(computing, exchanges, collectives) [s]; of exchanges what no computing hides."""
    iterations = ITERATIONS if kind == "bed" else 0
    own = particles / ranks * 1e-9
    sweeps = own * NS_STEP[kind] * np.array(SWEEPS[kind])
    iteration = own * NS_ITERATION
    computing = own * (NS_STEP[kind] + NS_LISTS[kind] / STEPS_PER_LISTS) + iterations * iteration
    if ranks == 1:
        return computing, 0.0, 0.0
    latency = cut.partners * LATENCY
    exchange = latency + cut.copies * 16 * QUADS[kind] / EXCHANGES[kind] / BANDWIDTH
    of_iteration = latency + cut.copies * 16 / BANDWIDTH
    left = np.maximum(0, exchange - cut.interior * sweeps).sum() + (EXCHANGES[kind] - len(sweeps)) * exchange
    left += iterations * max(0.0, of_iteration - cut.interior_blocks * iteration)
    collectives = (COLLECTIVES[kind] + iterations * COLLECTIVES_AN_ITERATION) * HOP * math.log2(ranks)
    return computing, left, collectives


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--spacings", nargs="+", type=float, default=[6.3e-3, 2.466e-3, 1.145e-3],
                        help="of the flume 5 m x 0.5 m x 0.3 m [m]; default: 3, 50 and 500 million particles")
    parser.add_argument("--most-ranks", type=int, default=RANKS[-1])
    arguments = parser.parse_args()
    for spacing in arguments.spacings:
        partition = Partition(spacing)
        print(f"\n{partition.particles / 1e6:.0f} million particles, spacing {spacing * 1000:.3g} mm\n")
        print("| ranks | copies a particle | ranks that one exchanges with, at most | interior | water: ms a step | efficiency "
              "| bed: ms a step | efficiency |\n|---|---|---|---|---|---|---|---|")
        alone = {}
        for ranks in (r for r in RANKS if r <= arguments.most_ranks):
            cut = partition.cut(ranks)
            cells = [f"{ranks}", f"{cut.mean_copies:.3f}", f"{cut.partners}", f"{cut.interior:.2f}"]
            for kind in ("water", "bed"):
                total = sum(seconds_of_step(kind, partition.particles, cut, ranks))
                alone.setdefault(kind, total)
                cells += [f"{total * 1000:.3g}", f"{alone[kind] / total / ranks:.2f}"]
            print("| " + " | ".join(cells) + " |", flush=True)
    print(f"\nAssumed: {LATENCY * 1e6:g} us a message, {HOP * 1e6:g} us a collective for each doubling of the ranks, "
          f"{BANDWIDTH / 1e9:g} GB/s a rank, {ITERATIONS} viscous iterations a step, new lists every {STEPS_PER_LISTS} steps, "
          "one core a rank, all ranks equally loaded. Interior: share of the particles, on the rank with most copies, that has "
          "none near; they are computed while copies travel.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
