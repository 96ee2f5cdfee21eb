"""Figures of a set of particles, as thalweg/particle_file.py reads it: SI units."""

from thalweg.particle_file import WATER


def front_of_water(particles, spacing):
    """Half a spacing beyond the third foremost particle of water along x [m], so that two drops thrown ahead do not count."""
    places = particles["Points"]
    return sorted(places[3 * i] for i, kind in enumerate(particles["Type"]) if kind == WATER)[-3] + spacing / 2
