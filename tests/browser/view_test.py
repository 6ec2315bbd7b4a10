"""The page that `abbe view` writes, in a real browser."""

import csv
import io
import json
import unittest

from program import SCENE, BrowserDesk, abbe

PAINTED = "return document.body.dataset.painted"


class ViewPage(BrowserDesk):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.write("scene.sdl", SCENE)
        layers = ["--layers", "depth,variance,light:*", "-q"]
        abbe(cls.folder, "render", "scene.sdl", "-o", "a.exr", "--spectral", "a.cube.exr", "--spp", "8", *layers)
        abbe(cls.folder, "render", "scene.sdl", "-o", "b.exr", "--spp", "8", "--seed", "7", *layers)
        abbe(cls.folder, "view", "a.cube.exr", "a.exr", "b.exr", "-o", "page.html")

    def setUp(self):
        super().setUp()
        self.browser.open("file://" + self.path("page.html"))
        self.browser.wait("return document.body.dataset.ready")

    def tearDown(self):
        super().tearDown()
        self.assertEqual(self.browser.run("return performance.getEntriesByType('resource').length"), 0)

    def point_of(self, x, y):
        """Where the middle of a pixel lies in the window."""
        return self.browser.run(
            "const box = screen_.canvas.getBoundingClientRect(), scale = box.width / screen_.canvas.width;"
            "return [box.left + (screen_.left + (arguments[0] + 0.5) * screen_.zoom) * scale,"
            "        box.top + (screen_.top + (arguments[1] + 0.5) * screen_.zoom) * scale].map(Math.round)", x, y)

    def click_pixel(self, x, y):
        at = self.point_of(x, y)
        self.browser.drag(at, at)
        self.browser.wait(f"return document.querySelector('#place').textContent.startsWith('Pixel {x}, {y}')")

    def rows(self, table):
        return self.browser.run(
            "return Array.from(document.querySelectorAll(arguments[0] + ' tr'), row => Array.from(row.cells, c => c.textContent))",
            table)

    def numbers(self):
        return [[float(cell) for cell in row] for row in self.rows("#numbers")[1:]]

    def choose(self, select, value):
        self.browser.run("const s = document.querySelector(arguments[0]); s.value = arguments[1]; s.onchange()", select, value)

    def pixels(self):
        """A fingerprint of what the canvas shows."""
        return self.browser.run("screen_.marks = []; screen_.draw(); return screen_.canvas.toDataURL()")

    def repainted(self, act):
        before = self.browser.run(PAINTED)
        act()
        self.browser.wait(f"return document.body.dataset.painted !== '{before}'")

    def test_a_spectrum_equals_that_of_abbe_pixel(self):
        self.click_pixel(30, 14)
        told = json.loads(abbe(self.folder, "pixel", "a.cube.exr", "30", "14", "--json"))
        page = self.numbers()
        self.assertEqual(len(page), 81)
        most = max(told["values"])
        for (nm, value), right_nm, right in zip(page, told["nm"], told["values"]):
            self.assertAlmostEqual(nm, right_nm, 3)
            # Half a step of 16 bits, and the six digits that the page tells.
            self.assertAlmostEqual(value, right, delta=most / 131070 * 1.01 + 5e-6 * abs(right))
        facts = dict(self.rows("#facts"))
        for name, key, error in (("X Y Z", "XYZ", 2e-5), ("x y", "xy", 2e-5), ("L* a* b*", "Lab", 3e-3)):
            for value, right in zip(facts[name].split(), told[key]):
                self.assertAlmostEqual(float(value), right, delta=error, msg=name)
        self.assertAlmostEqual(float(facts["dominant wavelength"].split()[0]), told["dominant_nm"], delta=0.02)

    def test_a_region_equals_that_of_abbe_region(self):
        self.browser.drag(self.point_of(10, 8), self.point_of(19, 13))
        self.browser.wait("return document.querySelector('#place').textContent === 'Region 10, 8 to 20, 14'")
        told = list(csv.reader(io.StringIO(abbe(self.folder, "region", "a.cube.exr", "10", "8", "20", "14", "--csv"))))[1:]
        for (_, mean, deviation), (_, right, right_deviation) in zip(self.numbers(), told):
            self.assertAlmostEqual(mean, float(right), delta=1e-5 + 1e-5 * float(right))
            self.assertAlmostEqual(deviation, float(right_deviation), delta=3e-5)

    def test_two_pixels_differ_as_abbe_pixel_says(self):
        self.click_pixel(30, 14)
        self.browser.click("#pin")
        self.click_pixel(12, 20)
        self.browser.wait("return document.querySelector('#facts').textContent.includes('CIEDE2000')")
        told = json.loads(abbe(self.folder, "pixel", "a.cube.exr", "12", "20", "--to", "30", "14", "--json"))
        self.assertAlmostEqual(float(dict((row[0], row[1]) for row in self.rows("#facts"))["CIEDE2000"]),
                               told["delta_e_2000"], delta=2e-3)

    def test_by_keyboard_alone(self):
        self.browser.run("document.querySelector('#screen').focus()")
        self.browser.type("#screen", "\ue014")  # the right arrow: first the middle, then on
        self.browser.wait("return document.querySelector('#place').textContent === 'Pixel 24, 18'")
        self.browser.type("#screen", "\ue014\ue014\ue015")
        self.browser.wait("return document.querySelector('#place').textContent === 'Pixel 26, 19'")
        self.repainted(lambda: self.browser.type("#screen", "."))
        self.assertEqual(self.browser.text("#band-nm"), "385 nm")
        self.repainted(lambda: self.browser.type("#screen", "]"))
        self.assertEqual(self.browser.text("#exposure-stops"), "+0.5 EV")
        self.browser.type("#screen", "c")
        self.browser.wait("return document.querySelector('#facts').textContent.includes('CIEDE2000')")
        # Every control can be reached, and says what it is.
        unnamed = self.browser.run(
            "return Array.from(document.querySelectorAll('button, select, input')).filter(e =>"
            " !e.closest('label') && !e.textContent.trim() && !e.ariaLabel).length")
        self.assertEqual(unnamed, 0)

    def test_narrow_and_dark(self):
        self.browser.size(400, 800)
        self.browser.media(prefers_color_scheme="dark")
        self.click_pixel(24, 18)
        self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), 400)
        light = "const [r, g, b] = getComputedStyle(document.body).arguments0.match(/[0-9]+/g).map(Number); return (r + g + b) / 3"
        self.assertLess(self.browser.run(light.replace("arguments0", "backgroundColor")), 60)
        self.assertGreater(self.browser.run(light.replace("arguments0", "color")), 190)

    def test_lights_are_switched(self):
        self.repainted(lambda: self.choose("#picture", "1"))
        whole = self.pixels()
        self.browser.wait("return document.querySelectorAll('#lights input[type=checkbox]').length === 2")
        self.repainted(lambda: self.browser.click("#light-0"))
        one = self.pixels()
        self.assertNotEqual(one, whole)
        # All lights together are the picture, but for what its half floats round.
        self.repainted(lambda: self.browser.click("#light-0"))
        off = self.browser.run("const a = state.lights.sum(), b = state.picture.colors;"
                               "return a.reduce((most, v, i) => Math.max(most, Math.abs(v - b[i]) / (b[i] + 1e-3)), 0)")
        self.assertLess(off, 1e-3)

    def test_two_files_are_compared(self):
        self.repainted(lambda: self.choose("#picture", "1"))
        self.repainted(lambda: self.choose("#other", "2"))
        wiped = self.pixels()
        self.repainted(lambda: self.choose("#compare", "delta"))
        self.assertNotEqual(self.pixels(), wiped)
        told = abbe(self.folder, "diff", "a.exr", "b.exr")
        mean = next(float(word) for line in told.splitlines() if "CIEDE2000" in line
                    for word in line.replace(",", " ").split() if word.replace(".", "", 1).isdigit())
        page = float(self.browser.text("#status").split("mean ")[1].split(",")[0])
        self.assertAlmostEqual(page, mean, delta=2e-3)

    def test_false_colours_and_layers(self):
        plain = self.pixels()
        self.repainted(lambda: self.browser.click("#false-color"))
        self.assertNotEqual(self.pixels(), plain)
        self.repainted(lambda: self.choose("#picture", "1"))
        self.repainted(lambda: self.choose("#layer", "depth"))
        # The ball's front is 4.3 from the eye and the card 6.
        low, high = self.browser.text("#status").split("from ")[1].split(" to ")
        self.assertAlmostEqual(float(low), 4.3, delta=0.02)
        self.assertAlmostEqual(float(high), 6.0, delta=0.001)


if __name__ == "__main__":
    unittest.main()
