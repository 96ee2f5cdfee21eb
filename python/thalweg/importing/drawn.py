"""What a definition has drawn: bodies with a role, fillings from a seed, lines."""

from dataclasses import dataclass, field

from thalweg.importing import geometry as geo


@dataclass
class Drawn:
    """A body that was drawn. `faces`: names of the faces of a hollow box; None: it is solid."""
    kind: str    # fluid, bound, void
    mk: int
    line: int
    body: object
    faces: set | None = None
    name: str = ""
    file: str = ""   # a mesh file that is taken as it is, with `placing`
    placing: dict = field(default_factory=dict)


@dataclass
class Filled:
    """A region filled from a seed, as far as walls let it, within `box` (None: everywhere)."""
    kind: str
    mk: int
    line: int
    seed: tuple
    box: object


@dataclass
class Chain:
    """Lines drawn one after the other."""
    points: list

    def corners(self):
        return geo.bounds(self.points).corners()

    def contains(self, _, by=0.0):
        return False
