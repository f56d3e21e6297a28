"""A tree of boxes around segments in their order along polygons: which meet, and which a ray crosses. Building it costs
O(n), a question about O(log n) for polygons that do not fill the plane."""


class BoxTree:
    def __init__(self, segments):
        """`segments`: pairs (a, b), neighbours along a polygon one after another."""
        level = [(*sorted((a.real, b.real)), *sorted((a.imag, b.imag))) for a, b in segments]
        self.levels = [level]  # of boxes: least and greatest x, least and greatest y
        while len(level) > 1:
            level = [united(*level[i : i + 2]) for i in range(0, len(level), 2)]
            self.levels.append(level)

    def children(self, depth, i):
        return [k for k in (2 * i, 2 * i + 1) if k < len(self.levels[depth - 1])]

    def near_pairs(self, distance):
        """The pairs i < k of different segments whose boxes are at most this distance apart."""
        top = len(self.levels) - 1
        stack = [(top, 0, 0)] if self.levels[0] else []
        while stack:
            depth, i, k = stack.pop()
            if i != k and not are_near(self.levels[depth][i], self.levels[depth][k], distance):
                continue
            if depth == 0:
                if i != k:
                    yield i, k
                continue
            lower, upper = self.children(depth, i), self.children(depth, k)
            stack += [(depth - 1, a, b) for a in lower for b in upper if i != k or a <= b]

    def right_of(self, z):
        """The segments at the height of z that reach to its right."""
        stack = [(len(self.levels) - 1, 0)] if self.levels[0] else []
        while stack:
            depth, i = stack.pop()
            _, right, low, high = self.levels[depth][i]
            if right < z.real or not low <= z.imag <= high:
                continue
            if depth == 0:
                yield i
            else:
                stack += [(depth - 1, k) for k in self.children(depth, i)]


def united(one, other=None):
    if other is None:
        return one
    return min(one[0], other[0]), max(one[1], other[1]), min(one[2], other[2]), max(one[3], other[3])


def are_near(one, other, distance):
    return (one[0] <= other[1] + distance and other[0] <= one[1] + distance and one[2] <= other[3] + distance
            and other[2] <= one[3] + distance)
