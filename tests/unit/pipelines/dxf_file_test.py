import io
import unittest

import command_frame as frame
import ezdxf
from drawing import dxf_file
from drawing.curves import Ellipse, Segment, Spline
from drawing_samples import dxf

LINE = "LINE 5=2A 8=wall 10=0 20=0 11=1 21=0"


def read(*entities, unit="mm", wants=lambda layer: True, **sections):
    return dxf_file.read_dxf("x.dxf", dxf(*entities, **sections), unit, wants)


class DxfFileTest(unittest.TestCase):
    def curve(self, entity, kind):
        found = read(entity).entities
        self.assertEqual([type(entity.curve) for entity in found], [kind])
        return found[0].curve

    def refusal(self, *entities, **sections):
        with self.assertRaises(frame.Failure) as caught:
            read(*entities, **sections)
        self.assertEqual(caught.exception.code, 3)
        return str(caught.exception)

    def test_a_label_has_handle_and_layer(self):
        found = read(LINE).entities[0]
        self.assertEqual((found.label, found.name, found.curve), ("LINE 2A (layer wall)", "wall", Segment(0j, 1 + 0j)))

    def test_arcs_run_from_their_first_angle(self):
        arc = self.curve("ARC 8=a 10=1 20=2 40=2 50=270 51=90", Ellipse)
        for z, place in ((arc.start, 1 + 0j), (arc.at(sum(arc.range) / 2), 3 + 2j), (arc.end, 1 + 4j)):
            self.assertAlmostEqual(z, place)
        self.assertTrue(self.curve("ARC 8=a 10=1 20=2 40=2 50=0 51=360", Ellipse).is_whole)
        mirrored = self.curve("ARC 8=a 10=1 20=2 40=2 50=0 51=90 230=-1 210=0 220=0", Ellipse)
        for z, place in ((mirrored.start, -3 + 2j), (mirrored.end, -1 + 4j)):
            self.assertAlmostEqual(z, place)

    def test_ellipses_whose_normal_points_down_run_clockwise(self):
        words = "ELLIPSE 8=a 100=AcDbEntity 100=AcDbEllipse 10=0 20=0 30=0 11=4 21=0 31=0 40=0.5 41=0 42=1.5707963267948966"
        self.assertAlmostEqual(self.curve(words, Ellipse).end, 2j)
        self.assertAlmostEqual(self.curve(words + " 210=0 220=0 230=-1", Ellipse).end, -2j)

    def test_fitted_polylines_are_read_without_their_frame(self):
        words = "POLYLINE 8=a 66=1 70=4 VERTEX 8=a 10=0 20=0 70=8 VERTEX 8=a 10=1 20=9 70=16 VERTEX 8=a 10=2 20=0 70=8 SEQEND"
        self.assertEqual(self.curve(words, Segment), Segment(0j, 2 + 0j))

    def test_splines_through_points(self):
        words = "SPLINE 8=a 100=AcDbEntity 100=AcDbSpline 70=8 71=3 72=0 73=0 74=3 11=0 21=0 31=0 11=1 21=1 31=0 11=2 21=0 31=0"
        spline = self.curve(words, Spline)
        self.assertAlmostEqual(spline.start, 0)
        self.assertAlmostEqual(min(abs(spline.at(i / 500 * spline.range[1]) - 1 - 1j) for i in range(501)), 0, 2)

    def test_splines_that_fit_nothing_are_refused(self):
        message = self.refusal("SPLINE 5=7 8=a 100=AcDbEntity 100=AcDbSpline 70=8 71=3 72=2 73=2 74=0 40=0 40=1 10=0 20=0 30=0 10=1 20=0 30=0")
        self.assertEqual(message, "x.dxf: SPLINE 7 (layer a) is damaged: its degree, knots, poles and weights do not fit each other")

    def test_layers(self):
        table = "TABLE 2=LAYER 70=2 LAYER 2=Wall 70=0 62=7 6=CONTINUOUS LAYER 2=notes 70=1 62=7 6=CONTINUOUS ENDTAB"
        sketch = read(LINE, "LINE 8=notes 10=0 20=0 11=1 21=1", "LINE 8=0 10=5 20=0 11=1 21=1", "LINE 8=Defpoints 10=0 20=0 11=1 21=1",
                      tables=table)
        self.assertEqual([(entity.layer, entity.name) for entity in sketch.entities], [("Wall", "Wall"), ("0", "")])
        self.assertEqual(sketch.notes, ["layers that are off or frozen are left out: notes"])
        self.assertEqual(len(read(LINE, wants=lambda layer: layer != "wall").entities), 0)

    def test_blocks(self):
        block = "BLOCK 8=0 2=B 70=0 10=0 20=0 LINE 8=0 10=0 20=0 11=1 21=0 LINE 8=own 10=0 20=0 11=0 21=1 ENDBLK 8=0"
        found = read("INSERT 8=outer 2=B 10=5 20=6 41=2 42=-3 50=90", blocks=block).entities
        self.assertEqual([entity.name for entity in found], ["outer", "own"])
        for entity, end in zip(found, (5 + 8j, 8 + 6j)):
            self.assertAlmostEqual(entity.curve.end, end)
        self.assertTrue(found[0].label.endswith("(layer outer, block B)"))
        self.assertIn("inserts the block C, which the file does not define", self.refusal("INSERT 8=a 2=C 10=0 20=0"))
        own = "BLOCK 8=0 2=B 70=0 10=0 20=0 INSERT 8=0 2=B 10=1 20=0 ENDBLK 8=0"
        self.assertIn("inserts the block B into itself", self.refusal("INSERT 8=a 2=B 10=0 20=0", blocks=own))

    def test_units(self):
        sketch = read(LINE, unit=None, header="9=$INSUNITS 70=14")
        self.assertEqual((sketch.unit, sketch.entities[0].curve.end), ("cm", 10))
        self.assertEqual(read(LINE, unit="ft", header="9=$INSUNITS 70=14").unit, "ft")
        self.assertEqual(len(read(LINE, unit=None).notes), 1)

    def test_binary_files_of_all_versions(self):
        for version in ("R12", "R2000", "R2018"):
            document, stream = ezdxf.new(version), io.BytesIO()
            document.modelspace().add_circle((5, 5), 2, dxfattribs={"layer": "w\u00e4nd"})
            document.write(stream, fmt="bin")
            found = dxf_file.read_dxf("x.dxf", stream.getvalue(), "mm", lambda layer: True).entities
            self.assertEqual([entity.name for entity in found], ["w\u00e4nd"])

    def test_versions_that_do_not_fit_the_entities(self):
        closed = "LWPOLYLINE 8=a 100=AcDbEntity 100=AcDbPolyline 90=3 70=1 10=0 20=0 10=1 20=0 10=0 20=1"
        for header in ("", "9=$ACADVER 1=AC1009", "9=$ACADVER 1=AC1015"):
            self.assertEqual(len(read(closed, header=header).entities), 3, header)


if __name__ == "__main__":
    unittest.main()
