"""Opens the table of quadbatch in Chromium and prints what is wrong with it.

usage: judge_table.py TABLE LONG-NAME

LONG-NAME: of a shape, longer than its column.
"""
import re, sys, time

from selenium.webdriver.common.keys import Keys

from browser import Page

faults = []


def expect(condition, fault):
    if not condition:
        faults.append(fault)


def column(page, at):
    return page.driver.execute_script(
        "return [...document.querySelectorAll('tbody tr')].map((row) => row.cells[arguments[0]].textContent)", at)


def directions(page):
    return page.driver.execute_script("return [...document.querySelectorAll('th')].map((head) => head.ariaSort)")


def is_sorted(page, texts, direction):
    """Numbers by size, texts as the language of the browser has them, numbers in them by size."""
    if direction == "descending":
        texts = texts[::-1]
    try:
        numbers = [float(text) for text in texts]
        return numbers == sorted(numbers)
    except ValueError:
        return page.driver.execute_script("""const order = new Intl.Collator(undefined, { numeric: true });
            return arguments[0].every((text, k, all) => !k || order.compare(all[k - 1], text) <= 0);""", texts)


def judge_column(page, at, by_keys):
    """The first press sorts upwards, the second downwards; empty cells stay last; the arrow is at this head alone."""
    button = page.find(f"thead th:nth-child({at + 1}) button")
    before = column(page, at)
    num_filled = len(before) - before.count("")
    for direction in ("ascending", "descending"):
        button.send_keys(Keys.ENTER) if by_keys else button.click()
        found = column(page, at)
        expect(is_sorted(page, found[:num_filled], direction), f"column {at} is not {direction}: {found}")
        expect(not any(found[num_filled:]), f"empty cells of column {at} are not last: {found}")
        heads = directions(page)
        expect(heads[at] == direction, f"head {at} says {heads[at]}, not {direction}")
        expect(all(head in (None, "none") for k, head in enumerate(heads) if k != at), f"other heads have arrows: {heads}")


def judge_rows(page):
    """Cells of one shape stay together."""
    rows = page.driver.execute_script("""return [...document.querySelectorAll("tbody tr")]
        .map((row) => [...row.cells].map((cell) => cell.textContent).join("|")).sort()""")
    return rows


def judge_long_name(page, name):
    """It is cut with an ellipsis, has the whole as its title, and makes no column wider than 32 letters."""
    cut, title, width, letters, overflow = page.driver.execute_script("""
        const name = [...document.querySelectorAll(".name")].find((span) => span.textContent.includes(arguments[0]));
        const style = getComputedStyle(name), context = document.createElement("canvas").getContext("2d");
        context.font = style.font;
        return [name.scrollWidth > name.clientWidth, name.title, name.clientWidth, context.measureText("0").width * 32,
                style.textOverflow];""", name)
    expect(cut and overflow == "ellipsis", "a long name is not cut")
    expect(name in title, f"the title of a long name is {title}")
    expect(width <= letters + 2, f"a long name is {width} pixels wide, of at most {letters}")


def luminance(colour):
    """Of rgb(...): WCAG 2."""
    parts = [int(part) / 255 for part in re.findall(r"\d+", colour)[:3]]
    red, green, blue = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def judge_colours(page, scheme):
    """Texts can be read on their ground, also in rows of failures."""
    page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
    time.sleep(0.2)
    paper = page.driver.execute_script("return getComputedStyle(document.body).backgroundColor")
    expect((luminance(paper) < 0.1) == (scheme == "dark"), f"the ground is {paper} where pages are {scheme}")
    cells = page.driver.execute_script("""return ["tbody tr:not(.failed) td:nth-child(3)", "tr.failed td:nth-child(3)", "th button"]
        .map((selector) => document.querySelector(selector)).map((cell) => {
          let ground = cell;
          while (ground.parentElement && getComputedStyle(ground).backgroundColor === "rgba(0, 0, 0, 0)") ground = ground.parentElement;
          return [getComputedStyle(cell).color, getComputedStyle(ground).backgroundColor]; })""")
    for ink, ground in cells:
        high, low = sorted((luminance(ink), luminance(ground)), reverse=True)
        expect((high + 0.05) / (low + 0.05) >= 4.5, f"{scheme}: {ink} on {ground} is hard to read")


with Page(sys.argv[1]) as opened:
    first = judge_rows(opened)
    exit_codes = column(opened, 2)
    expect(exit_codes == sorted(exit_codes, reverse=True), f"failures are not first: {exit_codes}")
    for number in range(1, len(directions(opened))):
        judge_column(opened, number, by_keys=number % 2 == 0)
    expect(judge_rows(opened) == first, "sorting mixes the cells of shapes")
    judge_long_name(opened, sys.argv[2])
    for wanted_scheme in ("light", "dark"):
        judge_colours(opened, wanted_scheme)
    broken = opened.driver.execute_script("return [...document.images].filter((image) => !image.naturalWidth).map((image) => image.src)")
    expect(not broken, f"pictures that are not shown: {broken}")
    faults.extend(opened.messages())
print("\n".join(faults), end="\n" if faults else "")
sys.exit(bool(faults))
