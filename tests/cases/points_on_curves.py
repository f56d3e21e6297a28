#!/usr/bin/python3
"""How well the curves of an x.tri.h5 keep to points: points_on_curves.py TRI POINTS, POINTS being lines of x and y.

Prints as JSON, in units of the face's diameter where lengths:
  off       the greatest distance of a point from the nearest knot of a curve, at which interpolation must meet it
  turn      the greatest turn of the tangent, radians, and
  bend      the greatest relative jump of curvature, over knots and joints that are no corners
  names     of the curves
Curves are evaluated here, from the numbers of the file (h5dump), by code that the tools do not share."""
import json, math, re, subprocess, sys


def dataset(name):
    command = ["h5dump", "-y", "-A", "0", "-m", "%.17g", "-d", f"/face/{name}", sys.argv[1]]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return text[text.index("DATA {") + 6 :]


def numbers(name):
    return [float(word) for word in re.findall(r"[-+.\dinfae]+", dataset(name)) if re.search(r"\d", word)]


def value(knots, poles, degree, t, span):
    """By de Boor's algorithm, on the span that begins with knot `span`."""
    local = [poles[span - degree + k] for k in range(degree + 1)]
    for level in range(1, degree + 1):
        for k in range(degree, level - 1, -1):
            low, high = knots[span - degree + k], knots[span + 1 + k - level]
            local[k] = local[k - 1] + (t - low) / (high - low) * (local[k] - local[k - 1])
    return local[degree]


def derived(knots, poles, degree):
    rise = [degree * (b - a) / (knots[i + 1 + degree] - knots[i + 1]) for i, (a, b) in enumerate(zip(poles, poles[1:]))]
    return knots[1:-1], rise, degree - 1


class Curve:
    def __init__(self, degree, knots, poles):
        first = (knots, poles, degree)
        self.levels = [first, derived(*first), derived(*derived(*first)) if degree > 1 else None]
        self.degree = degree
        self.spans = [i for i in range(degree, len(poles)) if knots[i + 1] > knots[i]]
        self.knots = knots

    def at(self, t, span):
        """Position, unit tangent, curvature."""
        x, d = (value(*level, t, span - k) for k, level in enumerate(self.levels[:2]))
        e = value(*self.levels[2], t, span - 2) if self.levels[2] else 0
        return x, d / abs(d), (d.conjugate() * e).imag / abs(d) ** 3

    def ends(self):
        """Both sides of each inner knot, and the two ends, as values of `at`."""
        sides = [(self.at(self.knots[s], s), self.at(self.knots[s + 1], s)) for s in self.spans]
        return sides[0][0], sides[-1][1], [(a[1], b[0]) for a, b in zip(sides, sides[1:])]


def curves():
    degrees = [int(d) for d in numbers("curves/degree")]
    knots, poles, weights = numbers("curves/knots"), numbers("curves/poles"), numbers("curves/weights")
    poles = [complex(x, y) for x, y in zip(poles[::2], poles[1::2])]
    knot_offsets, pole_offsets = ([int(i) for i in numbers(f"curves/{name}_offsets")] for name in ("knots", "poles"))
    result = []
    for i, degree in enumerate(degrees):
        of_pole = slice(pole_offsets[i], pole_offsets[i + 1])
        # Circles of a far field are not looked at.
        is_plain = all(w == 1 for w in weights[of_pole])
        result.append(Curve(degree, knots[knot_offsets[i] : knot_offsets[i + 1]], poles[of_pole]) if is_plain else None)
    return result


def main():
    size, all_curves = numbers("diameter")[0], curves()
    points = [complex(*map(float, line.split())) for line in open(sys.argv[2], encoding="utf-8") if line.strip()]
    offsets, corners = [int(i) for i in numbers("loop_offsets")], numbers("joints/is_corner")
    places, pairs = [], []
    for low, high in zip(offsets, offsets[1:]):
        ends = [curve and curve.ends() for curve in all_curves[low:high]]
        for k, found in enumerate(ends):
            if not found:
                continue
            places += [found[0][0], found[1][0]] + [a[0] for a, _ in found[2]]
            pairs += found[2]
            if ends[k - 1] and not corners[low + k]:
                pairs.append((ends[k - 1][1], found[0]))
    turn = [abs(math.atan2((a[1].conjugate() * b[1]).imag, (a[1].conjugate() * b[1]).real)) for a, b in pairs]
    bend = [abs(a[2] - b[2]) / (abs(a[2]) + abs(b[2]) + 1 / size) for a, b in pairs]
    print(json.dumps({
        "off": max(min(abs(z - p) for p in places) for z in points) / size,
        "turn": max(turn, default=0),
        "bend": max(bend, default=0),
        "names": re.findall(r'"([^"]*)"', dataset("curve_names").replace("\\000", "")),
    }))


main()
