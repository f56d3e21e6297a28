"""The edges of a loop as a fine polygon, to tell what lies inside of it and how far away it is."""
from dataclasses import dataclass

from outline import polygons, splines
from outline.corners import turning_angle
from outline.edges import Spline

PIECES = 16  # of each cubic; less where a loop has thousands of them
MOST_POINTS = 4000
CORNER = 20.0  # degrees; between neighbouring pieces of a smooth edge the turn is far less


@dataclass(frozen=True)
class FineLoop:
    points: list  # of a closed polygon
    corners: list  # (position, length of the shorter of the two edges that meet there)
    box: tuple  # least and greatest x, least and greatest y

    def nearest(self, z):
        """The point of the polygon nearest to z."""
        sides = zip(self.points, self.points[1:] + self.points[:1])
        return min((polygons.nearest_on_segment(z, a, b) for a, b in sides), key=lambda w: abs(w - z))


def fine_loop(edges):
    """Of the closed loop of edges."""
    cubics = sum(len(edge.knots) - 1 for edge in edges if isinstance(edge, Spline))
    pieces = max(2, min(PIECES, MOST_POINTS // max(cubics, 1)))
    runs = [fine_edge(edge, pieces) for edge in edges]
    lengths = [splines.chord_lengths(run)[-1] for run in runs]
    corners = [(run[0], min(lengths[i - 1], lengths[i])) for i, run in enumerate(runs)
               if turning_angle(run[0] - runs[i - 1][-2], run[1] - run[0]) > CORNER]
    points = [z for run in runs for z in run[:-1]]
    return FineLoop(points, corners, box_of(points))


def box_of(points):
    across, up = [z.real for z in points], [z.imag for z in points]
    return min(across), max(across), min(up), max(up)


def boxes_meet(one, other):
    return one[0] <= other[1] and other[0] <= one[1] and one[2] <= other[3] and other[2] <= one[3]


def fine_edge(edge, pieces=PIECES):
    """Points of a line or a spline, from its start to its end."""
    if not isinstance(edge, Spline):
        return [edge.start, edge.end]
    cubics = splines.bezier_poles(edge.poles, edge.knots)
    return [edge.start] + [splines.cubic(poles, k / pieces) for poles in cubics for k in range(1, pieces + 1)]
