import unittest

from drawing import sketch


class SketchTest(unittest.TestCase):
    def test_names(self):
        self.assertEqual(sketch.Sketch("folder/plate.v2.dxf").title, "plate.v2")
        self.assertEqual(sketch.Sketch("standard input").title, "drawing")
        fault = sketch.Sketch("x.dxf").fault("is bad")
        self.assertEqual((fault.code, str(fault)), (3, "x.dxf: is bad"))

    def test_places_and_lists(self):
        self.assertEqual((sketch.place(0.1 + 2j), sketch.place(complex(-0.0, -0.0))), ("(0.1, 2)", "(0, 0)"))
        self.assertEqual(sketch.listed(["a", "b"]), "a, b")
        self.assertEqual(sketch.listed(list("abcdefg")), "a, b, c, d, e and 2 more")


if __name__ == "__main__":
    unittest.main()
