import unittest

from node_search.symmetries import Marks, isometries, orbits

SQUARE = [("corner", z) for z in (1 + 1j, -1 + 1j, -1 - 1j, 1 - 1j)]


class SymmetriesTest(unittest.TestCase):
    def test_a_square_has_eight_isometries_and_a_rectangle_four(self):
        self.assertEqual(len(isometries(Marks(SQUARE, 2))), 8)
        self.assertEqual(len(isometries(Marks([(kind, complex(2 * z.real, z.imag)) for kind, z in SQUARE], 4))), 4)

    def test_kinds_count(self):
        marked = [("other", SQUARE[0][1])] + SQUARE[1:]
        self.assertEqual(len(isometries(Marks(marked, 2))), 2)

    def test_nodes_in_the_centre_have_the_identity_alone(self):
        (identity,) = isometries(Marks([("node", 3 + 1j)], 1))
        self.assertEqual(identity(2j), 2j)

    def test_nodes_that_are_mapped_onto_each_other_move_together(self):
        positions = [0.5 + 0j, -0.5 + 0j, 0.1j, -0.1j]
        marks = Marks(SQUARE + [("a", positions[0]), ("a", positions[1]), ("b", positions[2]), ("b", positions[3])], 2)
        first, second = orbits(positions, marks)
        self.assertEqual((first.first, sorted(first.maps)), (0, [0, 1]))
        self.assertEqual((second.first, sorted(second.maps)), (2, [2, 3]))
        moves = first.moves(0.1)
        self.assertAlmostEqual(moves[0], 0.1, 14)
        self.assertAlmostEqual(moves[1], -0.1, 14)

    def test_a_node_on_an_axis_stays_on_it(self):
        positions = [0.5 + 0j, -0.5 + 0j]
        orbit = orbits(positions, Marks(SQUARE + [("a", z) for z in positions], 2))[0]
        self.assertAlmostEqual(orbit.symmetric_part(0.3 + 0.4j), 0.3, 14)

    def test_without_symmetry_each_node_moves_by_itself(self):
        positions = [0.3 + 0.1j, 0.2 - 0.5j]
        found = orbits(positions, Marks(SQUARE + [("a", z) for z in positions], 2))
        self.assertEqual([sorted(orbit.maps) for orbit in found], [[0], [1]])
        self.assertAlmostEqual(found[0].symmetric_part(0.3 + 0.4j), 0.3 + 0.4j, 14)
