"""Reads the curves of a DXF file, seen from above, by ezdxf."""
import io
import math
from collections import Counter

from command_frame import NO_RESULT, Failure
from drawing import curves
from drawing.curves import Affine, Segment, Spline
from drawing.sketch import DEFAULT_UNIT, Entity, Sketch, counts_in_words, listed

# $INSUNITS: a unit of STEP files, and how many of it.
DXF_UNITS = {1: ("in", 1), 2: ("ft", 1), 3: ("ft", 5280), 4: ("mm", 1), 5: ("cm", 1), 6: ("m", 1), 7: ("m", 1000),
             8: ("in", 1e-6), 9: ("in", 1e-3), 10: ("ft", 3), 11: ("um", 1e-4), 12: ("um", 1e-3), 13: ("um", 1),
             14: ("cm", 10), 15: ("m", 10), 16: ("m", 100)}
# Entities without a curve that could bound a face.
ANNOTATIONS = {"ACAD_TABLE", "ARC_DIMENSION", "ATTDEF", "ATTRIB", "DIMENSION", "GEODATA", "HATCH", "IMAGE", "LEADER",
               "LIGHT", "MPOLYGON", "MTEXT", "MULTILEADER", "OLE2FRAME", "OLEFRAME", "PDFUNDERLAY", "POINT", "RAY",
               "SHAPE", "SOLID", "TEXT", "TOLERANCE", "TRACE", "VIEWPORT", "WIPEOUT", "XLINE"}
# What ezdxf throws at damaged files, beside errors of its own.
DAMAGE = (ValueError, LookupError, AttributeError, TypeError, ArithmeticError)
MOST_COPIES = 100000
LEAST_HEIGHT = 1e-9  # of the greatest coordinate: curves that differ less lie in one plane


def flat(point):
    return complex(point[0], point[1])


def ocs_map(entity):
    """Of the entity's own coordinates: with a normal that points down, x runs to the left. None: it is tilted."""
    x, y, z = entity.dxf.get("extrusion", (0, 0, 1))
    if math.hypot(x, y) > 1e-9 * abs(z):
        return None
    return Affine() if z > 0 else Affine(0, -1)


# ---- curves of the kinds of entities, in their own coordinates, with the heights of their points


def line(entity):
    a, b = entity.dxf.start, entity.dxf.end
    return [Segment(flat(a), flat(b))], [a[2], b[2]]


def circle(entity):
    centre = entity.dxf.center
    return [curves.circle(flat(centre), entity.dxf.radius)], [centre[2]]


def arc(entity):
    centre, first = entity.dxf.center, math.radians(entity.dxf.start_angle)
    angle = math.radians((entity.dxf.end_angle - entity.dxf.start_angle) % 360) or 2 * math.pi
    return [curves.circle(flat(centre), entity.dxf.radius, first, first + angle)], [centre[2]]


def ellipse(entity):
    """Its coordinates are those of the drawing; its normal says to which side the minor axis points."""
    major, down = flat(entity.dxf.major_axis), entity.dxf.get("extrusion", (0, 0, 1))[2] < 0
    minor = (-1j if down else 1j) * major * entity.dxf.ratio
    first, last = entity.dxf.start_param, entity.dxf.end_param
    angle = (last - first) % (2 * math.pi)
    angle = 2 * math.pi if angle < 1e-12 or angle > 2 * math.pi - 1e-12 else angle
    return [curves.ellipse(flat(entity.dxf.center), major, minor, first, first + angle)], [entity.dxf.center[2]]


def polygon(points, bulges, is_closed):
    """Along the points, with a bulge behind each; equal points are one."""
    pairs = list(zip(points, bulges))
    ends = points[1:] + points[:1] if is_closed else points[1:]
    return [curves.bulged(a, b, bulge) for (a, bulge), b in zip(pairs, ends) if a != b]


def lwpolyline(entity):
    found = entity.get_points("xyb")
    points, bulges = [complex(x, y) for x, y, _ in found], [bulge for _, _, bulge in found]
    return polygon(points, bulges, entity.closed), [entity.dxf.elevation]


def polyline(entity):
    """Points of the frame of a fitted spline (flag 16) are not on it."""
    vertices = [vertex for vertex in entity.vertices if not vertex.dxf.flags & 16]
    points = [vertex.dxf.location for vertex in vertices]
    bulges = [0.0 if entity.is_3d_polyline else vertex.dxf.get("bulge", 0.0) for vertex in vertices]
    heights = [z[2] for z in points] if entity.is_3d_polyline else [entity.dxf.get("elevation", (0, 0, 0))[2]]
    return polygon([flat(z) for z in points], bulges, entity.is_closed), heights


def spline(entity):
    """By its poles, or as AutoCAD draws it through points."""
    degree, poles = entity.dxf.degree, list(entity.control_points)
    knots, weights = list(entity.knots), list(entity.weights)
    if not poles:
        from ezdxf.math import fit_points_to_cad_cv  # pylint: disable=import-outside-toplevel
        fitted = fit_points_to_cad_cv(list(entity.fit_points))
        degree, poles, knots, weights = fitted.degree, fitted.control_points, fitted.knots(), []
    weights = [] if len(set(weights)) < 2 else weights
    count = len(poles)
    if (degree < 1 or len(knots) != count + degree + 1 or len(weights) not in (0, count)
            or min(weights, default=1) <= 0 or any(a > b for a, b in zip(knots, knots[1:]))
            or not knots[degree] < knots[count]):
        raise ValueError("its degree, knots, poles and weights do not fit each other")
    heights = [z[2] for z in poles]
    whole = Spline(degree, tuple(map(float, knots)), tuple(map(flat, poles)), tuple(map(float, weights)))
    return curves.smooth_parts(whole), heights


IN_OWN_COORDINATES = {"CIRCLE": circle, "ARC": arc, "LWPOLYLINE": lwpolyline, "POLYLINE": polyline}
IN_COORDINATES_OF_DRAWING = {"LINE": line, "ELLIPSE": ellipse, "SPLINE": spline, "HELIX": spline}
READERS = IN_OWN_COORDINATES | IN_COORDINATES_OF_DRAWING


class DxfReader:
    """Collects the curves of a drawing whose layers are wanted."""

    def __init__(self, sketch, document, wants):
        self.sketch, self.document, self.wants = sketch, document, wants
        self.left_out, self.unread, self.hidden, self.heights = Counter(), Counter(), set(), set()

    def layer_of(self, entity, outer):
        """Entities of layer 0 in a block are in the layer of the INSERT. Written as in the table of layers."""
        name = entity.dxf.get("layer", "0") if entity.is_supported_dxf_attrib("layer") else "0"
        if name == "0" and outer is not None:
            return outer
        return self.document.layers.get(name).dxf.name if name in self.document.layers else name

    def is_hidden(self, entity, layer):
        if layer in self.document.layers:
            found = self.document.layers.get(layer)
            if found.is_off() or found.is_frozen():
                self.hidden.add(layer)
                return True
        is_known = entity.is_supported_dxf_attrib("invisible")
        return layer == "Defpoints" or is_known and entity.dxf.get("invisible", 0) == 1

    def add_all(self, entities, affine=Affine(), outer=None, blocks=()):
        """`affine`: to the coordinates of the drawing; `outer`: the layer of the INSERT; `blocks`: around them."""
        for entity in entities:
            layer = self.layer_of(entity, outer)
            if self.is_hidden(entity, layer):
                continue
            if entity.dxftype() == "INSERT":
                self.add_block(entity, affine, layer, blocks)
            elif entity.dxftype() in ANNOTATIONS:
                self.left_out[entity.dxftype()] += 1
            elif self.wants(layer):
                self.add_curves(entity, affine, layer, blocks)

    def label(self, entity, layer, blocks):
        where = f", block {blocks[-1]}" if blocks else ""
        return f"{entity.dxftype()} {entity.dxf.get('handle') or ''} (layer {layer}{where})".replace("  ", " ")

    def own_map(self, entity, label):
        found = ocs_map(entity)
        if found is None:
            raise self.sketch.fault(f"{label} is tilted: its normal is not the z axis; draw it in the plane, or leave "
                                    "out its layer (--drawing-layers)")
        return found

    def add_curves(self, entity, affine, layer, blocks):
        kind, label = entity.dxftype(), self.label(entity, layer, blocks)
        is_mesh = kind == "POLYLINE" and (entity.is_polygon_mesh or entity.is_poly_face_mesh)
        if kind not in READERS or is_mesh:
            self.unread[kind] += 1
            return
        if kind in IN_OWN_COORDINATES and not (kind == "POLYLINE" and entity.is_3d_polyline):
            affine = affine.after(self.own_map(entity, label))
        elif kind == "ELLIPSE":
            self.own_map(entity, label)
        try:
            found, heights = READERS[kind](entity)
        except (ValueError, ZeroDivisionError, IndexError) as error:
            raise self.sketch.fault(f"{label} is damaged: {error}") from None
        self.heights.update(heights)
        name = "" if layer == "0" else layer
        self.sketch.entities += [Entity(curve.mapped(affine), layer, name, label) for curve in found]

    def add_block(self, entity, affine, layer, blocks):
        name, label = entity.dxf.get("name", ""), self.label(entity, layer, blocks)
        block = entity.block()
        if block is None:
            raise self.sketch.fault(f"{label} inserts the block {name}, which the file does not define")
        if name in blocks:
            raise self.sketch.fault(f"{label} inserts the block {name} into itself")
        self.own_map(entity, label)
        if entity.mcount > MOST_COPIES:
            raise self.sketch.fault(f"{label} inserts the block {name} more than {MOST_COPIES} times")
        for insert in entity.multi_insert() if entity.mcount > 1 else [entity]:
            m = insert.matrix44()
            (xx, yx, _), (xy, yy, _), (x, y, z) = m.get_row(0)[:3], m.get_row(1)[:3], m.get_row(3)[:3]
            self.heights.add(z)
            self.add_all(block, affine.after(curves.affine_of(xx, xy, yx, yy, x, y)), layer, (*blocks, name))

    def add_notes(self):
        if self.hidden:
            self.sketch.notes.append(f"layers that are off or frozen are left out: {listed(sorted(self.hidden))}")
        if self.left_out:
            self.sketch.notes.append(f"left out: {counts_in_words(self.left_out)}")
        if self.unread:
            self.sketch.warnings.append(("W-DRW-004", f"what is not read is left out: {counts_in_words(self.unread)}; "
                                         "explode it into lines, arcs and polylines if it bounds the face"))
        low, high = min(self.heights, default=0.0), max(self.heights, default=0.0)
        if high - low > LEAST_HEIGHT * max((abs(e.curve.start) for e in self.sketch.entities), default=0.0):
            self.sketch.warnings.append(("W-DRW-005", f"curves lie at heights from z = {low:.6g} to {high:.6g}: they "
                                         "are taken as seen from above"))


def with_version(text):
    """With that of DXF 2000 where the file has its entities and states an older one or none: ezdxf would drop flags."""
    if "AcDb" not in text or "$ACADVER" in text and "AC1009" not in text:
        return text
    if "$ACADVER" in text:
        return text.replace("AC1009", "AC1015", 1)
    return "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n0\nENDSEC\n" + text


def load(sketch, data):
    """The document of ezdxf. Importing that takes longer than all the rest of a small drawing."""
    if data[:2] == b"AC" and data[2:6].isdigit():
        raise sketch.fault("is a DWG file: save it as DXF")
    try:
        import ezdxf  # pylint: disable=import-outside-toplevel
        from ezdxf import recover  # pylint: disable=import-outside-toplevel
    except ImportError:
        raise Failure(NO_RESULT, "DXF files need python3-ezdxf: apt-get install python3-ezdxf") from None
    try:
        if data.startswith(b"AutoCAD Binary DXF"):
            return ezdxf.document.Drawing.load(ezdxf.lldxf.tagger.binary_tags_loader(data, errors="surrogateescape"))
        text = data.decode("utf-8", "ignore").replace("\r\n", "\n")
        info = ezdxf.filemanagement.dxf_stream_info(io.StringIO(text))
        text = data.decode(info.encoding, "surrogateescape").replace("\r\n", "\n")
        return ezdxf.read(io.StringIO(with_version(text)))
    except (ezdxf.DXFError, OSError, *DAMAGE):
        pass
    try:
        sketch.notes.append("the file is damaged: ezdxf recovered what it could")
        return recover.read(io.BytesIO(data))[0]
    except Exception as error:  # pylint: disable=broad-exception-caught  # whatever a damaged file does to ezdxf
        raise sketch.fault(f"is no DXF file that ezdxf can read: {error}") from None


def read_dxf(name, data, unit, wants):
    """`data`: the bytes; `unit`: in place of that of the drawing, or None; `wants(layer)`: whether curves are read."""
    sketch = Sketch(name)
    document = load(sketch, data)
    from ezdxf import DXFError  # pylint: disable=import-outside-toplevel
    reader = DxfReader(sketch, document, wants)
    try:
        reader.add_all(document.modelspace())
    except (DXFError, *DAMAGE) as error:
        raise sketch.fault(f"is damaged: {error}") from None
    reader.add_notes()
    code = document.header.get("$INSUNITS", 0) if b"$INSUNITS" in data else 0  # ezdxf has a default of its own
    if unit is None and code and code not in DXF_UNITS:
        raise sketch.fault(f"its unit ($INSUNITS {code}) is none of those that STEP files have: give --drawing-unit")
    if unit is None and not code:
        sketch.notes.append(f"the drawing states no unit: its numbers are taken as {DEFAULT_UNIT} (--drawing-unit)")
    sketch.unit, factor = (unit or DEFAULT_UNIT, 1) if unit or not code else DXF_UNITS[code]
    if factor != 1:
        sketch.entities = [Entity(e.curve.mapped(Affine(factor)), e.layer, e.name, e.label) for e in sketch.entities]
    return sketch
