"""Works with the page of quadbench in Chromium and prints what is wrong with it.

usage: judge_workbench.py ADDRESS flange | regions | aerofoil | keys

At the end it saves the command, and copies the mesh that is shown from the server's scratch folder in $TMPDIR to
shown.msh. Standard error: times.
"""
import os, pathlib, shutil, statistics, sys, time

from selenium.webdriver.common.keys import Keys

from workbench import Workbench

faults = []
CONTROL, SHIFT = Keys.CONTROL, Keys.SHIFT


def expect(condition, fault):
    if not condition:
        faults.append(fault)


def expect_command(page, *parts):
    page.wait()
    expect(not page.failure(), f"a run failed: {page.failure()}")
    for part in parts:
        expect(part in page.command(), f"the command has no '{part}': {page.command()}")


def judge_names(page):
    """All circles below a diameter get one name; all curves that continue one another, another name; Shift adds."""
    circle = page.circle()
    page.click(page.curve_middle(circle))
    page.press_button("Select")
    expect("3 curves" in page.text("#bench-item h2"), f"circles below: {page.text('#bench-item h2')}")
    page.fill(name="bolts")
    expect_command(page, "--name 'bolts=circles(<")
    page.click(page.curve_middle(0))
    page.press_button("Tangent to it")
    expect("6 curves" in page.text("#bench-item h2"), f"tangent: {page.text('#bench-item h2')}")
    page.fill(name="rim", near="0.15")
    expect_command(page, "--name rim=0,1,2,3,4,5", "--size-near rim=0.15")
    page.click(page.curve_middle(0))
    page.click(page.curve_middle(1), shift=True)
    expect("2 curves" in page.text("#bench-item h2"), "Shift does not add a curve to the selection")
    page.press(Keys.ESCAPE)


def judge_box(page):
    """A dragged box selects what lies in it; sizes of a name that lost curves stay with the rest."""
    page.press_button("In a box")
    width, height = page.data["width"] / 2, page.data["height"] / 2
    page.drag_from((-1.03 * width, -1.03 * height), (1.03 * width, -0.4 * height))
    expect("5 curves" in page.text("#bench-item h2"), f"in a box: {page.text('#bench-item h2')}")
    page.fill(name="foot")
    expect_command(page, "--name 'foot=box(", "--name rim=0,4,5", "--size-near rim=0.15")
    page.press_with(CONTROL, "z")
    page.wait()


def judge_history(page):
    """Undo and redo by keys and buttons."""
    commands = [page.command()]
    page.focus_drawing()
    for _ in range(2):
        page.press_with(CONTROL, "z")
        page.wait()
        commands.append(page.command())
    expect(len(set(commands)) == 3, f"undo does not change the command: {commands}")
    for before in (commands[1], commands[0]):
        page.press_with(CONTROL, SHIFT, "z")
        page.wait()
        expect(page.command() == before, f"redo leads to {page.command()}, not {before}")


def judge_view(page):
    """A new mesh leaves zoom, tab and layers as they were."""
    page.press("3")
    before = page.text("#tabs [aria-selected=true]")
    page.driver.execute_script("document.querySelector('#layers input').click()")
    page.press("++")
    place = page.place(40, 30)
    set_size(page, "0.25")
    expect_command(page, "--size 0.25")
    expect(page.text("#tabs [aria-selected=true]") == before, "a new mesh changes the chosen tab")
    expect(page.place(40, 31) != place and page.place(40, 30) == place, "a new mesh moves the view")
    is_shown = page.driver.execute_script("return document.querySelector('#layers input').checked")
    expect(not is_shown, "a new mesh shows a layer that was switched off")
    page.driver.execute_script("document.querySelector('#layers input').click()")
    page.focus_drawing()
    page.press("04")


def set_size(page, text):
    page.press(Keys.ESCAPE)
    page.focus_drawing()
    page.press("e", 0.1)
    page.press(text + Keys.ENTER, 0.1)


def judge_before(page):
    """The key b shows the lines of the mesh before; the table has the figures of both."""
    quads = page.figures()["quads"]
    expect(quads[0] != quads[1], f"before and after have equal counts: {quads}")
    for label in ("blocks", "irregular nodes", "R", "least scaled Jacobian", "greatest edge ratio"):
        expect("–" not in page.figures()[label], f"no figure of {label}: {page.figures()[label]}")
    page.focus_drawing()
    alone = page.picture("picture")
    page.press("b")
    expect(page.picture("picture") != alone, "the key b shows nothing")
    page.press("b")
    expect(page.picture("picture") == alone, "the key b does not hide the mesh before")


def judge_failures(page):
    """A message in its place; the last good mesh stays; undo mends it. What is no length is not sent at all."""
    good = page.text("#facts"), page.command()
    set_size(page, "-1")
    expect("not a length" in page.failure(), f"-1 as a size: {page.failure()}")
    page.press_button("Close")
    set_size(page, "1e-7")
    page.wait()
    expect("--max-elements" in page.failure(), f"1e-7 as a size: {page.failure()}")
    expect(page.text("#facts") == good[0], "a run that failed changes the mesh that is shown")
    page.driver.execute_script("document.querySelector('#bench-failure button').click()")
    page.wait()
    expect(not page.failure() and page.command() == good[1], "undo does not mend a run that failed")


def judge_order_of_answers(page):
    """An answer that comes after that to a later change does not replace it; a long run is announced."""
    expect(page.is_hidden("#bench-waiting"), "a run is announced, but none is under way")
    page.hold_answer()
    set_size(page, "0.31")
    page.await_held()
    time.sleep(0.4)
    expect(not page.is_hidden("#bench-waiting"), "a run of more than 0.3 s is not announced")
    set_size(page, "0.29")
    page.wait()
    later = page.text("#facts")
    page.let_go()
    expect("--size 0.29" in page.command() and not page.failure(), f"{page.command()}: {page.failure()}")
    expect(page.text("#facts") == later, "an older answer replaces the mesh of a newer one")
    expect(page.is_hidden("#bench-waiting"), "a run that has ended is still announced")


def judge_drags(page, count):
    """Irregular nodes follow the pointer; printed: the median time from drop to the new mesh."""
    page.focus_drawing()
    page.press("0")
    nodes, size, seconds = page.nodes(), page.data["width"], []
    for k in range(count):
        x, y = nodes[k]
        page.drag_from((x, y), (x + 0.02 * size, y))
        seconds.append(page.wait())
        expect(not page.failure(), f"a drag failed: {page.failure()}")
    expect(page.command().count("--nodes") == 1, f"moved nodes are not in the command: {page.command()}")
    print(f"from drop to mesh: {statistics.median(seconds):.2f} s", file=sys.stderr)


def judge_narrow(page):
    """All of the workbench can be reached in a narrow window."""
    page.narrow(380, 760)
    script = """return [...document.querySelectorAll("#bench-bar button")].filter((button) => {
        const box = button.getBoundingClientRect();
        return box.left < 0 || box.right > innerWidth || box.bottom > innerHeight; }).map((button) => button.textContent)"""
    outside = page.driver.execute_script(script)
    expect(not outside, f"outside a narrow window: {outside}")
    expect(page.driver.execute_script("return document.documentElement.scrollWidth") <= 380, "a narrow page scrolls sideways")


def judge_save(page):
    page.press_with(CONTROL, "s")
    await_saved(page, ".quadmesh.sh")


def await_saved(page, ending):
    end = time.time() + 20
    while not page.text("#status").endswith(f"{ending}.") and time.time() < end:
        time.sleep(0.05)
    status = page.text("#status")
    expect(status.startswith("Saved ") and status.endswith(f"{ending}."), f"no {ending} was saved: {status} {page.failure()}")


def flange(page):
    judge_names(page)
    judge_box(page)
    judge_history(page)
    judge_view(page)
    judge_before(page)
    judge_failures(page)
    judge_order_of_answers(page)
    page.click(page.curve_middle(page.circle()))
    page.fill(first="0.02", layers="2")
    expect_command(page, "--wall bolts:first=0.02,layers=2")
    page.press_with(CONTROL, "z")
    page.wait()
    page.press(Keys.ESCAPE)
    judge_drags(page, 3)
    page.press_with(CONTROL, "z")
    page.wait()
    judge_save(page)
    judge_narrow(page)


def regions(page):
    """Names from the CAD file; an interface; a corner; a node, which is put back."""
    names = page.layer("boundary")["names"]
    page.click(page.curve_middle(names.index("outlet")))
    page.fill(name="far end", near="0.3")
    expect_command(page, "--name 'far end=1'", "--size-near 'far end=0.3'")
    page.click(page.points("corners")[0])
    expect("1 block" in page.text("#bench-item output"), f"a corner: {page.text('#bench-item')}")
    page.press_button("+")
    expect_command(page, "--corner-valence", "=2")
    page.press_button("As computed")
    page.wait()
    expect("--corner-valence" not in page.command(), "the valence of a corner cannot be left to the program again")
    page.press(Keys.ESCAPE)
    judge_drags(page, 1)
    page.press_button("Put back")
    page.wait()
    expect("--nodes" not in page.command(), f"a node that was put back is still moved: {page.command()}")
    page.press_with(CONTROL, "z")
    page.wait()
    judge_save(page)


def aerofoil(page):
    """By keys alone: Tab to a curve, Enter, layers; Escape and Tab leave the drawing."""
    names = page.layer("boundary")["names"]
    page.focus_drawing()
    page.press(Keys.TAB * (names.index("lower") + 1), 0.1)
    expect("lower" in page.text("#status"), f"Tab leads to {page.text('#status')}")
    page.press(Keys.ENTER, 0.1)
    page.fill(first="0.002", growth="1.3", layers="4")
    expect_command(page, "--wall lower:first=0.002,growth=1.3,layers=4")
    page.press(Keys.ESCAPE + Keys.TAB, 0.1)
    focus = page.driver.execute_script("return document.activeElement.id")
    expect(focus != "overlay" or page.text("#status"), "Tab after Escape does not leave the drawing")
    set_size(page, "1.5")
    expect_command(page, "--size 1.5")
    page.press_with(CONTROL, "z")
    page.wait()
    judge_save(page)


def keys(page):
    """A node is chosen and moved by keys, undone, done again; each button saves its file; other origins save nothing."""
    at_first = page.command()
    page.focus_drawing()
    page.press_with(SHIFT, Keys.TAB)
    start = page.text("#status")
    page.press(Keys.ARROW_RIGHT, 0.1)
    one = page.text("#status")
    expect(one.startswith("node to ") and one != start, f"an arrow moves no node: {start}, then {one}")
    page.press_with(SHIFT, Keys.ARROW_LEFT)
    expect(page.text("#status") not in (one, start), "an arrow with Shift does not move the node by a smaller step")
    page.press(Keys.ARROW_UP * 2, 0.1)
    page.press(Keys.ESCAPE, 0.1)
    expect(page.command() == at_first, "a node that Escape leaves is moved")
    page.press(Keys.ARROW_RIGHT * 3 + Keys.ARROW_DOWN, 0.1)
    page.press(Keys.ENTER, 0.1)
    expect_command(page, "--nodes")
    moved, facts = page.command(), page.figures()
    for button, command in (("undo", at_first), ("redo", moved)):
        page.find(f"#bench-{button}").click()
        page.wait()
        expect(page.command() == command, f"{button} leads to {page.command()}, not {command}")
    expect({row: now for row, (_, now) in page.figures().items()} == {row: now for row, (_, now) in facts.items()},
           "what was done again has other figures")
    judge_refusals(page)
    for button, ending in (("Makefile", ".mk"), ("Nodes", ".crit.json"), ("Command", ".quadmesh.sh")):
        page.find(f"//div[@aria-label='Save']/button[.='{button}']").click()
        await_saved(page, ending)


def judge_refusals(page):
    """Of this browser: paths without the token or outside, and requests of another page, are not answered."""
    statuses = page.driver.execute_async_script("""const done = arguments[arguments.length - 1], post = { method: "POST",
          headers: { "Content-Type": "application/json" }, body: '{"number": 99, "state": {}, "what": "nodes"}' };
        const asked = [["/", {}], ["/wrong/run", post], ["/wrong/save", post], ["half_disc.step", {}], ["/etc/passwd", {}]];
        Promise.all(asked.map(([path, how]) => fetch(path, how).then(({ status }) => status))).then(done);""")
    expect(statuses == [404] * 5, f"requests without the token or outside the folder are answered with {statuses}")
    page.messages()  # those of the requests above
    address, here = page.driver.current_url, page.driver.current_window_handle
    for origin in (address.replace("127.0.0.1", "localhost"), "about:blank"):
        page.driver.switch_to.new_window("tab")
        page.driver.get(origin)
        answer = page.driver.execute_async_script("""const [address, done] = arguments;
            fetch(address + "save", { method: "POST", mode: "no-cors", body: '{"state": {}, "what": "nodes"}' })
              .then(({ type }) => done(type), () => done("refused"));""", address)
        expect(answer in ("refused", "opaque"), f"a page of {origin} reads the answer: {answer}")
        page.driver.execute_script("window.onbeforeunload = null")
        page.messages()
        page.driver.close()
        page.driver.switch_to.window(here)
        expect(not list(pathlib.Path("shapes").glob("*.crit.json")), f"a page of {origin} saves files")


def judge_labels(page):
    """Everything that can be operated has a name for those who do not see it."""
    unnamed = page.driver.execute_script("""return [...document.querySelectorAll("#bench button, #bench input, #bench-bar button")]
        .filter((made) => !(made.textContent || made.ariaLabel || made.labels?.length)).map((made) => made.outerHTML)""")
    expect(not unnamed, f"without a name: {unnamed}")


with Workbench(sys.argv[1]) as opened:
    {"flange": flange, "regions": regions, "aerofoil": aerofoil, "keys": keys}[sys.argv[2]](opened)
    judge_labels(opened)
    faults.extend(opened.messages())
    part = "moved" if "--nodes" in opened.command() else "found"
    [mesh] = pathlib.Path(os.environ["TMPDIR"]).glob(f"quadbench.*/{part}/mesh/**/*.msh")
    shutil.copy(mesh, "shown.msh")
print("\n".join(faults), end="\n" if faults else "")
sys.exit(bool(faults))
