import unittest

from outline.fit import Fit


class FitTest(unittest.TestCase):
    def test_the_greatest_distances_are_told_in_the_units_of_the_points(self):
        fit = Fit(factor=2.0)
        self.assertEqual(fit.sentences(), [])
        fit.add_moves([2, 4], [2 + 0.1j, 4 + 0.4j])
        fit.add_curve([0, 2, 4 + 1j, 6 + 1j], False)
        moves, curves = fit.sentences()
        self.assertEqual(moves, "points were moved by up to 0.2, at (2, 0)")
        self.assertRegex(curves, r"^the curves are up to 0\.\d+ away from the polygon \(\d.* % of the spacing there\), near \(")


if __name__ == "__main__":
    unittest.main()
