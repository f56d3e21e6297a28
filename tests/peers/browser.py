"""A page of stageview in headless Chromium: keys, pointer, console, times of drawing. Used by judge_page.py and by the
benchmark page_drawing."""
import pathlib, time

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By


class Page:
    def __init__(self, path, size=(1400, 900)):
        """`path`: a file, or an address with http."""
        options = webdriver.ChromeOptions()
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"):
            options.add_argument(argument)
        options.add_argument(f"--window-size={size[0]},{size[1]}")
        options.binary_location = "/usr/bin/chromium"
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service("/usr/bin/chromedriver"))
        start = time.time()
        self.driver.get(path if path.startswith("http:") else pathlib.Path(path).resolve().as_uri())
        self.seconds_to_open = time.time() - start

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()

    def find(self, selector):
        """`selector`: of CSS, or an XPath that begins with a slash."""
        return self.driver.find_element(By.XPATH if selector.startswith("/") else By.CSS_SELECTOR, selector)

    def text(self, selector):
        return self.driver.execute_script("return document.querySelector(arguments[0]).textContent", selector)

    def is_hidden(self, selector):
        return self.driver.execute_script("return document.querySelector(arguments[0]).hidden", selector)

    def press(self, keys, pause=0.4):
        """Keys one by one; then a sharp picture has time to follow."""
        ActionChains(self.driver).send_keys(keys).perform()
        time.sleep(pause)

    def point_at_middle(self, dx=0, dy=0, canvas="#overlay"):
        ActionChains(self.driver).move_to_element_with_offset(self.find(canvas), dx, dy).perform()
        time.sleep(0.2)

    def drag(self, steps, dx, dy, canvas="#overlay"):
        """Moves the drawing with the pointer in many steps."""
        actions = ActionChains(self.driver, duration=16).move_to_element(self.find(canvas)).click_and_hold()
        for _ in range(steps):
            actions.move_by_offset(dx, dy)
        actions.release().perform()

    def picture(self, canvas):
        """The pixels of a canvas, to compare."""
        return self.driver.execute_script("return document.getElementById(arguments[0]).toDataURL()", canvas)

    def milliseconds(self, name):
        """How long every drawing of a kind took, "draw moved" or "draw sharp", since the last call."""
        script = """const found = performance.getEntriesByName(arguments[0]).map((entry) => entry.duration);
                    performance.clearMeasures(arguments[0]);
                    return found;"""
        return self.driver.execute_script(script, name)

    def record_frames(self):
        """Starts to record when the browser shows frames."""
        self.driver.execute_script("""const times = window.frameTimes = [];
                                      const note = (time) => { times.push(time); requestAnimationFrame(note); };
                                      requestAnimationFrame(note);""")

    def frames(self):
        """Milliseconds from each frame to the next since record_frames."""
        times = self.driver.execute_script("return window.frameTimes")
        return [after - before for before, after in zip(times, times[1:])]

    def messages(self):
        """What the browser's console shows."""
        return [entry["message"] for entry in self.driver.get_log("browser")]
