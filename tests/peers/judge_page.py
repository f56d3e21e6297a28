"""Opens a page of stageview in Chromium and prints what is wrong with it.

usage: judge_page.py PAGE NUMBER-OF-TABS [report | comparison | space | body | NAME...]

The last tab must be a quad mesh; with "report", the report of a run behind one; with "space", hexahedra; with "body",
a mesh in a far field. Title and heading must contain each NAME.
"""
import re, sys, time

from browser import Page

faults = []


def expect(condition, fault):
    if not condition:
        faults.append(fault)


def judge_keys(page):
    page.press("0")
    before = page.picture("picture")
    page.press("+")
    expect(page.picture("picture") != before, "the key + does not zoom")
    page.press("0")
    expect(page.picture("picture") == before, "the key 0 does not show everything again")
    theme = page.find("html").get_attribute("data-theme")
    page.press("t")
    expect(page.find("html").get_attribute("data-theme") != theme, "the key t does not change the theme")
    labels = page.picture("overlay")
    page.press("l")
    expect(page.picture("overlay") != labels, "the key l does not hide the labels")
    page.press("?")
    expect(not page.is_hidden("#help"), "the key ? does not show the keys")
    page.press("\ue00c")
    expect(page.is_hidden("#help"), "Escape does not hide the keys")
    measure = page.text("#measure-title")
    page.press("q")
    expect(page.text("#measure-title") != measure, "the key q does not choose the next measure")
    page.press("Q")
    expect(page.text("#measure-title") == measure, "the key Q does not choose the measure before")


def judge_names(page, stems):
    """Heading, title and tabs name the shape or, in a comparison, A and B."""
    for text in (page.text("#title"), page.driver.title):
        expect(all(stem in text for stem in stems), f"the page is called {text}, not {' and '.join(stems)}")


def judge_legend(page, number):
    """The legend tells the marks, lines and colours of what is shown; critical points are shown alone at first."""
    page.press(str(number))
    boxes = page.driver.find_elements("css selector", "#layers label")
    on = [box.text for box in boxes if box.find_element("css selector", "input").is_selected()]
    if "zeros of the field" in page.text("#layers"):
        expect(on == ["boundary", "nodes"], f"of nodes {on} are shown at first")
    for layer, words in (("field", "cross angle"), ("nodes", "valence"), ("separatrices", "separatrices")):
        has_none = layer == "nodes" and re.match("0 (nodes|critical)", page.text("#caption"))
        expect(layer not in on or has_none or words in page.text("#legend"), f"the legend says nothing of {layer}")


def judge_body(page):
    """In a far field the body fills the first view; 0 shows everything, v the body again."""
    first = page.picture("picture")
    page.press("0")
    expect(page.picture("picture") != first, "the first view shows everything")
    page.press("v")
    expect(page.picture("picture") == first, "the key v does not show the body again")


def judge_header(page):
    """In a window of a telephone the header takes little room."""
    page.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                {"width": 380, "height": 700, "deviceScaleFactor": 1, "mobile": False})
    time.sleep(0.4)
    height = page.driver.execute_script("return document.querySelector('header').offsetHeight")
    expect(height <= 60, f"the header is {height} pixels high in a window of 380")
    page.driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
    time.sleep(0.4)


def judge_worst(page):
    """The worst element is pinned, lies in the middle of the window, and is what the pointer finds there."""
    page.press("w")
    worst = re.match(r"quad \d+", page.text("#status"))
    expect(worst, f"the key w goes to no quad: {page.text('#status')}")
    expect(not page.is_hidden("#tip"), "the worst element has no figures")
    page.point_at_middle(1, 1)
    tip = page.text("#tip")
    expect(worst and tip.startswith(worst[0]), f"the pointer is over {worst and worst[0]}, the page shows {tip}")
    least = re.search(r"least\s([\d.e-]+)", page.text("#measure-text"))
    expect(least and f"scaled Jacobian{least[1]}" in tip, f"{tip} does not show the least value {least and least[1]}")
    for text in ("sides", "area", "skewness"):
        expect(text in tip, f"the figures of an element have no {text}: {tip}")
    page.press("w")
    expect(not worst or not page.text("#status").startswith(worst[0] + " "), "the key w does not go on")


def judge_tabs(page, count):
    tabs = page.driver.find_elements("css selector", "#tabs button")
    expect(len(tabs) == count, f"{len(tabs)} tabs instead of {count}")
    for number in range(1, len(tabs) + 1):
        page.press(str(number))
        expect(page.text("#tabs [aria-selected=true]") == tabs_text(page, number), f"the key {number} chooses no tab")


def tabs_text(page, number):
    return page.text(f"#tabs button:nth-child({number})")


def judge_report(page, count):
    """The tab of the run has histograms, commands and times; the key r leaves it and shows it again."""
    page.press(str(count))
    expect(not page.is_hidden("#report"), "the last tab does not show the report")
    text = page.text("#report")
    for part in ("scaled Jacobian", "skewness", "quadmesh -q half_disc.step", "quadrefine --", "padapt", "CPU seconds", "index sum"):
        expect(part in text, f"the report lacks '{part}'")
    labels = page.driver.execute_script("""return [...document.querySelectorAll("#report .tables h3, #report .tables td:first-child")]
        .map((cell) => cell.textContent)""")
    expect(len(labels) > 40 and not any("_" in label for label in labels), f"the report has keys in place of words: {labels}")
    expect("curve_1" in text, "the report has no elements along curve_1")
    expect("object" not in page.text("#report .tables"), "the report has lists that it does not show")
    page.press("r")
    expect(page.is_hidden("#report"), "the key r does not leave the report")


def judge_comparison(page):
    """What moves one pane moves the other; a cross marks the pointer in the other; s puts one over the other."""
    expect(page.find("#picture-b").is_displayed(), "B is not beside A")
    for key in ("+", "\ue014", "0"):  # zoom, move right, show everything
        before = [page.picture("picture"), page.picture("picture-b")]
        page.press(key)
        after = [page.picture("picture"), page.picture("picture-b")]
        expect(before[0] != after[0] and before[1] != after[1], f"the key {key!r} does not move both")
    overlay = page.picture("overlay-b")
    page.point_at_middle(20, 20)
    expect(page.picture("overlay-b") != overlay, "the pointer over A is not marked in B")
    page.press("s")
    expect(not page.find("#picture-b").is_displayed(), "the key s does not put one over the other")


def shown(page):
    """How many hexahedra the cut shows, and of how many."""
    found = re.search(r"(\d+) of (\d+) hexahedra shown", page.text("#cut-text"))
    return (int(found[1]), int(found[2])) if found else (0, 0)


def judge_cut(page):
    """Keys choose the cut, move it, and show the other side; the slider moves it too; c comes back to no cut."""
    whole = page.picture("space")
    counts = []
    for _ in "xyz":
        page.press("c")
        expect(page.picture("space") != whole, "a cut shows what the whole mesh shows")
        counts.append(shown(page))
        page.press("x")
        other = shown(page)
        expect(counts[-1][0] + other[0] == other[1], f"the two sides of a cut have {counts[-1]} and {other}")
        page.press("x")
    page.press(".........")
    expect(shown(page)[0] > counts[-1][0], "the key . does not move the cut outwards")
    page.press(",,,,,,,,,,,,,,,,,,")
    expect(shown(page)[0] < counts[-1][0], "the key , does not move the cut inwards")
    page.driver.execute_script("""const slider = document.getElementById("cut-at");
                                  slider.value = 100; slider.dispatchEvent(new Event("input"));""")
    time.sleep(0.5)
    expect(shown(page)[0] == shown(page)[1] > 0, "at the end of the slider elements are left out")
    page.press("cc")
    expect(page.picture("space") == whole, "without a cut the picture is not the first one")


def judge_space(page):
    """The pointer and keys turn and zoom the mesh; what is under the pointer has figures; w shows the worst element."""
    judge_cut(page)
    whole = page.picture("space")
    for keys in ("+", "\ue012", "t"):
        before = page.picture("space")
        page.press(keys)
        expect(page.picture("space") != before, f"the key {keys!r} changes nothing")
    page.press("t0")
    expect(page.picture("space") == whole, "the key 0 does not show the first view again")
    page.drag(5, 12, 4, "#space")
    time.sleep(0.5)
    expect(page.picture("space") != whole, "the pointer does not turn the mesh")
    page.point_at_middle(1, 1, "#space")
    expect(re.match(r"hexahedron \d+ · layer \d+", page.text("#tip")), f"under the pointer is {page.text('#tip')}")
    page.press("w")
    worst, tip = re.match(r"hexahedron \d+", page.text("#status")), page.text("#tip")
    expect(worst and tip.startswith(worst[0] + " "), f"the worst is {page.text('#status')}, the page shows {tip}")
    slowest = max(page.milliseconds("draw turned"), default=0)
    expect(0 < slowest < 1500, f"a picture while it turns takes {slowest:.0f} ms")  # on a machine that is shared


def judge_speed(page):
    """The sharp picture follows the end of a movement within half a second, of which 0.12 s are a pause."""
    page.milliseconds("draw sharp")
    page.press("0")
    page.press("+")
    page.press("+")
    slowest = max(page.milliseconds("draw sharp"), default=0)
    expect(slowest < 1500, f"a sharp picture takes {slowest:.0f} ms")  # on a machine that is shared


with Page(sys.argv[1]) as opened:
    if "body" in sys.argv[3:]:
        judge_body(opened)
    judge_tabs(opened, int(sys.argv[2]))
    judge_names(opened, [word for word in sys.argv[3:] if word not in ("report", "comparison", "space", "body")])
    for tab in range(1, int(sys.argv[2]) + ("report" not in sys.argv[3:])):
        judge_legend(opened, tab)
    judge_header(opened)
    if "report" in sys.argv[3:]:
        judge_report(opened, int(sys.argv[2]))
    if "comparison" in sys.argv[3:]:
        judge_comparison(opened)
    if "space" in sys.argv[3:]:
        judge_space(opened)
    else:
        judge_keys(opened)
        judge_worst(opened)
        judge_speed(opened)
    faults.extend(opened.messages())
print("\n".join(faults), end="\n" if faults else "")
sys.exit(bool(faults))
