"""The C2 cubic through points, by chord length (de Boor, A Practical Guide to Splines, ch. IV). It is periodic, or "not
a knot" at its ends, so that its error falls with the fourth power of the spacing up to the ends."""


def chord_lengths(points):
    """The length of the polygon up to each point."""
    t = [0.0]
    for a, b in zip(points, points[1:]):
        t.append(t[-1] + abs(b - a))
    return t


def spans_and_slopes(t, z):
    """Lengths h of the parameter intervals, and the slopes d of the polygon on them."""
    h = [b - a for a, b in zip(t, t[1:])]
    return h, [(b - a) / step for a, b, step in zip(z, z[1:], h)]


def open_derivatives(t, z, start=None, end=None):
    """Derivatives at the parameters t of the C2 cubic through z that has one cubic on its first two intervals, and one
    on its last two. Three points: of the parabola. `start`, `end`: derivatives there, if they are given."""
    h, d = spans_and_slopes(t, z)
    n = len(h)
    if n == 2 and start is None and end is None:
        bend = (d[1] - d[0]) / (h[0] + h[1])
        return [d[0] - bend * h[0], d[0] + bend * h[0], d[1] + bend * h[1]]
    inner = range(1, n)
    right = [3 * (h[i] * d[i - 1] + h[i - 1] * d[i]) for i in inner]
    first, last = end_row(h, d, start), end_row(h[::-1], d[::-1], end)
    lower = [0.0] + [h[i] for i in inner] + [last[1]]
    middle = [first[0]] + [2 * (h[i - 1] + h[i]) for i in inner] + [last[0]]
    upper = [first[1]] + [h[i - 1] for i in inner] + [0.0]
    return solve_tridiagonal(lower, middle, upper, [first[2]] + right + [last[2]])


def end_row(h, d, derivative):
    """Coefficients of the derivatives at an end and beside it, and the right side: the derivative itself, or a parabola on
    the only other interval, or one cubic on two."""
    if derivative is not None:
        return 1.0, 0.0, derivative
    if len(h) == 2:
        return 1.0, 1.0, 2 * d[0]
    return h[1], h[0] + h[1], not_a_knot(h[0], h[1], d[0], d[1])


def not_a_knot(h0, h1, d0, d1):
    """Right side of the condition at an end with the intervals h0, h1 and slopes d0, d1, the outer ones first."""
    return ((h0 + 2 * (h0 + h1)) * h1 * d0 + h0 * h0 * d1) / (h0 + h1)


def periodic_derivatives(t, z):
    """The same for a closed curve, z[0] = z[-1], that is C2 there too. Its cyclic system is solved as a tridiagonal
    one and a change of rank one (Sherman and Morrison)."""
    h, d = spans_and_slopes(t, z)
    n = len(h)
    before = h[-1:] + h[:-1]
    middle = [2 * (before[i] + h[i]) for i in range(n)]
    right = [3 * (h[i] * d[i - 1] + before[i] * d[i]) for i in range(n)]
    gamma, corner_low, corner_high = -middle[0], h[0], before[-1]
    middle[0] -= gamma
    middle[-1] -= corner_low * corner_high / gamma
    plain = solve_tridiagonal(h, middle, before, right)
    change = solve_tridiagonal(h, middle, before, [gamma] + [0.0] * (n - 2) + [corner_high])
    factor = (plain[0] + plain[-1] * corner_low / gamma) / (1 + change[0] + change[-1] * corner_low / gamma)
    derivatives = [a - factor * b for a, b in zip(plain, change)]
    return derivatives + derivatives[:1]


def solve_tridiagonal(lower, middle, upper, right):
    """lower[i] x[i - 1] + middle[i] x[i] + upper[i] x[i + 1] = right[i], without pivoting; lower[0] and upper[-1] do not
    count."""
    middle, x = list(middle), list(right)
    for i in range(1, len(middle)):
        factor = lower[i] / middle[i - 1]
        middle[i] -= factor * upper[i - 1]
        x[i] -= factor * x[i - 1]
    x[-1] /= middle[-1]
    for i in range(len(middle) - 2, -1, -1):
        x[i] = (x[i] - upper[i] * x[i + 1]) / middle[i]
    return x


def poles(t, z, derivatives):
    """Of the clamped cubic B-spline with the simple inner knots t[1:-1]: its blossom at each three successive knots."""
    result = [z[0], z[0] + (t[1] - t[0]) / 3 * derivatives[0]]
    for j in range(1, len(t) - 1):
        step = t[j] - t[j - 1]
        first, second = z[j - 1] + step / 3 * derivatives[j - 1], z[j] - step / 3 * derivatives[j]
        result.append(first + (t[j + 1] - t[j - 1]) / step * (second - first))
    return result + [z[-1] - (t[-1] - t[-2]) / 3 * derivatives[-1], z[-1]]


def cubic(poles, u):
    """The point of the cubic with four Bezier poles at the parameter u between 0 and 1 (de Casteljau)."""
    while len(poles) > 1:
        poles = [(1 - u) * a + u * b for a, b in zip(poles, poles[1:])]
    return poles[0]


def bezier_poles(poles, knots):
    """The four Bezier poles of each cubic of a clamped spline with simple inner knots: its blossom, once more."""
    t = knots[:1] + knots + knots[-1:]
    inner = []  # the two inner poles of each cubic
    for i in range(len(knots) - 1):
        before, first, last, behind = t[i : i + 4]
        step = (poles[i + 2] - poles[i + 1]) / (behind - before)
        inner.append([poles[i + 1] + (first - before) * step, poles[i + 1] + (last - before) * step])
    joints = [poles[0]]
    for i, (one, two) in enumerate(zip(inner, inner[1:])):
        joints.append(one[1] + (two[0] - one[1]) * (t[i + 2] - t[i + 1]) / (t[i + 3] - t[i + 1]))
    joints.append(poles[-1])
    return [[a] + between + [b] for a, between, b in zip(joints, inner, joints[1:])]
