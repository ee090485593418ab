#!/usr/bin/python3
"""Opens a report in a browser without a screen and without network, and uses it as a reader would.

    tests/report/browser.py PROGRAM REPORT_SCRIPT SCENE WORK_FOLDER

Needs Debian's chromium, chromium-driver, python3-selenium and python3-plotly (scripts/test_extra.sh).
"""
import csv
import os
import subprocess
import sys
import unittest

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select, WebDriverWait

PROGRAM = SCRIPT = SCENE = WORK = None


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folders = []
        for name, friction in (("rough", .3), ("slippery", .05)):
            folders.append(os.path.join(WORK, name))
            subprocess.run([PROGRAM, SCENE, "--quiet", "--output", folders[-1], "--set", f"Tools/punch/Friction coefficient={friction}",
                            "--set", "Output/Travels=.5, 1", "--set", "Tools/holder/Force=2"], check=True)
        with open(os.path.join(folders[0], "fld.csv"), "w", encoding="utf-8") as file:
            file.write("# forming limit of a scene, logarithmic strains\nminor_strain,major_strain\n-.2,.5\n0,.3\n.3,.35\n")
        cls.path = os.path.join(WORK, "two.html")
        subprocess.run([sys.executable, SCRIPT, *folders, "--file", cls.path], check=True)
        options = Options()
        for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=1500,1000",
                     "--host-resolver-rules=MAP * ~NOTFOUND", f"--user-data-dir={os.path.join(WORK, 'profile')}"):
            options.add_argument(word)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        cls.browser = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        cls.browser.get("file://" + cls.path)
        WebDriverWait(cls.browser, 60).until(lambda browser: browser.find_elements(By.CSS_SELECTOR, "body[data-ready]"))

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()

    def tearDown(self):
        """Nothing is complained of, nothing was fetched."""
        said = [entry for entry in self.browser.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]
        self.assertEqual(said, [])
        requests = [entry["message"] for entry in self.browser.get_log("performance") if "Network.requestWillBeSent\"" in entry["message"]]
        self.assertFalse([text for text in requests if "http://" in text.split('"url":')[1][:12] or "https://" in text.split('"url":')[1][:12]])

    def js(self, words, *values):
        return self.browser.execute_script("return " + words, *values)

    def slide(self, number):
        self.browser.execute_script("const s = document.getElementById('film-slider'); s.value = arguments[0]; s.dispatchEvent(new Event('input'));", number)

    def picture(self):
        """The paths that are drawn in the film."""
        return self.js("[...document.querySelectorAll('#film .scatterlayer path')].map(p => p.getAttribute('d')).join('|')")

    def test_it_is_small_enough(self):
        self.assertLess(os.path.getsize(self.path), 8e6)

    def test_every_chart_is_drawn(self):
        for chart in ("film", "force", "profile", "contact", "strains", "energy", "cost", "timing"):
            self.assertGreater(self.js("document.querySelectorAll(`#${arguments[0]} .trace path, #${arguments[0]} .point path`).length", chart), 1, chart)
        self.browser.save_screenshot(os.path.join(WORK, "top.png"))
        self.browser.execute_script("document.getElementById('energy').scrollIntoView()")
        self.browser.save_screenshot(os.path.join(WORK, "middle.png"))

    def test_the_slider_moves_the_film(self):
        self.slide(20)
        end, label = self.picture(), self.browser.find_element(By.ID, "film-label").text
        self.assertIn("punch 1 in", label)
        self.slide(5)
        self.assertNotEqual(self.picture(), end)
        self.assertIn("time 0.2", self.browser.find_element(By.ID, "film-label").text)
        # The depth of the pole is the travel: the lowest point of the blank, half a thickness below its middle.
        lowest = self.js("Math.min(...document.getElementById('film').data.flatMap(t => t.fill === 'toself' ? t.y : []).filter(y => y !== null))")
        self.assertAlmostEqual(lowest, -.25, delta=.035)
        line = self.js("document.getElementById('force').layout.shapes[0].x0")
        self.assertAlmostEqual(line, .25, delta=.02)
        self.slide(20)
        self.assertEqual(self.picture(), end)

    def test_play_goes_to_the_end(self):
        self.slide(18)
        self.browser.find_element(By.ID, "film-play").click()
        WebDriverWait(self.browser, 20).until(lambda browser: browser.find_element(By.ID, "film-play").text == "play")
        self.assertEqual(self.js("document.getElementById('film-slider').value"), "20")

    def test_colours_by_any_field(self):
        select = Select(self.browser.find_element(By.ID, "film-field"))
        fields = [option.text for option in select.options]
        self.assertIn("penetration over delta", fields)
        self.assertIn("stress von mises [tonf/in^2]", fields)
        seen = set()
        for field in fields:
            select.select_by_visible_text(field)
            seen.add(self.js("document.getElementById('film').data.find(t => t.marker && t.marker.colorbar).marker.colorbar.title.text"))
        self.assertEqual(seen, set(fields))
        select.select_by_visible_text("equivalent plastic strain")

    def test_another_run(self):
        before = self.picture()
        Select(self.browser.find_element(By.ID, "film-run")).select_by_visible_text("slippery")
        self.assertNotEqual(self.picture(), before)
        Select(self.browser.find_element(By.ID, "film-run")).select_by_visible_text("rough")
        self.assertEqual(self.picture(), before)

    def test_zoom_stays_while_the_film_moves(self):
        width = "const [a, b] = document.getElementById('film').layout.xaxis.range; return b - a"
        before = self.browser.execute_script(width)
        self.browser.execute_script("window.scrollTo(0, 0)")
        film = ScrollOrigin.from_element(self.browser.find_element(By.CSS_SELECTOR, "#film .nsewdrag"))
        for _ in range(6):  # a tenth each
            ActionChains(self.browser).scroll_from_origin(film, 0, -100).perform()
        WebDriverWait(self.browser, 10).until(lambda browser: browser.execute_script(width) < .8 * before)
        WebDriverWait(self.browser, 10).until(lambda browser: browser.execute_script(width) == browser.execute_async_script(
            "const end = arguments[0]; setTimeout(() => { " + width.replace("return b - a", "end(b - a)") + " }, 300)"))
        zoomed = self.browser.execute_script(width)
        self.slide(10)
        self.assertAlmostEqual(self.browser.execute_script(width), zoomed, delta=.01 * before)
        self.slide(20)
        self.browser.find_element(By.ID, "film-whole").click()
        self.assertAlmostEqual(self.browser.execute_script(width), before, delta=.1 * before)

    def test_both_halves(self):
        box = self.browser.find_element(By.ID, "film-mirror")
        box.click()
        self.assertLess(self.js("Math.min(...document.getElementById('film').data.flatMap(t => t.fill === 'toself' ? t.x : []))"), -1.5)
        box.click()

    def test_paths_of_strain(self):
        with open(os.path.join(WORK, "rough", "profile_1.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        pairs = [sorted((float(row["eps_meridional"]), float(row["eps_hoop"]))) for row in rows]
        nodes = self.js("document.getElementById('strains').data.find(t => t.name === 'nodes at the end')")
        self.assertEqual([list(pair) for pair in zip(nodes["x"], nodes["y"])], pairs)
        paths = self.js("document.getElementById('strains').data.filter(t => t.name === 'path').map(t => [t.x.length, t.y.at(-1)])")
        self.assertEqual({length for length, _ in paths}, {3})  # from nothing over .5 in to 1 in
        self.assertIn(max(major for _, major in pairs), [last for _, last in paths])
        self.assertEqual(self.js("document.getElementById('strains').data.find(t => t.name === 'forming limit').y"), [.5, .3, .35])
        self.browser.execute_script("document.getElementById('strains').scrollIntoView()")
        self.browser.save_screenshot(os.path.join(WORK, "strains.png"))
        Select(self.browser.find_element(By.ID, "strains-run")).select_by_visible_text("slippery")
        self.assertIsNone(self.js("document.getElementById('strains').data.find(t => t.name === 'forming limit') ?? null"))
        Select(self.browser.find_element(By.ID, "strains-run")).select_by_visible_text("rough")

    def test_what_differs_is_shown(self):
        rows = self.browser.find_elements(By.CSS_SELECTOR, "#scene tr.differs")
        self.assertEqual([row.text for row in rows], ["Tools/punch/Friction coefficient 0.3 0.05"])
        self.browser.find_element(By.ID, "scene-differs").click()
        self.assertGreater(len(self.browser.find_elements(By.CSS_SELECTOR, "#scene tr")), 50)
        self.browser.find_element(By.ID, "scene-search").send_keys("Profile radius")
        self.assertEqual(len(self.browser.find_elements(By.CSS_SELECTOR, "#scene tr")), 2)
        self.browser.execute_script("document.getElementById('scene').scrollIntoView()")
        self.browser.save_screenshot(os.path.join(WORK, "end.png"))


if __name__ == "__main__":
    WORK, SCENE, SCRIPT, PROGRAM = (os.path.abspath(sys.argv.pop()) for _ in range(4))
    os.makedirs(WORK, exist_ok=True)
    unittest.main()
