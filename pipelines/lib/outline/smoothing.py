"""Points moved onto a smooth curve, at most by a tolerance: the smoothing spline (C. H. Reinsch, Numer. Math. 10, 1967). It
minimises the sum of the squared moves and a factor times the integral of the squared second derivative; the factor is the
greatest whose moves stay within the tolerance."""
from outline import splines

SHARE = 0.8  # of a tolerance of a curve: for the moves of its points, the rest for the curve between them
GROWTH, HALVINGS = 8.0, 8  # the search for the factor: steps upwards, then halvings of its logarithm
MOST_STEPS = 40


def smoothed(points, tolerance, is_periodic, fixed=()):
    """The points; the first and the last one and those at the positions `fixed` do not move, but those of a closed curve
    (first and last point equal) all do."""
    count = len(points)
    if is_periodic:  # three rounds, of which the middle one knows no end
        laps = points[:-1] * 3 + points[:1]
        moved = factor_search(laps, tolerance, [1.0] * len(laps))
        middle = moved[count - 1 : 2 * (count - 1)]
        return middle + middle[:1]
    weights = [0.0] + [1.0] * (count - 2) + [0.0]
    for k in fixed:
        weights[k] = 0.0
    return factor_search(points, tolerance, weights)


def factor_search(points, tolerance, weights):
    t = splines.chord_lengths(points)
    factor = (t[-1] / (len(t) - 1)) ** 3
    best = points
    low = high = None
    for _ in range(MOST_STEPS):
        if low is not None and high is not None and high / low < GROWTH ** (2.0 ** -(HALVINGS - 5)):
            break
        moved = with_factor(t, points, factor, weights)
        if max(abs(a - b) for a, b in zip(points, moved)) <= tolerance:
            best, low = moved, factor
        else:
            high = factor
        factor = (low * high) ** 0.5 if low and high else factor * GROWTH if low else factor / GROWTH
    return best


def with_factor(t, z, factor, weights):
    """The values at t of the smoothing spline of the values z; `weights`: how far points may move, relatively. Solves
    (R + factor Q' W Q) g = Q' z for the second derivatives g at the inner points (Q: second differences; R: the mass matrix
    of hat functions), a symmetric band matrix; the values are z - factor W Q g."""
    h = [b - a for a, b in zip(t, t[1:])]
    n = len(z) - 2
    q = [(1 / h[i], -1 / h[i] - 1 / h[i + 1], 1 / h[i + 1]) for i in range(n)]  # of the points i, i + 1, i + 2
    middle = [(h[i] + h[i + 1]) / 3 + factor * sum(weights[i + k] * q[i][k] ** 2 for k in range(3)) for i in range(n)]
    near = [h[i + 1] / 6 + factor * sum(weights[i + k] * q[i][k] * q[i + 1][k - 1] for k in (1, 2)) for i in range(n - 1)]
    far = [factor * weights[i + 2] * q[i][2] * q[i + 2][0] for i in range(n - 2)]
    g = solve_band(middle, near, far, [sum(a * b for a, b in zip(q[i], z[i : i + 3])) for i in range(n)])
    moved = list(z)
    for i in range(n):
        for k in range(3):
            moved[i + k] -= factor * weights[i + k] * q[i][k] * g[i]
    return moved


def solve_band(middle, near, far, right):
    """Solves a symmetric positive system with the diagonals a[i, i], a[i, i + 1] and a[i, i + 2] by its factors L D L'."""
    n, d, one, two, x = len(middle), list(middle), list(near), list(far), list(right)
    for i in range(n):
        if i + 1 < n:
            first = one[i]
            one[i] = first / d[i]
            d[i + 1] -= one[i] * first
            x[i + 1] -= one[i] * x[i]
            if i + 2 < n:
                second = two[i]
                two[i] = second / d[i]
                one[i + 1] -= two[i] * first
                d[i + 2] -= two[i] * second
                x[i + 2] -= two[i] * x[i]
    for i in range(n - 1, -1, -1):
        x[i] /= d[i]
        if i + 1 < n:
            x[i] -= one[i] * x[i + 1]
        if i + 2 < n:
            x[i] -= two[i] * x[i + 2]
    return x
