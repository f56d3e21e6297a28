import cmath
import math
import unittest

from outline import aerofoils
from outline.loops import Loop
from outline_samples import selig, side


def recognised(points):
    points = list(points)
    if points[0] == points[-1]:
        points.pop()
    return aerofoils.recognise(Loop(points, list(range(1, len(points) + 1))))


class RecogniseTest(unittest.TestCase):
    def test_it_begins_at_a_sharp_or_blunt_trailing_edge_at_any_angle(self):
        for turn in (1, cmath.rect(3, 0.4), cmath.rect(1, -0.3)):
            shape = recognised(turn * z for z in selig(20))
            self.assertEqual((shape.loop.lines[0], shape.base, shape.nose), (1, None, 20))
            shape = recognised(turn * z for z in selig(20, gap=0.01))
            self.assertEqual((shape.loop.lines[0], shape.base, shape.nose), (1, 40, 20))

    def test_it_may_start_at_the_nose_or_in_the_middle_of_its_trailing_edge(self):
        wing = selig(20)[:-1]
        shape = recognised(wing[20:] + wing[:20])
        self.assertEqual((shape.loop.points[0], shape.nose, shape.base), (1, 20, None))
        shape = recognised([1 + 0j] + selig(20, gap=0.02))
        self.assertEqual((shape.loop.points[0], shape.base), (1 + 0.02j, 40))
        self.assertIsNone(recognised(wing[8:] + wing[:8]))

    def test_where_both_ends_are_sharp_the_nose_is_on_the_left(self):
        lens = [complex(1 - k / 10, 0.1 * math.sin(math.pi * k / 10)) for k in range(11)]
        lens += [z.conjugate() for z in lens[-2:0:-1]]
        for start in (0, 10):
            shape = recognised(lens[start:] + lens[:start])
            self.assertEqual((abs(shape.loop.points[0] - 1) < 1e-9, shape.nose), (True, 10))

    def test_other_shapes_are_none(self):
        circle = [cmath.rect(1, math.pi * k / 12) for k in range(24)]
        ellipse = [complex(z.real, 0.1 * z.imag) for z in circle]
        few = [complex(math.cos(math.pi * k / 6), 0.08 * math.sin(math.pi * k / 6)) for k in range(12)]
        plate = [k / 8 for k in range(9)] + [1 + 0.1j - k / 8 for k in range(9)]
        house = [0, 4, 4 + 3j, 2 + 4.5j, 3j]
        thick = [complex(z.real, 8 * z.imag) for z in selig(20)[:-1]]
        bluff = [complex(1 - k / 6, 0.1) for k in range(6)] + [0.1j - 0.05, -0.1, -0.1j - 0.05]
        bluff += [complex(k / 6, -0.1) for k in range(1, 7)]
        for shape in (circle, ellipse, few, plate, house, thick, bluff):
            self.assertIsNone(recognised(shape))


class CrossingTest(unittest.TestCase):
    def test_sides_that_cross_by_rounding_end_at_their_middle(self):
        upper = side(30)
        wing = upper + [z.conjugate() for z in upper[-2::-1]]
        for k in (0, 1):
            wing[k] -= 2e-4j
            wing[-1 - k] += 2e-4j
        wing[2] = wing[2].real + 5e-4j
        wing[-3] = wing[2].conjugate()
        found, overlap = aerofoils.without_crossing(Loop(wing, list(range(61))), 5e-5)
        self.assertEqual((found.points[0], found.points[1], found.points[-1]), (1, wing[2], wing[-3]))
        self.assertAlmostEqual(overlap, 4e-4, 5)
        self.assertEqual(len(found.points), len(found.lines))
        same, overlap = aerofoils.without_crossing(Loop(selig(20), list(range(41))), 5e-5)
        self.assertEqual((same.points, overlap), (selig(20), 0))

    def test_halves_are_joined_with_or_without_a_common_nose(self):
        joined = aerofoils.halves_joined(Loop([0, 1j, 2], [3, 4, 5]), Loop([0, -1j, 2], [7, 8, 9]))
        self.assertEqual((joined.points, joined.lines), ([2, 1j, 0, -1j, 2], [5, 4, 3, 8, 9]))
        joined = aerofoils.halves_joined(Loop([0.1j, 2], [3, 4]), Loop([-0.1j, 2], [7, 8]))
        self.assertEqual(joined.points, [2, 0.1j, -0.1j, 2])
        first, second = aerofoils.divided_at_jump(Loop([0, 1, 2, 0.1, 1], [1, 2, 3, 4, 5]))
        self.assertEqual((first.lines, second.lines), ([1, 2, 3], [4, 5]))


if __name__ == "__main__":
    unittest.main()
