"""The sample files of tests/formats, whose contents the pages of the formats show."""
import os
import pathlib
import tempfile
import unittest

import numpy as np

import quadrille
from quadrille.face import PeriodicPair

SAMPLES = pathlib.Path(os.environ["ROOT"]) / "tests" / "formats"


def sample(path):
    return quadrille.read(SAMPLES / path)


class FilesTest(unittest.TestCase):
    def test_every_sample_can_be_read_former_versions_too(self):
        files = sorted(SAMPLES.glob("*/passed/*"))
        self.assertGreater(len(files), 15)
        for file in files:
            made = quadrille.read(file)
            self.assertEqual(type(made).__name__.lower(), file.parent.parent.name.replace("_", ""))
            self.assertIsInstance(made.provenance, list)

    def test_bytes_are_read_as_files_are(self):
        path = SAMPLES / "quad_mesh/passed/square.quad.h5"
        np.testing.assert_array_equal(quadrille.read(path.read_bytes()).nodes, quadrille.read(path).nodes)

    def test_other_files_are_refused(self):
        for data, words in ((b"no json", "neither HDF5 nor JSON"), (b'{"format": "mesh"}', "no stage file"), (b"[]", "object"),
                            (b'{"format": "critical-points", "version": [3, 0]}', "reads version 2"),
                            (b'{"format": "critical-points", "version": [1, 2]}', "reads version 2"),
                            (b"[" * 1000000, "nested too deeply"),
                            (b"\x89HDF\r\n\x1a\nnothing", "cannot be read as HDF5")):
            with self.assertRaisesRegex(quadrille.StageFileError, words):
                quadrille.read(data)
        with self.assertRaises(OSError), tempfile.TemporaryDirectory() as folder:
            quadrille.read(pathlib.Path(folder) / "absent")


class HexTest(unittest.TestCase):
    def test_the_layer_has_its_groups_and_motion(self):
        mesh = sample("hex_mesh/passed/square.hex.h5")
        self.assertEqual((mesh.num_elements, mesh.num_layers, mesh.order), (2, 1, 1))
        bottom = mesh.face_groups[4]
        self.assertEqual((bottom["name"], bottom["periodic_with"], bottom["is_interface"]), ("bottom", 5, False))
        np.testing.assert_array_equal(bottom["elems"], [0, 1])
        corners = mesh.nodes[mesh.elem_nodes[1]]
        np.testing.assert_array_equal(corners[:4] @ bottom["motion"][:, :3].T + bottom["motion"][:, 3], corners[4:])
        self.assertEqual([mesh.region_names[r] for r in mesh.elem_region], ["domain", "domain"])


class ChartTest(unittest.TestCase):
    def test_the_cap_is_on_the_unit_sphere(self):
        chart = sample("chart/passed/cap.chart.h5")
        self.assertEqual((chart.num_elements, chart.order), (18, 8))
        np.testing.assert_allclose(np.linalg.norm(chart.space_nodes, axis=2), 1, atol=1e-14)
        np.testing.assert_allclose(chart.log_scale, np.log(2 / (1 + (chart.nodes ** 2).sum(axis=2))), atol=1e-14)
        self.assertIsNone(sample("quad_mesh/passed/square.quad.h5").space_nodes)


class SquareTest(unittest.TestCase):
    def test_mesh(self):
        mesh = sample("tri_mesh/passed/square.tri.h5")
        self.assertEqual((mesh.num_elements, mesh.order), (4, 2))
        elem, xi = mesh.locate([[0.5, 0.25], [0.5, 0.75], [2, 2], [np.nan, 0]])
        np.testing.assert_array_equal(elem, [0, 2, -1, -1])
        np.testing.assert_allclose(mesh.map(elem[:2], xi[:2])[0], [[0.5, 0.25], [0.5, 0.75]])

    def test_points_near_the_boundary_belong_to_the_nearest_element_if_wanted(self):
        mesh = sample("tri_mesh/passed/square.tri.h5")
        self.assertEqual(mesh.locate([[0.5, -1e-4]])[0][0], -1)
        self.assertEqual(mesh.locate([[0.5, -1e-4]], tolerance=1e-3)[0][0], 0)

    def test_field(self):
        field = sample("field/passed/square.field.h5")
        value, gradient = field.sample([[0.3, 0.2], [0.5, 0.5], [1, 1]])
        np.testing.assert_allclose(value, [[1, 0]] * 3, atol=1e-15)
        np.testing.assert_allclose(gradient, 0, atol=1e-14)
        np.testing.assert_allclose(field.cross_directions([[0.3, 0.2]])[0], [[1, 0], [0, 1], [-1, 0], [0, -1]], atol=1e-15)

    def test_phase(self):
        field, x = sample("field/passed/phase.field.h5"), np.array([[0.3, 0.2], [0.6, 0.8]])
        z = x[:, 0] + 1j * x[:, 1]
        phase = np.angle(z - (0.5 + 0.375j)) + np.angle(z - (0.5 - 0.375j)) - 4 * np.angle(z / (z + 1 + 1j))
        value, gradient = field.sample(x)
        np.testing.assert_allclose(value, np.column_stack([np.cos(phase), np.sin(phase)]), atol=1e-14)
        step = 1e-6
        for k in range(2):
            shift = step * np.eye(2)[k]
            difference = (field.value(x + shift) - field.value(x - shift)) / (2 * step)
            np.testing.assert_allclose(gradient[:, :, k], difference, atol=1e-7)
        self.assertTrue(np.isnan(field.value([[0.5, 0.375]])).all())

    def test_regions(self):
        mesh = sample("tri_mesh/passed/regions.tri.h5")
        face = mesh.face
        np.testing.assert_array_equal(mesh.elem_region, [0, 0, 0, 0, 1, 1, 1, 1])
        self.assertEqual((face.regions, face.region_names), ([range(0, 1), range(1, 2)], ["fluid", "solid"]))
        self.assertEqual((face.interfaces(), face.region_of_curve(7)), ([(1, 7)], 1))
        self.assertEqual([pair.curves for pair in face.periodic_pairs], [(0, 2), (4, 6)])
        pair = face.periodic_pairs[1]
        np.testing.assert_allclose(pair.move(face.curves[4].points([0, 0.25])), face.curves[6].points([1, 0.75]))
        np.testing.assert_allclose(sample("field/passed/regions.field.h5").value([[1.5, 0.3]]), [[1, 0]], atol=1e-14)

    def test_one_region_and_slits(self):
        square, slit = sample("tri_mesh/passed/square.tri.h5"), sample("tri_mesh/passed/slit.tri.h5")
        self.assertEqual((square.face.regions, square.face.region_names), ([range(0, 1)], ["square"]))
        np.testing.assert_array_equal(square.elem_region, [0] * 4)
        np.testing.assert_array_equal(square.face.partners, [-1] * 4)
        self.assertEqual((square.face.interfaces(), square.face.periodic_pairs), ([], []))
        self.assertEqual((slit.face.interfaces(), slit.face.regions), ([(4, 5)], [range(0, 2)]))

    def test_regions_of_blocks_and_quads(self):
        layout = sample("block_layout/passed/regions.blocks.h5")
        self.assertEqual(list(layout.block_region), [0, 1])
        mesh = sample("quad_mesh/passed/regions.quad.h5")
        self.assertEqual(list(mesh.elem_region), [0, 1])
        self.assertEqual([list(mesh.interface_edges[key]) for key in ("elem", "side", "curve")], [[0, 1], [1, 3], [1, 7]])
        one = sample("quad_mesh/passed/square.quad.h5")
        self.assertEqual((list(one.elem_region), len(one.interface_edges["elem"])), ([0, 0], 0))
        self.assertEqual(list(sample("block_layout/passed/square.blocks.h5").block_region), [0, 0])

    def test_phases_of_regions_hold_in_their_own(self):
        field, one = sample("field/passed/regions-phase.field.h5"), sample("field/passed/phase.field.h5")
        x = np.array([[0.3, 0.2], [0.6, 0.8]])
        np.testing.assert_allclose(field.value(x), one.value(x), atol=1e-14)
        np.testing.assert_allclose(field.gradient(x), one.gradient(x), atol=1e-13)
        np.testing.assert_allclose(field.value(x + [1, 0]), [[1, 0]] * 2, atol=1e-14)

    def test_periodic_motions_turn_then_move(self):
        np.testing.assert_allclose(PeriodicPair((0, 1), np.pi / 2, np.array([2.0, 0])).move([[1, 0]]), [[2, 1]], atol=1e-15)

    def test_nodes(self):
        nodes = sample("critical_points/passed/resolved.crit.json")
        self.assertEqual([node.valence for node in nodes.nodes], [3, 3])
        self.assertEqual([corner.valence for corner in nodes.corners], [2, 1, 1, 1])
        self.assertEqual([(b.curve, b.t, b.valence) for b in nodes.boundary_nodes], [(1, 0.5, 3)])
        self.assertEqual((nodes.index_sum, nodes.expected_index_sum, len(nodes.zeros)), (4, 4, 3))

    def test_graph(self):
        graph = sample("separatrix_graph/passed/square.sep.json")
        self.assertEqual([graph.nodes[i].kind for i in (0, 4)], ["corner", "boundary"])
        self.assertEqual(graph.arcs[1].names, ["side 0"])
        np.testing.assert_allclose(graph.lines[0].points(3), [[0.5, 0], [0.5, 0.5], [0.5, 1]])
        self.assertAlmostEqual(graph.arcs[6].arc_length, 1)

    def test_blocks(self):
        layout = sample("block_layout/passed/square.blocks.h5")
        left, right = layout.blocks
        self.assertEqual((left.name, left.nodes, left.chords), ("block-0", (0, 4, 5, 3), (0, 2)))
        self.assertEqual(left.boundary_names, [["side 0"], [], ["side 2"], ["side 3"]])
        self.assertEqual(layout.neighbour(left, 1), (right, 3))
        self.assertIsNone(layout.neighbour(left, 0))
        np.testing.assert_allclose(right.map([[-1, -1], [0, 0], [1, 1]]), [[0.5, 0], [0.75, 0.5], [1, 1]])
        self.assertAlmostEqual(right.measure(), 1)

    def test_quads(self):
        mesh = sample("quad_mesh/passed/square.quad.h5")
        self.assertEqual((mesh.num_elements, mesh.order, mesh.elem_names), (2, 1, ["block-0", "block-1"]))
        np.testing.assert_array_equal(mesh.corners, [[0, 1, 4, 3], [1, 2, 5, 4]])
        np.testing.assert_array_equal(mesh.side_nodes(2)[0], [4, 3])
        self.assertEqual(mesh.boundary_names[:3], ["side 0", "side 0", "side 1"])
        x, derivative = mesh.map([1], [[0, 0]])
        np.testing.assert_allclose(x, [[0.75, 0.5]])
        np.testing.assert_allclose(derivative, [[[0.25, 0], [0, 0.5]]])
        np.testing.assert_allclose(mesh.measure_scaled_jacobian(), mesh.elem_scaled_jacobian)


if __name__ == "__main__":
    unittest.main()
