"""What the module evaluates against what the tools wrote: files of whole chains, CHAINS/SHAPE.*."""
import os
import pathlib
import unittest

import numpy as np

import quadrille

CHAINS = pathlib.Path(os.environ["CHAINS"])
SHAPES = sorted(file.name[:-len(".field.h5")] for file in CHAINS.glob("*.field.h5"))


def stage(shape, ending):
    return quadrille.read(CHAINS / f"{shape}.{ending}")


class ChainTest(unittest.TestCase):
    def each(self, *endings):
        self.assertTrue(SHAPES)
        for shape in SHAPES:
            with self.subTest(shape):
                yield [stage(shape, ending) for ending in endings]

    def test_the_field_is_zero_at_its_zeros_with_the_gradients_that_critpoints_wrote(self):
        for field, points in self.each("field.h5", "crit.json"):
            if not points.nodes:
                continue
            value, gradient = field.sample(points.positions)
            np.testing.assert_allclose(value, 0, atol=1e-11)
            jacobians = np.array([node.jacobian for node in points.nodes])
            np.testing.assert_allclose(gradient, jacobians, rtol=1e-9, atol=1e-9 * abs(jacobians).max())
            elem, xi = field.mesh.locate(points.positions)
            np.testing.assert_array_equal(elem, [node.elem for node in points.nodes])
            np.testing.assert_allclose(xi, [node.xi for node in points.nodes], atol=1e-10)

    def test_the_cross_is_tangential_along_the_boundary(self):
        for fields in self.each("field.h5", "phase.h5"):
            for field, bound in zip(fields, (1e-7, 1e-3)):
                for curve in field.face.curves:
                    points, tangents = curve.sample(np.linspace(curve.start, curve.end, 23)[1:-1])
                    angle = 4 * np.arctan2(tangents[:, 1], tangents[:, 0])
                    data = np.column_stack([np.cos(angle), np.sin(angle)])
                    np.testing.assert_allclose(field.value(points, 1e-6), data, atol=bound)

    def test_the_phase_is_a_unit_field_that_turns_round_its_nodes(self):
        for field, points in self.each("phase.h5", "crit.json"):
            turn = np.linspace(0, 2 * np.pi, 65)
            for node in points.nodes:
                circle = node.position + 0.01 * field.face.diameter * np.column_stack([np.cos(turn), np.sin(turn)])
                value = field.value(circle)
                np.testing.assert_allclose(np.linalg.norm(value, axis=1), 1)
                phase = np.unwrap(np.arctan2(value[:, 1], value[:, 0]))
                self.assertAlmostEqual((phase[-1] - phase[0]) / (2 * np.pi), 4 - node.valence)

    def test_every_point_of_the_quads_is_in_the_mesh_and_edges_are_on_their_curves(self):
        for field, mesh in self.each("field.h5", "quad.h5"):
            centres = mesh.map(np.arange(mesh.num_elements), np.zeros((mesh.num_elements, 2)))[0]
            self.assertTrue((field.mesh.locate(centres)[0] >= 0).all())
            face, edges = mesh.face, mesh.boundary_edges
            for elem, side, curve in list(zip(edges["elem"], edges["side"], edges["curve"]))[::5]:
                spline = face.curves[curve]
                dense = spline.points(np.linspace(spline.start, spline.end, 4001))
                end = mesh.nodes[mesh.side_nodes(side)[elem, 0]]
                self.assertLess(np.linalg.norm(dense - end, axis=1).min(), 1e-3 * face.diameter)

    def test_scaled_jacobians_are_those_of_the_files(self):
        for layout, mesh in self.each("blocks.h5", "quad.h5"):
            np.testing.assert_allclose([block.measure() for block in layout.blocks],
                                       [block.scaled_jacobian for block in layout.blocks], atol=1e-9)
            np.testing.assert_allclose(mesh.measure_scaled_jacobian(), mesh.elem_scaled_jacobian, atol=1e-11)

    def test_lines_lead_from_their_origin_to_their_end_and_blocks_join_their_nodes(self):
        for graph, layout in self.each("sep.json", "blocks.h5"):
            for line in graph.lines:
                points, bound = line.points(3), 1e-9 * graph.face.diameter
                np.testing.assert_allclose(points[0], graph.nodes[line.origin].position, atol=bound)
                np.testing.assert_allclose(points[-1], graph.nodes[line.end].position, atol=bound)
            for block in layout.blocks:
                corners = block.map([[-1, -1], [1, -1], [1, 1], [-1, 1]])
                np.testing.assert_allclose(corners, [layout.nodes[n].position for n in block.nodes], atol=1e-9)

    def test_crosses_follow_the_lines(self):
        for graph, field in self.each("sep.json", "field.h5"):
            for line in graph.lines:
                if line.kind == "traced":
                    self.check_tangents(line, field)

    def check_tangents(self, line, field):
        points = np.concatenate([arc.points(41)[::1 if forwards else -1][4:-4] for arc, forwards in line.arcs[:1]])
        tangent = points[2:] - points[:-2]
        psi = np.arctan2(tangent[:, 1], tangent[:, 0]) - field.cross_angle(points[1:-1])
        self.assertLess(np.abs((psi + np.pi / 4) % (np.pi / 2) - np.pi / 4).max(), np.radians(1))


if __name__ == "__main__":
    unittest.main()
