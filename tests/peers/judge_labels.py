"""Opens a page of stageview in Chromium and prints what is wrong with the labels of curves, in many views.

usage: judge_labels.py PAGE NAME...

A label must lie beside a curve of its name, nearer than any other curve, with no piece of the boundary between, and
cover neither the boundary nor another label. Each NAME must be among them at first.
"""
import math, pathlib, sys

from browser import Page

faults = []

# The script of the page has no names outside: a copy of it notes what it places, beside the boundary, all in pixels.
PLACES = "function placedLabels(context, view, layers, all) {"
RECORD = PLACES + """
      const placed = placedBefore(context, view, layers, all), boundary = layers.find((layer) => layer.style === "boundary");
      const nameOf = (item) => (all ? boundary.numberAndName(item) : boundary.names[item]);
      window.recorded = {
        curves: [...Array(boundary.count).keys()].map((item) => [nameOf(item), boundary.screenPoints(view, item)]),
        labels: placed.map(({ text, x, y }) => [text, x, y, context.measureText(text).width / 2]),
      };
      return placed;
    }
    """ + PLACES.replace("placedLabels", "placedBefore")


def recording(path):
    text = pathlib.Path(path).read_text()
    if text.count(PLACES) != 1:
        sys.exit(f"{path} has no {PLACES}")
    copy = pathlib.Path(path).with_suffix(".labels.html")
    copy.write_text(text.replace(PLACES, RECORD))
    return str(copy)


def expect(condition, fault):
    if not condition:
        faults.append(fault)


def pieces(points):
    return list(zip(points, points[1:]))


def to_segment(at, piece):
    (ax, ay), (bx, by) = piece
    dx, dy = bx - ax, by - ay
    square = dx * dx + dy * dy
    part = max(0, min(1, ((at[0] - ax) * dx + (at[1] - ay) * dy) / square)) if square else 0
    return math.hypot(at[0] - ax - part * dx, at[1] - ay - part * dy)


def distance(box, piece):
    """Of a piece of a line that does not cross the box."""
    corners = [(x, y) for x in (box[0], box[2]) for y in (box[1], box[3])]
    ends = [math.hypot(max(box[0] - x, 0, x - box[2]), max(box[1] - y, 0, y - box[3])) for x, y in piece]
    return min([to_segment(corner, piece) for corner in corners] + ends)


def crosses_box(piece, box):
    """Whether a piece of a line has a point in the box; by points a pixel apart."""
    (ax, ay), (bx, by) = piece
    count = int(max(abs(bx - ax), abs(by - ay))) + 1
    return any(box[0] < ax + k / count * (bx - ax) < box[2] and box[1] < ay + k / count * (by - ay) < box[3]
               for k in range(count + 1))


def judge_labels(page, view):
    recorded = page.driver.execute_script("return window.recorded")
    boxes = [(text, (x - half, y - 6, x + half, y + 6)) for text, x, y, half in recorded["labels"]]
    for number, (text, box) in enumerate(boxes):
        own = min((distance(box, piece) for name, points in recorded["curves"] if name == text for piece in pieces(points)),
                  default=math.inf)
        for name, points in recorded["curves"]:
            for piece in pieces(points):
                expect(not crosses_box(piece, box), f"{view}: {text} covers the curve {name}")
                expect(name == text or distance(box, piece) >= own - 0.5, f"{view}: {text} is nearer to {name}")
        for other, (left, top, right, bottom) in boxes[:number]:
            apart = box[0] >= right or left >= box[2] or box[1] >= bottom or top >= box[3]
            expect(apart, f"{view}: {text} covers {other}")
    return [text for text, _ in boxes]


with Page(recording(sys.argv[1])) as opened:
    opened.press("+0")
    seen = judge_labels(opened, "all")
    expect(set(sys.argv[2:]) <= set(seen), f"of {sys.argv[2:]} only {seen} are written")
    for step in range(1, 9):
        opened.press("+")
        judge_labels(opened, f"after + {step} times")
    opened.press("0l")
    expect(judge_labels(opened, "numbers and names"), "no numbers are written")
    opened.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                  {"width": 500, "height": 500, "deviceScaleFactor": 1, "mobile": False})
    opened.press("0ll", 0.8)
    judge_labels(opened, "in a small window")
    faults.extend(opened.messages())
unique = list(dict.fromkeys(faults))
print("\n".join(unique), end="\n" if unique else "")
sys.exit(bool(unique))
