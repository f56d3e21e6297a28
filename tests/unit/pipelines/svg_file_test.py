import unittest

import command_frame as frame
from drawing import svg_file


def read(body, root='width="100mm" height="50mm" viewBox="0 0 100 50"', unit=None, wants=lambda layer: True):
    text = f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="{svg_file.INKSCAPE}" {root}>{body}</svg>'
    return svg_file.read_svg("x.svg", text.encode(), unit, wants)


class SvgFileTest(unittest.TestCase):
    def points(self, *arguments, **options):
        return [complex(round(entity.curve.start.real, 9), round(entity.curve.start.imag, 9))
                for entity in read(*arguments, **options).entities]

    def test_shapes(self):
        rectangle = '<rect x="1" y="2" width="3" height="4"/>'
        self.assertEqual(self.points(rectangle), [1 + 48j, 4 + 48j, 4 + 44j, 1 + 44j])
        self.assertEqual(self.points('<polygon points="1,2 3,4 5 6"/>'), [1 + 48j, 3 + 46j, 5 + 44j])
        self.assertEqual(len(self.points('<polyline points="1,2 3,4 5 6"/>')), 2)
        self.assertEqual(self.points('<line x1="1" y1="2" x2="3"/>'), [1 + 48j])
        self.assertEqual(self.points('<circle cx="5" cy="6" r="2"/><ellipse cx="5" cy="6" rx="3" ry="1"/>'), [7 + 44j, 8 + 44j])
        self.assertEqual(len(read('<rect width="9" height="8" rx="2"/>').entities), 8)

    def test_transforms(self):
        line = '<line x1="1" y1="0" x2="2" y2="0" transform="{}"/>'
        for text, place in (("translate(3)", 4), ("translate(3,-4)", 4 + 4j), ("rotate(90)", -1j), ("scale(2 3)", 2),
                            ("rotate(90 1 1)", 2 - 1j), ("matrix(1 2 3 4 5 6)", 6 - 8j), ("skewY(45)", 1 - 1j),
                            ("translate(1) scale(-1,1)", 0)):
            self.assertEqual(self.points(line.format(text))[0], place + 50j, text)
        nested = '<g transform="scale(2)"><g transform="translate(1 1)">{}</g></g>'.format(line.format(""))
        self.assertEqual(self.points(nested)[0], 4 + 48j)

    def test_units(self):
        line = '<line x1="96" y1="0" x2="0" y2="96"/>'
        for root, unit, place in (('width="2in" height="1in" viewBox="0 0 192 96"', "in", 1 + 1j),
                                  ('width="192" height="96"', "mm", 25.4 + 25.4j), ('width="72pt" height="72pt"', "in", 1 + 1j),
                                  ('width="10cm" height="10cm" viewBox="0 0 96 96"', "cm", 10 + 10j),
                                  ('width="96mm" viewBox="0 0 96 48"', "mm", 96 + 48j),
                                  ('viewBox="-4 -4 100 104"', "mm", 100 + 100j), ("", "mm", 96 + 0j)):
            sketch = read(line, root)
            self.assertEqual(sketch.unit, unit, root)
            self.assertAlmostEqual(sketch.entities[0].curve.start, place, 12, root)
        self.assertEqual(len(read(line, "").notes), 1)
        self.assertEqual(self.points(line, 'width="50mm" height="50mm" viewBox="0 0 100 100"', unit="ft"), [96 + 100j])

    def test_view_boxes_keep_their_aspect(self):
        line, root = '<line x1="0" y1="0" x2="1" y2="1"/>', 'width="100mm" height="100mm" viewBox="0 0 10 20" preserveAspectRatio="{}"'
        for aspect, place in (("xMidYMid", 25 + 100j), ("xMinYMin", 0 + 100j), ("none", 0 + 100j), ("xMidYMid slice", 150j),
                              ("xMaxYMid meet", 50 + 100j)):
            self.assertEqual(self.points(line, root.format(aspect)), [place], aspect)

    def test_names(self):
        shape = '<rect width="1" height="1" {}/>'
        for attributes, name in (('id="wall"', "wall"), ('id="rect12"', "outer"), ('id="rect12" class="cls-1 steel"', "steel"),
                                 ('id="wall" inkscape:label="inlet"', "inlet"), ('inkscape:label="Layer 1"', "outer"), ("", "outer")):
            found = read('<g id="outer"><g id="g34">' + shape.format(attributes) + "</g></g>").entities
            self.assertEqual({entity.name for entity in found}, {name}, attributes)
        self.assertEqual([e.name for e in read(shape.format('id="a"') + shape.format('id="b"'), wants=lambda name: name == "b").entities],
                         ["b"] * 4)

    def test_uses_and_what_is_not_drawn(self):
        body = '<defs><rect id="r" width="2" height="2"/></defs><use href="#r" x="3" y="4"/><g display="none"><use href="#r"/></g>'
        self.assertEqual(self.points(body)[0], 3 + 46j)
        self.assertEqual(len(self.points(body)), 4)
        symbol = '<symbol id="s" viewBox="0 0 1 1"><line x1="1" y1="1" x2="0"/></symbol><use href="#s" width="10" height="10"/>'
        self.assertEqual(self.points(symbol), [10 + 40j])
        self.assertEqual(read('<text>a</text><rect width="1" height="1"/>').notes, ["left out: 1 text"])
        inner = '<svg x="10" width="20" height="20" viewBox="0 0 2 2"><line x1="1" y1="1" x2="0"/></svg>'
        self.assertEqual(self.points(inner), [20 + 40j])

    def test_mistakes(self):
        for body, message in (('<path id="p" d="M0 0L"/>', "x.svg: line 1: path 'p': its path data: a number expected at its end"),
                              ("<path d='L0 0'/>", "x.svg: line 1: path of line 1: its path data: it does not begin with M or m"),
                              ('<rect width="2em" height="1"/>', 'x.svg: line 1: rect of line 1: width="2em" is not a length'),
                              ('<rect transform="spin(3)" width="1" height="1"/>', "the transform 'spin(3)' is not known"),
                              ('<use href="#none"/>', "it uses '#none', which is no element of the file"),
                              ('<g id="a"><use href="#a"/></g>', "more than 100 times"), ("<g>", "is not well-formed XML: mismatched tag")):
            with self.assertRaises(frame.Failure) as caught:
                read(body)
            self.assertIn(message, str(caught.exception))
        with self.assertRaisesRegex(frame.Failure, "is XML, but not SVG: its root is html"):
            svg_file.read_svg("x.svg", b"<html/>", None, None)


if __name__ == "__main__":
    unittest.main()
