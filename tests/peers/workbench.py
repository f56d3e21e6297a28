"""The page of quadbench in headless Chromium: positions of curves and nodes in the window, clicks, drags, answers. Used by
judge_workbench.py."""
import base64, json, struct, time

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

from browser import Page


class Workbench(Page):
    def __init__(self, address, size=(1400, 900)):
        super().__init__(address, size)
        self.data = json.loads(self.text("#data"))
        self.answers = 0
        time.sleep(0.5)

    def layer(self, key):
        return next(layer for sheet in self.data["sheets"] for layer in self.all_layers(sheet) if layer["key"] == key)

    @staticmethod
    def all_layers(sheet):
        return ([sheet["boundary"]] if "boundary" in sheet else []) + sheet["layers"]

    def points(self, key):
        """Of a layer of the first page, relative to the middle of the frame."""
        raw = base64.b64decode(self.layer(key)["points"])
        numbers = [unit * self.data["step"] for unit in struct.unpack(f"<{len(raw) // 4}i", raw)]
        return list(zip(numbers[::2], numbers[1::2]))

    def nodes(self):
        """Irregular nodes inside the face."""
        return [p for p, kind in zip(self.points("nodes"), self.layer("nodes")["kinds"]) if kind == "node"]

    def curve_middle(self, curve):
        """The end of a piece near the middle of a curve."""
        raw = base64.b64decode(self.layer("boundary")["offsets"])
        first, end = struct.unpack_from("<2i", raw, 4 * curve)
        points, pieces = self.points("boundary"), (end - first - 1) // 3
        if pieces > 1:
            return points[first + 3 * (pieces // 2)]
        a, b, c, d = points[first:end]
        return tuple((p + 3 * q + 3 * r + s) / 8 for p, q, r, s in zip(a, b, c, d))

    def circle(self):
        """A small hole: a curve that ends where it begins."""
        return len(self.layer("boundary")["names"]) - 1

    def in_window(self, at):
        """Pixels of the drawing of a position, relative to its middle; with the first view of the page."""
        width, height = self.canvas_size()
        scale = min((width - 128) / self.data["width"], (height - 128) / self.data["height"])
        return round(at[0] * scale), round(-at[1] * scale)

    def canvas_size(self):
        return self.driver.execute_script(
            "const canvas = document.getElementById('overlay'); return [canvas.clientWidth, canvas.clientHeight]")

    def move_to(self, at):
        return ActionChains(self.driver, duration=40).move_to_element_with_offset(self.find("#overlay"), *self.in_window(at))

    def click(self, at, shift=False):
        actions = self.move_to(at)
        if shift:
            actions.key_down(Keys.SHIFT)
        actions.click()
        if shift:
            actions.key_up(Keys.SHIFT)
        actions.perform()
        time.sleep(0.1)

    def place(self, dx, dy):
        """The position that the page shows for a pixel of the drawing."""
        self.point_at_middle(dx, dy)
        return self.text("#place")

    def focus_drawing(self):
        self.driver.execute_script("document.getElementById('overlay').focus()")

    def press_with(self, *held_and_key):
        """A key with others held down."""
        *held, key = held_and_key
        actions = ActionChains(self.driver)
        for modifier in held:
            actions.key_down(modifier)
        actions.send_keys(key)
        for modifier in held:
            actions.key_up(modifier)
        actions.perform()
        time.sleep(0.1)

    def hold_answer(self):
        """The answer to the next request reaches the page when it is let go."""
        self.driver.execute_script("""const own = window.fetch;
            window.fetch = async (...all) => {
              window.fetch = own;
              const answer = await own(...all);
              await new Promise((letGo) => (window.letGo = letGo));
              return answer;
            };""")

    def await_held(self, seconds=60):
        end = time.time() + seconds
        while time.time() < end and not self.driver.execute_script("return Boolean(window.letGo)"):
            time.sleep(0.05)

    def let_go(self):
        self.driver.execute_script("window.letGo()")
        time.sleep(0.5)

    def narrow(self, width, height):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                    {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        time.sleep(0.6)

    def drag_from(self, at, to):
        """In three steps."""
        x0, y0 = self.in_window(at)
        x1, y1 = self.in_window(to)
        actions = self.move_to(at).click_and_hold()
        xs = [x0 + round((x1 - x0) * k / 3) for k in range(4)]
        ys = [y0 + round((y1 - y0) * k / 3) for k in range(4)]
        for k in range(3):
            actions.move_by_offset(xs[k + 1] - xs[k], ys[k + 1] - ys[k])
        actions.release().perform()

    def fill(self, **values):
        """Fields of the open form by their names; Enter in the last one applies them."""
        for name, value in values.items():
            field = self.find(f"#bench input[name={name}]")
            field.clear()
            field.send_keys(value)
        field.send_keys(Keys.ENTER)

    def press_button(self, text):
        self.driver.execute_script("""[...document.querySelectorAll("button")]
            .find((button) => button.textContent === arguments[0] && !button.closest("[hidden]")).click()""", text)

    def wait(self, seconds=60):
        """For the answer to the last change; returns the seconds from the change to the new picture."""
        script = "return performance.getEntriesByName('change to mesh').map((entry) => entry.duration / 1000)"
        end = time.time() + seconds
        while time.time() < end:
            times = self.driver.execute_script(script)
            if len(times) > self.answers:
                self.answers = len(times)
                return times[-1]
            time.sleep(0.02)
        raise TimeoutError(f"no answer within {seconds} s: {self.text('#bench-failure p')}")

    def figures(self):
        """{label: (before, now)} of the table."""
        rows = self.driver.execute_script("""return [...document.querySelectorAll("#bench-figures tr")].slice(1)
            .map((row) => [...row.children].map((cell) => cell.textContent))""")
        return {label: (before, now) for label, before, now in rows}

    def command(self):
        return self.text("#bench-command")

    def failure(self):
        return "" if self.is_hidden("#bench-failure") else self.text("#bench-failure p")
