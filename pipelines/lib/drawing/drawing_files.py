"""Reads a drawing in the format that its content shows."""
from command_frame import BAD_INPUT, Failure, read_bytes
from drawing.dxf_file import read_dxf
from drawing.svg_file import read_svg
from outline.point_files import is_cad_file


def read_drawing(path, unit, wants):
    """The curves of the file, or of standard input for -. `unit`: that of its numbers, or None: as it states; `wants`:
    whether the curves of a layer are read. Throws Failure."""
    data, name = read_bytes(path), "standard input" if path == "-" else path
    if not data.strip():
        raise Failure(BAD_INPUT, f"{name}: is empty")
    if is_cad_file(data):
        raise Failure(BAD_INPUT, f"{name}: is a CAD file, not a drawing: give it to quadmesh without options of "
                                 "drawings")
    is_xml = data.removeprefix(b"\xef\xbb\xbf").lstrip().startswith(b"<")
    sketch = (read_svg if is_xml else read_dxf)(name, data, unit, wants)
    sketch.format, sketch.data = "svg" if is_xml else "dxf", data
    return sketch
