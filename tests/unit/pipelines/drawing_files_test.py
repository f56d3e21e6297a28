import pathlib
import tempfile
import unittest

import command_frame as frame
from drawing import drawing_files
from drawing_samples import dxf


class DrawingFilesTest(unittest.TestCase):
    def read(self, data):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "x"
            path.write_bytes(data)
            return drawing_files.read_drawing(str(path), None, lambda layer: True)

    def test_the_content_shows_the_format(self):
        svg = b'<svg xmlns="http://www.w3.org/2000/svg"><line x2="1"/></svg>'
        for data in (svg, b"\xef\xbb\xbf\n" + svg, b"<?xml version='1.0'?>" + svg, dxf("LINE 8=a 10=0 20=0 11=1 21=0")):
            self.assertEqual(len(self.read(data).entities), 1)

    def test_what_is_no_drawing(self):
        for data, message in ((b" \n", "is empty"), (b"ISO-10303-21;", "is a CAD file"), (b"AC1018", "is a DWG file")):
            with self.assertRaisesRegex(frame.Failure, message):
                self.read(data)
        with self.assertRaisesRegex(frame.Failure, "cannot be read"):
            drawing_files.read_drawing("/nowhere/x.dxf", None, None)


if __name__ == "__main__":
    unittest.main()
