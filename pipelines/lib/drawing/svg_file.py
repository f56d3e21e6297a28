"""Reads the curves of an SVG file: shapes and paths under transforms, in the unit of the page, y upwards."""
import math
import re
from collections import Counter
from xml.parsers import expat

from drawing import curves
from drawing.curves import Affine, Segment, affine_of
from drawing.sketch import DEFAULT_UNIT, Entity, Sketch, counts_in_words
from drawing.svg_path import PathError, path_curves

INCHES = {"in": 1.0, "mm": 1 / 25.4, "cm": 1 / 2.54, "q": 1 / 101.6, "pt": 1 / 72, "pc": 1 / 6, "px": 1 / 96,
          "": 1 / 96}
UNIT_OF_PAGE = {"in": "in", "pt": "in", "pc": "in", "cm": "cm"}  # others: mm
AUTOMATIC = re.compile(r"(path|rect|circle|ellipse|line|polyline|polygon|g|group|svg|use|layer|st|cls)[-_ ]?\d+"
                       r"([-_]\d+)*", re.IGNORECASE)
GROUPS = {"g", "a", "switch", "symbol", "svg"}
NOT_DRAWN = {"defs", "symbol", "clipPath", "mask", "marker", "pattern", "style", "script", "title", "desc", "metadata",
             "linearGradient", "radialGradient", "filter", "view"}
LEFT_OUT = {"text", "image", "foreignObject", "video", "audio", "canvas", "iframe"}
MOST_LEVELS = 100
SVG, INKSCAPE = "http://www.w3.org/2000/svg", "http://www.inkscape.org/namespaces/inkscape"


class Node:
    """An element: its tag without a name space (other name spaces: ""), attributes, line in the file, and children."""

    def __init__(self, tag, attributes, line):
        space, _, local = tag.rpartition(" ")
        self.tag = local if space in (SVG, "") else ""
        self.attributes, self.line, self.children = attributes, line, []

    def get(self, name, default=""):
        return self.attributes.get(name, default)

    @property
    def is_hidden(self):
        style = self.get("style").replace(" ", "")
        return self.get("display") == "none" or "display:none" in style or "visibility:hidden" in style

    @property
    def own_name(self):
        """The label, an id or a class that nobody numbered, or none."""
        words = [self.get(f"{INKSCAPE} label"), self.get("id"), *self.get("class").split()]
        return next((word for word in words if word and not AUTOMATIC.fullmatch(word)), "")

    @property
    def words(self):
        return f"{self.tag} '{self.get('id')}'" if self.get("id") else f"{self.tag} of line {self.line}"


def parsed(sketch, data):
    """The root."""
    parser, stack = expat.ParserCreate(namespace_separator=" "), [Node("", {}, 0)]

    def begin(tag, attributes):
        stack[-1].children.append(Node(tag, attributes, parser.CurrentLineNumber))
        stack.append(stack[-1].children[-1])

    parser.StartElementHandler, parser.EndElementHandler = begin, lambda tag: stack.pop()
    try:
        parser.Parse(data, True)
    except expat.ExpatError as error:
        raise sketch.fault(f"line {error.lineno}: is not well-formed XML: {expat.ErrorString(error.code)}") from None
    except LookupError as error:
        raise sketch.fault(f"line 1: {error}") from None
    root = stack[0].children[0]
    if root.tag != "svg":
        raise sketch.fault(f"is XML, but not SVG: its root is {root.tag or 'of another name space'}")
    return root


# ---- numbers, lengths, transforms


def numbers(text):
    return [float(word) for word in re.findall(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", text)]


def measure(text):
    """(number, unit in small letters) of a length, or None: absent, or of another unit, as %."""
    match = re.fullmatch(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([a-zA-Z]*)\s*", text)
    return (float(match[1]), match[2].lower()) if match and match[2].lower() in INCHES else None


def converted(found, unit):
    value, given = found
    return value if given == unit else value * INCHES[given] / INCHES[unit]


def length(node, name, default=0.0):
    """In user units, which are px."""
    if not node.get(name) or node.get(name) == "auto":
        return default
    found = measure(node.get(name))
    if found is None:
        raise ValueError(f"{name}=\"{node.get(name)}\" is not a length in px, mm, cm, in, pt or pc")
    return found[0] if found[1] in ("", "px") else converted(found, "px")


def rotation(angle, x=0.0, y=0.0):
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return affine_of(c, -s, s, c, x - c * x + s * y, y - s * x - c * y)


TRANSFORMS = {
    "matrix": lambda a, b, c, d, e, f: affine_of(a, c, b, d, e, f),
    "translate": lambda x, y=0.0: affine_of(1, 0, 0, 1, x, y),
    "scale": lambda x, y=None: affine_of(x, 0, 0, x if y is None else y),
    "rotate": rotation,
    "skewX": lambda angle: affine_of(1, math.tan(math.radians(angle)), 0, 1),
    "skewY": lambda angle: affine_of(1, 0, math.tan(math.radians(angle)), 1),
}


def transform(text):
    """Throws ValueError."""
    result = Affine()
    for name, arguments in re.findall(r"([A-Za-z]+)\s*\(([^)]*)\)", text):
        try:
            result = result.after(TRANSFORMS[name](*numbers(arguments)))
        except (KeyError, TypeError):
            raise ValueError(f"the transform '{name}({arguments})' is not known") from None
    if re.sub(r"[A-Za-z]+\s*\([^)]*\)", "", text).strip(" \t\r\n,"):
        raise ValueError(f"the transform '{text}' is not known")
    return result


def view_map(node, width, height):
    """From the view box of an svg to a rectangle (SVG 2, 8.2); its box must be one that can be seen."""
    box = numbers(node.get("viewBox"))
    if len(box) != 4 or min(box[2:]) <= 0:
        return Affine()
    sx, sy = width / box[2], height / box[3]
    aspect = node.get("preserveAspectRatio", "xMidYMid meet")
    if "none" not in aspect:
        sx = sy = max(sx, sy) if "slice" in aspect else min(sx, sy)
    share = lambda axis: 0.0 if f"{axis}Min" in aspect else 1.0 if f"{axis}Max" in aspect else 0.5
    x = 0.0 if "none" in aspect else share("x") * (width - sx * box[2])
    y = 0.0 if "none" in aspect else share("Y") * (height - sy * box[3])
    return affine_of(sx, 0, 0, sy, x - sx * box[0], y - sy * box[1])


# ---- shapes


def rectangle(node):
    x, y, width, height = (length(node, name) for name in ("x", "y", "width", "height"))
    rx, ry = (length(node, name, None) for name in ("rx", "ry"))
    rx, ry = (ry or 0.0) if rx is None else rx, (rx or 0.0) if ry is None else ry
    rx, ry = min(rx, width / 2), min(ry, height / 2)
    if width <= 0 or height <= 0:
        return []
    if rx <= 0 or ry <= 0:
        return polygon([complex(x, y), complex(x + width, y), complex(x + width, y + height), complex(x, y + height)])
    arc = f"a{rx!r} {ry!r} 0 0 1"
    right, bottom = x + width, y + height
    return path_curves(f"M{x + rx!r} {y!r}H{right - rx!r}{arc} {rx!r} {ry!r}V{bottom - ry!r}{arc} {-rx!r} {ry!r}"
                       f"H{x + rx!r}{arc} {-rx!r} {-ry!r}V{y + ry!r}{arc} {rx!r} {-ry!r}z")


def polygon(points, is_closed=True):
    ends = points[1:] + points[:1] if is_closed else points[1:]
    return [Segment(a, b) for a, b in zip(points, ends) if a != b]


def points_of(node):
    found = numbers(node.get("points"))
    return [complex(x, y) for x, y in zip(found[::2], found[1::2])]


def oval(node, rx, ry):
    centre = complex(length(node, "cx"), length(node, "cy"))
    return [curves.ellipse(centre, complex(rx), 1j * ry)] if rx > 0 and ry > 0 else []


def line(node):
    x1, y1, x2, y2 = (length(node, name) for name in ("x1", "y1", "x2", "y2"))
    return polygon([complex(x1, y1), complex(x2, y2)], False)


SHAPES = {
    "path": lambda node: path_curves(node.get("d")),
    "rect": rectangle,
    "circle": lambda node: oval(node, length(node, "r"), length(node, "r")),
    "ellipse": lambda node: oval(node, length(node, "rx"), length(node, "ry")),
    "line": line,
    "polyline": lambda node: polygon(points_of(node), False),
    "polygon": lambda node: polygon(points_of(node)),
}


class SvgReader:
    """Collects the curves of a drawing whose names are wanted."""

    def __init__(self, sketch, root, wants):
        self.sketch, self.wants, self.left_out, self.by_id = sketch, wants, Counter(), {}
        self.collect(root)

    def collect(self, root):
        stack = [root]
        while stack:
            node = stack.pop()
            self.by_id.setdefault(node.get("id"), node)
            stack += node.children[::-1]

    def add_all(self, nodes, affine, name="", level=0):
        if level > MOST_LEVELS:
            raise self.sketch.fault(f"line {nodes[0].line}: groups lie in each other more than {MOST_LEVELS} times")
        for node in nodes:
            if node.is_hidden:
                continue
            try:
                self.add(node, affine, node.own_name or name, level)
            except ArithmeticError:
                raise self.sketch.fault(f"line {node.line}: {node.words}: a number is too large") from None
            except ValueError as error:
                what = "its path data: " if isinstance(error, PathError) else ""
                raise self.sketch.fault(f"line {node.line}: {node.words}: {what}{error}") from None

    def add(self, node, affine, name, level):
        inner = affine.after(transform(node.get("transform"))) if node.get("transform") else affine
        if node.tag in SHAPES:
            if self.wants(name):
                self.sketch.entities += [Entity(curve.mapped(inner), name, name, node.words)
                                         for curve in SHAPES[node.tag](node)]
        elif node.tag == "svg":
            place = affine_of(1, 0, 0, 1, length(node, "x"), length(node, "y"))
            view = view_map(node, length(node, "width"), length(node, "height")) if node.get("width") else Affine()
            self.add_all(node.children, inner.after(place).after(view), name, level + 1)
        elif node.tag == "use":
            self.add_use(node, inner, name, level)
        elif node.tag in GROUPS - NOT_DRAWN:
            self.add_all(node.children, inner, name, level + 1)
        elif node.tag in LEFT_OUT:
            self.left_out[node.tag] += 1

    def add_use(self, node, affine, name, level):
        link = node.get("href") or node.get("http://www.w3.org/1999/xlink href")
        target = self.by_id.get(link.removeprefix("#")) if link.startswith("#") else None
        if target is None:
            raise ValueError(f"it uses '{link}', which is no element of the file")
        place = affine.after(affine_of(1, 0, 0, 1, length(node, "x"), length(node, "y")))
        if target.tag == "symbol":
            sizes = [length(node, side, length(target, side)) for side in ("width", "height")]
            view = view_map(target, *sizes) if all(sizes) else Affine()
            self.add_all(target.children, place.after(view), name, level + 1)
        else:
            self.add_all([target], place, name, level + 1)


def page_map(sketch, root, unit):
    """From user units to the unit of the page, y upwards; the lower left corner of the page is the origin."""
    width, height = measure(root.get("width")), measure(root.get("height"))
    box = numbers(root.get("viewBox"))
    has_box = len(box) == 4 and min(box[2:]) > 0
    if unit or not (width or height):
        sketch.unit = unit or DEFAULT_UNIT
        if not unit:
            sketch.notes.append(f"the drawing states no size: its numbers are taken as {DEFAULT_UNIT} (--drawing-unit)")
        left, bottom = (box[0], box[1] + box[3]) if has_box else (0.0, converted(height, "px") if height else 0.0)
        return affine_of(1, 0, 0, -1, -left, bottom)
    sketch.unit = UNIT_OF_PAGE.get((width or height)[1], "mm")
    sizes = [converted(side, sketch.unit) if side else None for side in (width, height)]
    if has_box:
        sizes = [sizes[1] * box[2] / box[3] if sizes[0] is None else sizes[0],
                 sizes[0] * box[3] / box[2] if sizes[1] is None else sizes[1]]
        view = view_map(root, *sizes)
    else:
        scale = INCHES["px"] / INCHES[sketch.unit]
        view = affine_of(scale, 0, 0, scale)
    return affine_of(1, 0, 0, -1, 0, sizes[1] or 0.0).after(view)


def read_svg(name, data, unit, wants):
    """`data`: the bytes; `unit`: of the numbers in the drawing, or None: that of the page; `wants(name)`: whether
    curves of that name are read."""
    sketch = Sketch(name)
    root = parsed(sketch, data)
    reader = SvgReader(sketch, root, wants)
    reader.add_all(root.children, page_map(sketch, root, unit))
    if reader.left_out:
        sketch.notes.append(f"left out: {counts_in_words(reader.left_out)}")
    return sketch
