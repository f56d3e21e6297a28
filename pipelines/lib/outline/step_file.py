"""Writes a planar face as a STEP file (ISO 10303-21, AP214). The same edges give the same bytes."""
import hashlib
import json
import math
import re
from dataclasses import dataclass

from outline.edges import Arc, EllipticArc, Line

# SI prefixes of the metre, or name and metres of units of their own.
UNITS = {"m": "$", "cm": ".CENTI.", "mm": ".MILLI.", "um": ".MICRO.", "in": ("INCH", 0.0254), "ft": ("FOOT", 0.3048)}


def real(x):
    mantissa, _, exponent = repr(float(x) + 0.0).partition("e")
    return mantissa + ("" if "." in mantissa else ".") + (f"E{exponent}" if exponent else "")


def text(words):
    """A string; characters other than ASCII by their numbers."""
    coded = []
    for part in re.findall(r"[ -~]+|[^ -~]", words):
        if " " <= part[0] <= "~":
            coded.append(part.replace("\\", "\\\\").replace("'", "''"))
        else:
            coded.append(f"\\X2\\{ord(part):04X}\\X0\\" if ord(part) < 0x10000 else f"\\X4\\{ord(part):08X}\\X0\\")
    return "'" + "".join(coded) + "'"


def listed(items):
    return "(" + ",".join(items) + ")"


@dataclass(frozen=True)
class Reversed:
    """An edge that a loop follows from its end to its start."""

    edge: object


class Statements:
    """The statements of a file; each is numbered when it is added, and referred to as #NUMBER."""

    def __init__(self):
        self.texts, self.vertices, self.edges = [], {}, {}

    def add(self, statement):
        self.texts.append(statement)
        return f"#{len(self.texts)}"

    def vertex(self, z):
        if z not in self.vertices:
            self.vertices[z] = self.add(f"VERTEX_POINT('',{point(self, z)})")
        return self.vertices[z]

    def body(self):
        return "".join(f"#{number} = {statement};\n" for number, statement in enumerate(self.texts, 1))


# ---- geometry


def point(step, z):
    return step.add(f"CARTESIAN_POINT('',({real(z.real)},{real(z.imag)},0.))")


def placement(step, centre, along=1.0 + 0j):
    axis = step.add("DIRECTION('',(0.,0.,1.))")
    reference = step.add(f"DIRECTION('',({real(along.real)},{real(along.imag)},0.))")
    return step.add(f"AXIS2_PLACEMENT_3D('',{point(step, centre)},{axis},{reference})")


def line(step, edge):
    along = (edge.end - edge.start) / abs(edge.end - edge.start)
    direction = step.add(f"DIRECTION('',({real(along.real)},{real(along.imag)},0.))")
    vector = step.add(f"VECTOR('',{direction},1.)")
    return step.add(f"LINE('',{point(step, edge.start)},{vector})")


def circle(step, edge):
    return step.add(f"CIRCLE('',{placement(step, edge.centre)},{real(edge.radius)})")


def ellipse(step, edge):
    where = placement(step, edge.centre, edge.major / abs(edge.major))
    return step.add(f"ELLIPSE('',{where},{real(abs(edge.major))},{real(edge.minor)})")


def spline(step, edge, name):
    ends, inner = [edge.degree + 1], [1] * (len(edge.knots) - 2)
    multiplicities = listed(map(str, edge.multiplicities or ends + inner + ends))
    is_closed = ".T." if edge.start == edge.end else ".F."
    poles = listed([point(step, z) for z in edge.poles])
    form = f"{edge.degree},{poles},.UNSPECIFIED.,{is_closed},.F."
    knots = f"{multiplicities},{listed(map(real, edge.knots))},.UNSPECIFIED."
    if not edge.weights:
        return step.add(f"B_SPLINE_CURVE_WITH_KNOTS({text(name)},{form},{knots})")
    return step.add(f"( BOUNDED_CURVE() B_SPLINE_CURVE({form}) B_SPLINE_CURVE_WITH_KNOTS({knots}) CURVE() "
                    f"GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_CURVE({listed(map(real, edge.weights))}) "
                    f"REPRESENTATION_ITEM({text(name)}) )")


def curve(step, edge, name=""):
    """The geometry of an edge; a spline may have a name of its own."""
    for kind, write in ((Line, line), (Arc, circle), (EllipticArc, ellipse)):
        if isinstance(edge, kind):
            return write(step, edge)
    return spline(step, edge, name)


# ---- topology


def edge_curve(step, edge):
    """Written once for all loops that follow it."""
    if id(edge) not in step.edges:
        geometry = curve(step, edge)
        start, end = step.vertex(edge.start), step.vertex(edge.end)
        step.edges[id(edge)] = step.add(f"EDGE_CURVE({text(edge.name)},{start},{end},{geometry},.T.)")
    return step.edges[id(edge)]


def oriented_edge(step, edge):
    if isinstance(edge, Reversed):
        return step.add(f"ORIENTED_EDGE('',*,*,{edge_curve(step, edge.edge)},.F.)")
    return step.add(f"ORIENTED_EDGE('',*,*,{edge_curve(step, edge)},.T.)")


def bound(step, edges, kind):
    loop = step.add(f"EDGE_LOOP('',{listed([oriented_edge(step, edge) for edge in edges])})")
    return step.add(f"{kind}('',{loop},.T.)")


def face(step, loops, name):
    bounds = [bound(step, edges, "FACE_BOUND" if k else "FACE_OUTER_BOUND") for k, edges in enumerate(loops)]
    plane = step.add(f"PLANE('',{placement(step, 0j)})")
    return step.add(f"ADVANCED_FACE({text(name)},{listed(bounds)},{plane},.T.)")


# ---- units and product


def length_unit(step, unit):
    if isinstance(UNITS[unit], str):
        return step.add(f"( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT({UNITS[unit]},.METRE.) )")
    name, metres = UNITS[unit]
    metre = step.add("( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.) )")
    exponents = step.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)")
    factor = step.add(f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({real(metres)}),{metre})")
    return step.add(f"( CONVERSION_BASED_UNIT('{name}',{factor}) LENGTH_UNIT() NAMED_UNIT({exponents}) )")


def context(step, unit, tolerance):
    length = length_unit(step, unit)
    angle = step.add("( NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.) )")
    solid = step.add("( NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT() )")
    accuracy = step.add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({real(tolerance)}),{length},"
                        "'distance_accuracy_value','')")
    return step.add("( GEOMETRIC_REPRESENTATION_CONTEXT(3) "
                    f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({accuracy})) "
                    f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid})) REPRESENTATION_CONTEXT('','3D') )")


def embedded_curve(step, edge):
    """A curve of its own, with a name and ends."""
    geometry = curve(step, edge, edge.name)
    if not isinstance(edge, (Line, Arc, EllipticArc)) or edge.start == edge.end:
        return geometry
    ends = listed([point(step, edge.start)]), listed([point(step, edge.end)])
    return step.add(f"TRIMMED_CURVE({text(edge.name)},{geometry},{ends[0]},{ends[1]},.T.,.CARTESIAN.)")


def wireframe(step, edges, context_number, whole):
    """Edges inside the face: a shape of the product beside the face."""
    curves = step.add(f"GEOMETRIC_CURVE_SET('',{listed([embedded_curve(step, edge) for edge in edges])})")
    shape = step.add("GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',"
                     f"({placement(step, 0j)},{curves}),{context_number})")
    step.add(f"SHAPE_DEFINITION_REPRESENTATION({whole},{shape})")


def product(step, title, face_numbers, context_number):
    shell = step.add(f"OPEN_SHELL('',{listed(face_numbers)})")
    model = step.add(f"SHELL_BASED_SURFACE_MODEL('',({shell}))")
    shape = step.add(f"MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',({placement(step, 0j)},{model}),{context_number})")
    application = step.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')")
    step.add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})")
    field = step.add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
    item = step.add(f"PRODUCT({text(title)},{text(title)},'',({field}))")
    formation = step.add(f"PRODUCT_DEFINITION_FORMATION('','',{item})")
    stage = step.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
    definition = step.add(f"PRODUCT_DEFINITION('design','',{formation},{stage})")
    whole = step.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
    step.add(f"SHAPE_DEFINITION_REPRESENTATION({whole},{shape})")
    return whole


def made_by(tool, input_format, data, options):
    """How a command made the file of an input, as the provenance of stage files (formats/README.md, "Provenance"), of
    files without a version. `options`: as typed, by their names with --; a flag is None. Only what changes the file is
    recorded."""
    recorded = {name[2:]: True if value is None else value for name, value in sorted(options.items())
                if name.startswith("--") and name not in ("--output", "--verbose", "--quiet")}
    sha256 = hashlib.sha256(data).hexdigest()
    step = {"tool": tool, "version": "", "inputs": [{"format": input_format, "sha256": sha256}],
            "options": recorded}
    return json.dumps({"provenance": [step]})


def description(origin):
    """The strings of FILE_DESCRIPTION; short ones, for any reader."""
    parts = ["Quadrille provenance", *re.findall(".{1,200}", origin)] if origin else [""]
    return "(" + ",\n".join(text(part) for part in parts) + ")"


def step_file(title, faces, unit, size, embedded=(), producer="points2step", origin=""):
    """The text of the file. `faces`: (name, loops) of each, loops of edges or Reversed ones: the outline first and
    counter-clockwise, holes clockwise; `unit` is a key of UNITS; the accuracy is given as a ten millionth of `size`,
    rounded down to a power of ten. `embedded`: edges inside the faces; `origin`: as made_by says it."""
    step = Statements()
    face_numbers = [face(step, loops, name) for name, loops in faces]
    common = context(step, unit, 10.0 ** math.floor(math.log10(1e-7 * size)))
    whole = product(step, title, face_numbers, common)
    if embedded:
        wireframe(step, embedded, common, whole)
    return (f"ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION({description(origin)},'2;1');\n"
            f"FILE_NAME({text(title)},'2000-01-01T00:00:00',(''),(''),{text(producer)},'','');\n"
            "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\n"
            f"DATA;\n{step.body()}ENDSEC;\nEND-ISO-10303-21;\n")
