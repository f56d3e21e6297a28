"""What all readers of this folder return, and how two of it are compared. No code is shared with the writers."""
import json
from dataclasses import dataclass, field
from math import cos, dist, pi
from pathlib import Path


@dataclass
class ElementMesh:
    """Elements as the solver that reads the file would have them: for each the (N+1)^2 positions (x, y, z) at its
    Gauss-Lobatto-Legendre points, first coordinate fastest, sides 0 to 3 counter-clockwise from node (0, 0) to (N, 0)."""
    order: int
    elements: list
    regions: list      # a name for each element, or a number where the file has no names; None: it has no regions
    boundaries: dict   # (element, side) -> name or number
    num_vertices: int
    diameter: float = 0
    metres: float = 1  # of one unit, 1 where it is unknown
    numbers: dict = field(default_factory=dict)


def legendre(n, x):
    """P_n(x) and P_{n-1}(x) by Bonnet's recursion."""
    before, now = 1.0, x
    for k in range(2, n + 1):
        before, now = now, ((2 * k - 1) * x * now - (k - 1) * before) / k
    return (now, before) if n > 0 else (1.0, 0.0)


def gll_points(n):
    """The n + 1 zeros of (1 - x^2) P_n'(x), ascending: Newton from the Chebyshev-Lobatto points."""
    points = []
    for k in range(n + 1):
        x = -cos(pi * k / n)
        if 0 < k < n:
            for _ in range(50):  # (1 - x^2) P_n' = n (P_{n-1} - x P_n), whose derivative is -n (n + 1) P_n
                p, q = legendre(n, x)
                step = (q - x * p) / ((n + 1) * p)
                x += step
                if abs(step) < 1e-16:
                    break
        points.append(x)
    return points


def side_indices(n, side):
    """Local nodes of a side, counter-clockwise."""
    starts, strides = (0, n, (n + 1) ** 2 - 1, n * (n + 1)), (1, n + 1, -1, -(n + 1))
    return [starts[side] + k * strides[side] for k in range(n + 1)]


def from_corner(n, nodes, corner):
    """The nodes of an element in tensor order from another corner on, first coordinate along the side of its number."""
    starts, strides = (0, n, (n + 1) ** 2 - 1, n * (n + 1)), (1, n + 1, -1, -(n + 1))
    return [nodes[starts[corner] + i * strides[corner] + j * strides[(corner + 1) % 4]]
            for j in range(n + 1) for i in range(n + 1)]


def turned_to(found, wanted):
    """Starts each element at the corner at which the wanted one starts, for formats that choose another corner."""
    if len(found.elements) != len(wanted.elements):
        return found
    n = found.order
    corners = (0, n, (n + 1) ** 2 - 1, n * (n + 1))
    first = [min(range(4), key=lambda c: dist(got[corners[c]], want[0]))
             for got, want in zip(found.elements, wanted.elements)]
    found.elements = [from_corner(n, nodes, corner) for nodes, corner in zip(found.elements, first)]
    found.boundaries = {(e, (side - first[e]) % 4): name for (e, side), name in found.boundaries.items()}
    return found


def differences(found, wanted, tolerance=1e-13):
    """Sentences on what differs; positions are compared to a share of the wanted mesh's diameter."""
    if found.order not in (wanted.order, None):
        return [f"order {found.order} for {wanted.order}"]
    said = [f"{len(got)} {what} for {len(want)}" for what, got, want in (
        ("elements", found.elements, wanted.elements), ("boundary edges", found.boundaries, wanted.boundaries))
        if len(got) != len(want)]
    if found.num_vertices != wanted.num_vertices:
        said.append(f"{found.num_vertices} vertices for {wanted.num_vertices}")
    if said:
        return said
    worst, where = 0.0, None
    for e, (got, want) in enumerate(zip(found.elements, wanted.elements)):
        for k, (a, b) in enumerate(zip(got, want, strict=True)):
            if not dist(a, b) <= worst:
                worst, where = dist(a, b), (e, k)
    if not worst <= tolerance * wanted.diameter:
        said.append(f"node {where[1]} of element {where[0]} is off by {worst / wanted.diameter:g} diameters")
    named = [("boundary", found.boundaries, wanted.boundaries)]
    if found.regions is not None:
        named.append(("region", dict(enumerate(found.regions)), dict(enumerate(wanted.regions))))
    for what, got, want in named:
        for key in want:
            if got.get(key) != want[key]:
                said.append(f"{what} of {key} is {got.get(key)!r} for {want[key]!r}")
                break
    return said


def real_names(path, kind="boundaries"):
    """word in the file -> name of the boundary (or kind="regions"), where the table beside the file has another one."""
    table = Path(f"{path}.names.json")
    if not table.exists():
        return {}
    groups = json.loads(table.read_text(encoding="utf-8"))[kind]
    return {group["tag"]: group["name"] for group in groups if "tag" in group}
