"""The page of `rgimp report` in a browser: test_report_browser.py RGIMP."""

import json
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import h5py
import numpy as np
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

COMMAND = Path(sys.argv.pop(1)).resolve()
CASE = Path(__file__).resolve().parents[1] / "support/breaking_block.toml"
IN_SPACE = ("dimension=3", "body[0].center=[0.0,0.0,0.0]", "body[0].size=[8e-3,12e-3,4e-3]",
            "flaw[0].center=[0.0,0.0,0.0]", "body[0].velocity=[0.0,0.0,0.0]")
PATIENCE = 30  # s, for what takes a moment
RED_PIXELS = """
const canvas = document.getElementById("specimen");
const copy = document.createElement("canvas");  // reading the page's own slows it, and warns
[copy.width, copy.height] = [canvas.width, canvas.height];
const pen = copy.getContext("2d", {willReadFrequently: true});
pen.drawImage(canvas, 0, 0);
const data = pen.getImageData(0, 0, canvas.width, canvas.height).data;
let count = 0;
for (let at = 0; at < data.length; at += 4) count += data[at] === 0xc0 && data[at + 1] === 0x0d;
return count;
"""


def start_browser():
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                     "--window-size=1000,900"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(options=options, service=Service("/usr/bin/chromedriver"))


class PageTest(unittest.TestCase):
    changes = ()  # of the case

    @classmethod
    def setUpClass(cls):
        if cls is PageTest:
            raise unittest.SkipTest("what the two below share")
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.directory = Path(place.name) / "run"
        sets = [word for change in cls.changes for word in ("--set", change)]
        for words in (["run", CASE, "-o", cls.directory, "--quiet", "--threads", "2", *sets],
                      ["report", cls.directory]):
            subprocess.run([COMMAND, *words], check=True, timeout=300, stdout=subprocess.DEVNULL)
        with h5py.File(cls.directory / "snapshots/step_000000300.vtkhdf") as file:
            data = file["VTKHDF/PointData"]
            cls.failure_steps = data["failure_step"][data["failed"][()] == 1]
        cls.browser = start_browser()
        cls.addClassCleanup(cls.browser.quit)

    def setUp(self):
        self.browser.set_window_size(1000, 900)
        self.browser.get((self.directory / "report.html").as_uri())

    def tearDown(self):
        self.assertEqual(self.browser.get_log("browser"), [])
        for entry in self.browser.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                self.assertRegex(message["params"]["request"]["url"], "^(file|data):")

    def text(self, name):
        return self.browser.find_element(By.ID, name).text

    def number(self, name):
        return int(self.text(name).replace(",", ""))

    def press(self, *keys):
        self.browser.find_element(By.ID, "slider").send_keys(*keys)

    def wait_for(self, condition):
        end = time.monotonic() + PATIENCE
        while not condition():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)

    def check_slider(self):
        self.assertEqual(self.number("step"), 300)
        self.assertEqual(self.number("tension"), len(self.failure_steps))
        self.assertGreater(len(self.failure_steps), 20)
        self.assertGreater(self.browser.execute_script(RED_PIXELS), 0)
        self.press(Keys.HOME)
        self.assertEqual((self.number("step"), self.number("tension")), (0, 0))
        self.assertEqual(self.browser.execute_script(RED_PIXELS), 0)
        self.press(Keys.END)
        seen = set()
        while self.number("step") > 0:
            self.press(*[Keys.ARROW_LEFT] * 6)
            step = self.number("step")
            self.assertEqual(self.number("tension"), int((self.failure_steps <= step).sum()), step)
            seen.add(self.number("tension"))
        self.assertGreater(len(seen), 3)

    def check_readout(self):
        """Of the curves, at the slider's step and where one points."""
        history = np.genfromtxt(self.directory / "history.csv", delimiter=",", names=True)
        legend = "#stress_closure .legend"
        for key, row in ((Keys.HOME, 0), (Keys.END, -1)):
            self.press(key)
            shown = self.browser.find_element(By.CSS_SELECTOR, legend).text.split("(MPa): ")[1]
            self.assertAlmostEqual(float(shown), history["axial_stress_Pa"][row] * 1e-6, 3)
        before = self.browser.find_element(By.CSS_SELECTOR, legend).text
        curve = self.browser.find_element(By.CSS_SELECTOR, "#stress_closure > svg")
        webdriver.ActionChains(self.browser).move_to_element_with_offset(curve, -200, 0).perform()
        self.wait_for(lambda: self.browser.find_element(By.CSS_SELECTOR, legend).text != before)

    def check_play(self):
        play = self.browser.find_element(By.ID, "play")
        play.send_keys(Keys.SPACE)
        self.assertEqual(play.text, "Pause")
        self.wait_for(lambda: 0 < self.number("step") < 300)
        play.click()
        self.assertEqual(play.text, "Play")

    def check_phone(self):
        self.browser.set_window_size(500, 900)  # the narrowest of a headless browser
        self.browser.refresh()
        wide = self.browser.execute_script(
            "const page = document.documentElement; return page.scrollWidth - page.clientWidth;")
        self.assertEqual(wide, 0)

    def check_pictures(self):
        pictures = self.browser.find_elements(By.TAG_NAME, "img")
        self.assertGreaterEqual(len(pictures), 3)
        for picture in pictures:
            self.assertIn("pulled block", picture.get_attribute("alt"))
            self.assertGreater(int(picture.get_attribute("naturalWidth")), 100)


class PlaneTest(PageTest):
    def test_page(self):
        self.check_slider()
        self.check_readout()
        self.check_play()
        self.check_phone()
        self.check_pictures()
        self.assertIn("first failure at ", self.text_of_cracks())

    def text_of_cracks(self):
        return self.browser.find_element(By.XPATH, "//section[@aria-labelledby='cracks']").text


class SpaceTest(PlaneTest):
    changes = IN_SPACE

    def test_page(self):
        self.check_slider()
        self.check_pictures()
        self.assertIn("Connected cracks at the end", self.text_of_cracks())

    def test_turning(self):
        before = self.browser.execute_script(RED_PIXELS)
        self.browser.find_element(By.ID, "turn").send_keys(Keys.HOME)
        self.assertNotEqual(self.browser.execute_script(RED_PIXELS), before)


if __name__ == "__main__":
    unittest.main()
