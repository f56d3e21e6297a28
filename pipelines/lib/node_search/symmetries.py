"""Isometries that map a layout onto itself, and the nodes that they map onto each other."""
from dataclasses import dataclass

SAME = 1e-6  # diameters: positions nearer to each other than this are one


class Marks:
    """All nodes of a layout: (kind, position). Its isometries map each node onto one of the same kind, and so the
    centroid onto itself."""

    def __init__(self, marks, diameter):
        self.marks, self.tolerance = marks, SAME * diameter
        self.centre = sum(z for _, z in marks) / len(marks)

    def image(self, linear, z):
        """Of a point under the isometry with this linear part."""
        return self.centre + linear(z - self.centre)

    def is_symmetric(self, linear):
        return all(any(kind == other and abs(self.image(linear, z) - w) < self.tolerance for other, w in self.marks)
                   for kind, z in self.marks)

    def possible_images(self):
        """Positions of the nodes onto which an isometry may map the first of them: those of one kind and one distance
        from the centre, as few as possible. Empty if all nodes lie in the centre."""
        radius = lambda mark: abs(mark[1] - self.centre)
        away = [mark for mark in self.marks if radius(mark) > 1e3 * self.tolerance]
        alike = lambda mark: [m for m in away if m[0] == mark[0] and abs(radius(m) - radius(mark)) < self.tolerance]
        return [z for _, z in alike(min(away, key=lambda mark: len(alike(mark))))] if away else []


def isometries(marks):
    """The linear parts of the isometries of the layout, as functions."""
    images = marks.possible_images()
    if not images:
        return [lambda z: z]
    base, found = images[0] - marks.centre, []
    for image in images:
        rotation = (image - marks.centre) / base
        mirror = (image - marks.centre) / base.conjugate()
        found += [lambda z, c=rotation / abs(rotation): c * z, lambda z, c=mirror / abs(mirror): c * z.conjugate()]
    return [linear for linear in found if marks.is_symmetric(linear)]


@dataclass(frozen=True)
class Orbit:
    """Nodes that move together: `maps` has, for each, the map from a move of the first to its own. `fixing`: the maps
    that leave the first where it is."""

    first: int
    maps: dict
    fixing: list

    def symmetric_part(self, move):
        """The nearest move of the first node that the maps in `fixing` do not change."""
        return sum(linear(move) for linear in self.fixing) / len(self.fixing)

    def moves(self, move):
        """The moves of all nodes for one of the first."""
        return {k: linear(move) for k, linear in self.maps.items()}


def orbits(positions, marks):
    """The orbits of the nodes at these positions under the isometries of `marks`."""
    group, left, result = isometries(marks), set(range(len(positions))), []
    while left:
        first = min(left)
        maps, fixing = {}, []
        for linear in group:
            image = marks.image(linear, positions[first])
            hit = min(range(len(positions)), key=lambda k: abs(positions[k] - image))
            maps.setdefault(hit, linear)
            if hit == first:
                fixing.append(linear)
        result.append(Orbit(first, maps, fixing))
        left -= maps.keys()
    return result
