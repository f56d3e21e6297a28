"""Screenshots of pages in headless Chromium, compared with those in tests/peers/screenshots.

usage: screenshots.py STAGES-PAGE FINE-PAGE           compares; prints what differs
       screenshots.py STAGES-PAGE FINE-PAGE --renew   writes them anew
       screenshots.py STAGES-PAGE FINE-PAGE --drop    prints every layer whose absence the comparison does not notice
       screenshots.py STAGES-PAGE FINE-PAGE --font    compares with texts in another font

STAGES-PAGE has the six stages of bracket.step as tabs, FINE-PAGE a mesh of 100,000 quads. Drawings are those of the
canvas without texts, in a window of 960 x 640 pixels; one picture is of a whole page.
"""
import base64, io, pathlib, sys, time

sys.dont_write_bytecode = True
from PIL import Image

from browser import Page
from picture_difference import LARGEST, difference, is_same, shrunk

FOLDER = pathlib.Path(__file__).parent / "screenshots"
# name: page, keys, kind, layers that must be missed
SHOTS = {
    "bracket_field": (0, "2", "drawing", ["boundary", "field"]),
    "bracket_points": (0, "3", "drawing", ["boundary", "nodes"]),
    "bracket_separatrices": (0, "4", "drawing", ["separatrices", "nodes"]),
    "bracket_blocks": (0, "5", "drawing", ["blocks", "arcs", "irregular nodes"]),
    "bracket_quads_dark": (0, "6t", "drawing", ["quads"]),
    "bracket_page": (0, "t6", "page", ["quads"]),
    "fine_whole": (1, "0", "drawing", ["quads"]),
    "fine_near": (1, "++++++", "drawing", ["quads"]),
}
FIXED_WINDOW = """const style = document.getElementById("window").style;
style.cssText = arguments[0] ? "position: fixed; left: 0; top: 0; width: 960px; height: 640px; flex: none" : "";"""
OTHER_FONT = """document.body.style.fontFamily = "DejaVu Serif, serif"; document.body.style.fontSize = "15px";"""


def taken(page, kind):
    """The picture as it is stored."""
    if kind == "page":
        return shrunk(Image.open(io.BytesIO(page.driver.get_screenshot_as_png())))
    return shrunk(Image.open(io.BytesIO(base64.b64decode(page.picture("picture").split(",")[1]))))


def prepare(page, keys, kind):
    page.driver.execute_script(FIXED_WINDOW, kind == "drawing")
    time.sleep(0.5)  # the page notices its new size
    page.press("0", 0.5)
    page.press(keys, 0.8)


def switch(page, title):
    """Switches a layer by its box."""
    page.driver.execute_script("""[...document.querySelectorAll("#layers label")]
        .find((label) => label.textContent === arguments[0]).firstChild.click()""", title)


def reference_of(name):
    return Image.open(FOLDER / f"{name}.png").convert("RGB")


def compare(page, name, kind, _):
    share = difference(kind, taken(page, kind), reference_of(name))
    if share > LARGEST[kind]:
        print(f"{name}.png: {100 * share:.2f} % differ; if that is meant, renew it (tests/peers/screenshots.py)")


def drop(page, name, kind, layers):
    for layer in layers:
        switch(page, layer)
        page.press("0" if name != "fine_near" else "+-", 0.8)
        if is_same(kind, taken(page, kind), reference_of(name)):
            print(f"{name}.png: the layer {layer} is not missed")
        switch(page, layer)


def renew(page, name, kind, _):
    FOLDER.mkdir(exist_ok=True)
    taken(page, kind).save(FOLDER / f"{name}.png", optimize=True)


def main(pages, act, font=False):
    for number, path in enumerate(pages):
        with Page(path) as page:
            if font:
                page.driver.execute_script(OTHER_FONT)
            for name, (of_page, keys, kind, layers) in SHOTS.items():
                if of_page == number:
                    prepare(page, keys, kind)
                    act(page, name, kind, layers)


if __name__ == "__main__":
    choice = sys.argv[3] if len(sys.argv) > 3 else ""
    main(sys.argv[1:3], {"--renew": renew, "--drop": drop}.get(choice, compare), choice == "--font")
