"""STEP files (AP214, one planar face in z = 0, millimetres) as text, for make_shapes.py here and tests/stress.

A loop is a list of edges, the outline counter-clockwise and holes clockwise:
  ("line", a, b)                          points are complex numbers
  ("arc", centre, radius, a, b, angles)   from a to b; angles: +1 counter-clockwise, -1 clockwise
  ("circle", centre, radius, angles)      whole
  ("ellipse", centre, a, b, angles)       whole, with the half axes a > b in x and y
  ("spline", poles, knots)                cubic, clamped; knots with repetition
and may end with a word that becomes its name.
"""
import cmath
import math

HEAD = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('{name}','2000-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));
ENDSEC;
DATA;
"""
TAIL = """ENDSEC;
END-ISO-10303-21;
"""


def real(x):
    text = repr(float(x) + 0.0)
    if "e" in text:
        mantissa, exponent = text.split("e")
        return mantissa + ("" if "." in mantissa else ".") + "E" + exponent
    return text


class Step:
    """Statements of a STEP file, each numbered when it is added. `frame`: origin and axes of the plane in space, three
    triples; without it the plane is z = 0."""

    def __init__(self, frame=None):
        self.frame = frame
        self.lines = []
        self.points = {}
        self.vertices = {}
        self.curves, self.edges = [], []  # numbers in the file, in the sequence of the loops

    def add(self, text):
        self.lines.append(text)
        return f"#{len(self.lines)}"

    def point(self, z):
        key = (z.real + 0.0, z.imag + 0.0)
        if key not in self.points:
            place = f"{real(z.real)},{real(z.imag)},0."
            if self.frame:
                place = ",".join(real(o + z.real * x + z.imag * y) for o, x, y in zip(*self.frame))
            self.points[key] = self.add(f"CARTESIAN_POINT('',({place}))")
        return self.points[key]

    def vertex(self, z):
        """One for each place: ends of edges that differ by round-off are the same."""
        for known, vertex in self.vertices.items():
            if abs(known - z) < 1e-9:
                return vertex
        self.vertices[z] = self.add(f"VERTEX_POINT('',{self.point(z)})")
        return self.vertices[z]

    def direction(self, x, y, z):
        if self.frame:
            _, (a, b, c), (d, e, f) = self.frame
            x, y, z = (x * i + y * j + z * k for i, j, k in
                       zip((a, b, c), (d, e, f), (b * f - c * e, c * d - a * f, a * e - b * d)))
        return self.add(f"DIRECTION('',({real(x)},{real(y)},{real(z)}))")

    def placement(self, centre):
        axes = self.direction(0, 0, 1), self.direction(1, 0, 0)
        return self.add(f"AXIS2_PLACEMENT_3D('',{self.point(centre)},{axes[0]},{axes[1]})")

    def origin(self):
        """The placement of the whole: a frame that is not that of space would move the shape."""
        if not self.frame:
            return self.placement(0j)
        point, z, x = (self.add(f"{kind}('',({numbers}))") for kind, numbers in (
            ("CARTESIAN_POINT", "0.,0.,0."), ("DIRECTION", "0.,0.,1."), ("DIRECTION", "1.,0.,0.")))
        return self.add(f"AXIS2_PLACEMENT_3D('',{point},{z},{x})")

    def edge(self, a, b, curve, same, name=""):
        edge = self.add(f"EDGE_CURVE('{name}',{self.vertex(a)},{self.vertex(b)},{curve},.T.)")
        self.curves.append(curve)
        self.edges.append(edge)
        return self.add(f"ORIENTED_EDGE('',*,*,{edge},{'.T.' if same else '.F.'})")

    def circle(self, centre, radius):
        return self.add(f"CIRCLE('',{self.placement(centre)},{real(radius)})")

    def line_edge(self, a, b, name=""):
        d = (b - a) / abs(b - a)
        vector = self.add(f"VECTOR('',{self.direction(d.real, d.imag, 0)},1.)")
        return self.edge(a, b, self.add(f"LINE('',{self.point(a)},{vector})"), True, name)

    def arc_edge(self, centre, radius, a, b, side, name=""):
        """The edge runs counter-clockwise, the loop perhaps the other way."""
        start, end = (a, b) if side > 0 else (b, a)
        return self.edge(start, end, self.circle(centre, radius), side > 0, name)

    def circle_edge(self, centre, radius, side, name=""):
        return self.edge(centre + radius, centre + radius, self.circle(centre, radius), side > 0, name)

    def ellipse_edge(self, centre, a, b, side, name=""):
        curve = self.add(f"ELLIPSE('',{self.placement(centre)},{real(a)},{real(b)})")
        return self.edge(centre + a, centre + a, curve, side > 0, name)

    def spline_edge(self, poles, knots, name=""):
        values = sorted(set(knots))
        counts = ",".join(str(knots.count(t)) for t in values)
        places = ",".join(self.point(p) for p in poles)
        curve = self.add(f"B_SPLINE_CURVE_WITH_KNOTS('',3,({places}),.UNSPECIFIED.,.F.,.F.,({counts}),"
                         f"({','.join(map(real, values))}),.UNSPECIFIED.)")
        return self.edge(poles[0], poles[-1], curve, True, name)

    def face(self, loops):
        bounds = []
        for k, loop in enumerate(loops):
            edges = ",".join(getattr(self, edge[0] + "_edge")(*edge[1:]) for edge in loop)
            kind = "FACE_OUTER_BOUND" if k == 0 else "FACE_BOUND"
            ring = self.add(f"EDGE_LOOP('',({edges}))")
            bounds.append(self.add(f"{kind}('',{ring},.T.)"))
        plane = self.add(f"PLANE('',{self.placement(0j)})")
        return self.add(f"ADVANCED_FACE('',({','.join(bounds)}),{plane},.T.)")

    def layer(self, name, items):
        self.add(f"PRESENTATION_LAYER_ASSIGNMENT('{name}','',({','.join(items)}))")

    def coloured(self, item, colour, over=None):
        """A styled item; `colour` is (red, green, blue) from 0 to 1 or a word of ISO 10303-46, `over` what it overrides."""
        shade = (f"DRAUGHTING_PRE_DEFINED_COLOUR('{colour}')" if isinstance(colour, str) else
                 f"COLOUR_RGB('',{','.join(map(real, colour))})")
        font = self.add("DRAUGHTING_PRE_DEFINED_CURVE_FONT('continuous')")
        style = self.add(f"CURVE_STYLE('',{font},POSITIVE_LENGTH_MEASURE(0.1),{self.add(shade)})")
        styles = self.add(f"PRESENTATION_STYLE_ASSIGNMENT(({style}))")
        return self.add(f"OVER_RIDING_STYLED_ITEM('',({styles}),{item},{over})" if over else
                        f"STYLED_ITEM('colour',({styles}),{item})")

    def product(self, name, face):
        shell = self.add(f"OPEN_SHELL('',({face}))")
        self.representation(name, "MANIFOLD_SURFACE", self.add(f"SHELL_BASED_SURFACE_MODEL('',({shell}))"))

    def representation(self, name, kind, model):
        length = self.add("( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )")
        angle = self.add("( NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.) )")
        solid = self.add("( NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT() )")
        accuracy = self.add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),{length},"
                            "'distance_accuracy_value','')")
        context = self.add("( GEOMETRIC_REPRESENTATION_CONTEXT(3) "
                           f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({accuracy})) "
                           f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid})) "
                           "REPRESENTATION_CONTEXT('','3D') )")
        shape = self.add(f"{kind}_SHAPE_REPRESENTATION('',({self.origin()},{model}),{context})")
        application = self.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')")
        self.add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})")
        field = self.add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
        product = self.add(f"PRODUCT('{name}','{name}','',({field}))")
        formation = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        stage = self.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
        definition = self.add(f"PRODUCT_DEFINITION('design','',{formation},{stage})")
        whole = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
        self.add(f"SHAPE_DEFINITION_REPRESENTATION({whole},{shape})")

    def text(self, name):
        body = "".join(f"#{k + 1} = {line};\n" for k, line in enumerate(self.lines))
        return HEAD.format(name=name) + body + TAIL


def polygon(corners, radii=None):
    """Straight sides between the corners, rounded with these radii; 0: sharp."""
    corners = [complex(corner) for corner in corners]
    n = len(corners)
    radii = radii or [0] * n
    arcs, before, after = {}, list(corners), list(corners)
    for i, corner in enumerate(corners):
        into = corner - corners[i - 1]
        out = corners[(i + 1) % n] - corner
        into, out = into / abs(into), out / abs(out)
        turn = cmath.phase(out / into)
        if radii[i] == 0:
            continue
        cut, side = radii[i] * math.tan(abs(turn) / 2), math.copysign(1, turn)
        before[i], after[i] = corner - cut * into, corner + cut * out
        arcs[i] = ("arc", before[i] + side * radii[i] * into * 1j, radii[i], before[i], after[i], side)
    loop = []
    for i in range(n):
        if i in arcs:
            loop.append(arcs[i])
        loop.append(("line", after[i], before[(i + 1) % n]))
    return loop


def rectangle(low, high):
    return polygon([low, complex(high.real, low.imag), high, complex(low.real, high.imag)])


def basis(knots, t):
    """The four cubic B-splines that do not vanish at t, and the number of the first."""
    k = max(i for i in range(3, len(knots) - 4) if knots[i] <= t)
    values = [1.0]
    for p in range(1, 4):
        new = [0.0] * (p + 1)
        for j in range(p):
            low, high = knots[k + 1 + j - p], knots[k + 1 + j]
            share = values[j] / (high - low)
            new[j] += (high - t) * share
            new[j + 1] += (t - low) * share
        values = new
    return k - 3, values


def cubic_through(points, parameters, start, end):
    """Poles and knots of the C2 cubic through the points with these end derivatives (The NURBS Book, 9.2.3)."""
    n = len(points) - 1
    knots = [parameters[0]] * 3 + list(parameters) + [parameters[-1]] * 3
    poles = [0j] * (n + 3)
    poles[0], poles[-1] = points[0], points[-1]
    poles[1] = points[0] + (parameters[1] - parameters[0]) / 3 * start
    poles[-2] = points[-1] - (parameters[-1] - parameters[-2]) / 3 * end
    upper, right = {}, {1: poles[1]}
    for i in range(1, n):  # row i has unknowns i, i + 1, i + 2; pole 1 is known
        _, (a, b, c, _) = basis(knots, parameters[i])
        pivot = b - a * upper.get(i, 0)
        upper[i + 1] = c / pivot
        right[i + 1] = (points[i] - a * right[i]) / pivot
    for i in range(n, 1, -1):
        poles[i] = right[i] - upper[i] * poles[i + 1]
    return poles, knots


def step_text(name, loops):
    """The whole file."""
    step = Step()
    step.product(name, step.face(loops))
    return step.text(name)
