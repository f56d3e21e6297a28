"""Line plots as SVG, in plain python: panels in a grid, linear or logarithmic axes, one legend for all."""
import math
from xml.sax.saxutils import escape

COLOURS = ("#1f6fb4", "#d9541e", "#2a9d5c", "#7d4fb0", "#8a6d3b", "#c2366f")
WIDTH, HEIGHT = 330, 250  # of a panel
LEFT, RIGHT, TOP, BOTTOM = 62, 14, 30, 44  # its margins


class Axis:
    """Maps [low, high] to [start, end] on the page."""

    def __init__(self, values, is_log, start, end):
        self.is_log, self.start, self.end = is_log, start, end
        values = [math.log10(v) if is_log else v for v in values]
        low, high = min(values), max(values)
        if is_log:
            low, high = math.floor(low + 1e-9), math.ceil(high - 1e-9)
        if high <= low:
            low, high = low - 1, high + 1
        if not is_log:
            low, high = low - 0.04 * (high - low), high + 0.04 * (high - low)
        self.low, self.high = low, high

    def __call__(self, value):
        value = math.log10(value) if self.is_log else value
        return self.start + (self.end - self.start) * (value - self.low) / (self.high - self.low)

    def ticks(self):
        if self.is_log:
            step = max(1, math.ceil((self.high - self.low) / 6))
            return [10.0**k for k in range(self.low, self.high + 1, step)]
        span = self.high - self.low
        step = next(s * 10**e for e in range(-6, 9) for s in (1, 2, 5) if span / (s * 10**e) <= 7)
        first = math.ceil(self.low / step)
        return [k * step for k in range(first, int(self.high / step + 1e-9) + 1)]


def label(value, is_log):
    if not is_log:
        return f"{value:g}"
    power = str(round(math.log10(value))).replace("-", "\u2212")
    return f'10<tspan dy="-5" font-size="8.5">{power}</tspan>'


def text(x, y, content, anchor="start", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{content}</text>'


def marker(shape, x, y, colour):
    if shape == "diamond":
        return f'<path d="M{x:.1f} {y - 5:.1f}l5 5l-5 5l-5 -5z" fill="{colour}"/>'
    if shape == "square":
        box = f'x="{x - 2.8:.1f}" y="{y - 2.8:.1f}" width="5.6" height="5.6"'
        return f'<rect {box} fill="white" stroke="{colour}" stroke-width="1.4"/>'
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.6" fill="{colour}"/>'


def draw_panel(panel, left, top, styles):
    """panel: title, x, y (labels), x_log, y_log, series {name: [(x, y), ...]}."""
    points = [p for series in panel["series"].values() for p in series]
    x = Axis([p[0] for p in points], panel.get("x_log", False), left + LEFT, left + WIDTH - RIGHT)
    y = Axis([p[1] for p in points], panel.get("y_log", True), top + HEIGHT - BOTTOM, top + TOP)
    middle_x, middle_y = (x.start + x.end) / 2, (y.start + y.end) / 2
    out = [text(middle_x, top + 19, escape(panel["title"]), "middle", ' font-weight="bold"')]
    for tick in x.ticks():
        out.append(f'<path d="M{x(tick):.1f} {y.start}V{y.end}" stroke="#e4e4e4"/>')
        out.append(text(x(tick), y.start + 15, label(tick, x.is_log), "middle"))
    for tick in y.ticks():
        out.append(f'<path d="M{x.start} {y(tick):.1f}H{x.end}" stroke="#e4e4e4"/>')
        out.append(text(x.start - 6, y(tick) + 4, label(tick, y.is_log), "end"))
    out.append(f'<path d="M{x.start} {y.start}H{x.end}V{y.end}H{x.start}z" fill="none" stroke="#777"/>')
    out.append(text(middle_x, y.start + 33, escape(panel["x"]), "middle"))
    turned = f' transform="translate({left + 15} {middle_y:.1f}) rotate(-90)"'
    out.append(text(0, 0, escape(panel["y"]), "middle", turned))
    for name, series in panel["series"].items():
        colour, shape, dash = styles[name]
        if len(series) > 1:
            line = " ".join(f"{x(a):.1f},{y(b):.1f}" for a, b in series)
            out.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="1.6"{dash}/>')
        if shape != "none":
            out += [marker(shape, x(a), y(b), colour) for a, b in series]
    return out


def plot(path, panels, columns, markers=None):
    """Writes the panels to `path`. markers: {series name: "circle", "square", "diamond", "none" (dashed line)}."""
    names = list(dict.fromkeys(name for panel in panels for name in panel["series"]))
    styles = {}
    for i, name in enumerate(names):
        shape = (markers or {}).get(name, "circle")
        styles[name] = (COLOURS[i % len(COLOURS)], shape, ' stroke-dasharray="5 4"' if shape == "none" else "")
    rows = -(-len(panels) // columns)
    width, height = columns * WIDTH, rows * HEIGHT + 30
    size = f'width="{width}" height="{height}"'
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" {size} viewBox="0 0 {width} {height}" fill="#222" '
           'font-family="sans-serif" font-size="11">', f'<rect {size} fill="white"/>']
    across = LEFT
    for name in names:
        colour, shape, dash = styles[name]
        out.append(f'<path d="M{across} 16h22" stroke="{colour}" stroke-width="1.6"{dash}/>')
        if shape != "none":
            out.append(marker(shape, across + 11, 16, colour))
        out.append(text(across + 28, 20, escape(name)))
        across += 50 + 6.2 * len(name)
    for i, panel in enumerate(panels):
        out += draw_panel(panel, i % columns * WIDTH, 30 + i // columns * HEIGHT, styles)
    path.write_text("\n".join(out) + "\n</svg>\n", encoding="utf-8")
