"""The page that `abbe preview` serves, in a real browser."""

import http.client
import os
import select
import signal
import subprocess
import time
import unittest
from urllib.parse import urlsplit

from program import ABBE, SCENE, BrowserDesk
from webdriver import Browser


class Preview:
    """A preview that runs until its `with` block ends."""

    def __init__(self, folder, *arguments):
        self.program = subprocess.Popen([ABBE, "preview", *arguments], cwd=folder, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        if not select.select([self.program.stdout], [], [], 30)[0]:
            self.program.kill()
            raise AssertionError("it tells no address")
        line = self.program.stdout.readline()
        self.address = line.split()[-1]
        self.place = urlsplit(self.address)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    def stop(self):
        """Ends it as Ctrl-C does, and returns its exit code."""
        if self.program.returncode is None:
            self.program.send_signal(signal.SIGINT)
            self.program.communicate(timeout=20)
        return self.program.returncode

    def ask(self, method, path, **headers):
        """The status of an answer and its bytes, as a program gets them that is no browser."""
        connection = http.client.HTTPConnection("127.0.0.1", self.place.port, timeout=10)
        connection.request(method, path, headers=headers)
        answer = connection.getresponse()
        body = answer.read()
        connection.close()
        return answer.status, body


class PreviewPage(BrowserDesk):
    def setUp(self):
        super().setUp()
        self.write("scene.sdl", SCENE + "include card.sdl\n")
        self.write("card.sdl", "")

    def complaints(self):
        # A page asks on when its preview has ended with its test.
        return [message for message in super().complaints() if "net::ERR_CONNECTION" not in message]

    def preview(self, *arguments):
        return Preview(self.folder, "scene.sdl", "--spp", "8", *arguments)

    def open(self, preview):
        self.browser.open(preview.address)
        self.done()

    def done(self):
        self.browser.wait("return document.body.dataset.state === 'done' && document.body.dataset.latest == state.shown")

    def renderings(self):
        return int(self.browser.run("return document.body.dataset.renderings"))

    def again(self, act):
        """Does what makes it render anew, and waits until that is done."""
        before = self.renderings()
        act()
        self.browser.wait(f"return document.body.dataset.renderings > {before}")
        self.done()

    def color(self, x=0.2, y=0.5):
        """Linear sRGB at a place of the picture."""
        return self.browser.run(
            "const p = state.picture, i = 3 * (Math.floor(arguments[1] * p.height) * p.width + Math.floor(arguments[0] * p.width));"
            "return Array.from(p.values.slice(i, i + 3))", x, y)

    def test_saving_a_scene_changes_the_picture(self):
        with self.preview() as preview:
            self.open(preview)
            red, _, blue = self.color()
            self.again(lambda: self.write("scene.sdl", SCENE.replace("0.8 0.6 0.3", "0.3 0.6 0.8")))
            # The card was 0.8 0.6 0.3: under the same light blue gains on red by (0.8 / 0.3)^2, 7.1.
            then_red, _, then_blue = self.color()
            self.assertAlmostEqual(then_blue / then_red / (blue / red), 7.1, delta=1.5)
            told = self.browser.text("#told")
            for word in ("8 samples a pixel", "noise", "million rays/s", "first picture after"):
                self.assertIn(word, told)

    def test_a_file_that_it_includes_and_one_that_replaces_it(self):
        with self.preview() as preview:
            self.open(preview)
            self.again(lambda: self.write("card.sdl", "background 1 0 0\n"))
            self.assertGreater(self.color(0.01, 0.01)[0], 0.5)
            self.write("new.sdl", "background 0 0 1\n")  # as editors save
            self.again(lambda: os.replace(self.path("new.sdl"), self.path("card.sdl")))
            self.assertGreater(self.color(0.01, 0.01)[2], 0.5)

    def test_a_broken_scene_shows_its_mistake_and_the_last_picture(self):
        with self.preview() as preview:
            self.open(preview)
            before = self.color()
            self.write("scene.sdl", SCENE + "glass N-BK77\n")
            self.browser.wait("return document.body.dataset.state === 'error'")
            line = SCENE.count("\n") + 1
            self.assertEqual(self.browser.text("#error-place"), f"scene.sdl:{line}:7")
            self.assertIn("N-BK7", self.browser.text("#error-text"))
            self.assertTrue(self.browser.run("return document.querySelector('#error').checkVisibility()"))
            self.assertEqual(self.color(), before)
            self.again(lambda: self.write("scene.sdl", SCENE))
            self.assertFalse(self.browser.run("return document.querySelector('#error').checkVisibility()"))

    def test_others_are_refused(self):
        with self.preview() as preview:
            root, port = preview.place.path, preview.place.port
            self.assertEqual(preview.ask("GET", root)[0], 200)
            self.assertEqual(preview.ask("GET", root + "status", Origin=f"http://127.0.0.1:{port}")[0], 200)
            self.assertEqual(preview.ask("GET", root + "status", Origin="https://example.org")[0], 403)
            self.assertEqual(preview.ask("POST", root + "wish?size=8x8", Origin="null")[0], 403)
            self.assertEqual(preview.ask("GET", root + "status", Host="example.org")[0], 403)
            self.assertEqual(preview.ask("GET", root + "status", Host=f"example.org:{port}")[0], 403)
            for path in ("/", "/status", "/" + "0" * 32 + "/", "/" + "0" * 32 + "/status", root[:-2] + "/status",
                         root + "scene.sdl", root + "../scene.sdl", root + "%2e%2e/scene.sdl", "/etc/passwd",
                         root + "/etc/passwd"):
                status, body = preview.ask("GET", path)
                self.assertEqual(status, 404, path)
                self.assertNotIn(b"imageSize", body)
            self.assertEqual(preview.ask("GET", root + "wish?size=8x8")[0], 404)  # wishes are posted
            status, body = preview.ask("POST", root + "wish?size=elephant")
            self.assertEqual(status, 400)
            self.assertIn(b"elephant", body)

    def test_a_page_from_elsewhere_gets_nothing(self):
        with self.preview() as preview:
            self.browser.open("data:text/html,<p>elsewhere")
            got = self.browser.run(
                "return fetch(arguments[0]).then(answer => answer.text(), error => 'refused')", preview.address + "status")
            self.assertEqual(got, "refused")
            self.browser.messages()  # the browser has told of it

    def test_only_this_machine_is_answered(self):
        with self.preview() as preview:
            with open("/proc/net/tcp", encoding="ascii") as table:
                mine = [row.split()[1] for row in table if row.split()[1].endswith(f":{preview.place.port:04X}")]
            self.assertIn(f"0100007F:{preview.place.port:04X}", mine)  # 127.0.0.1
            self.assertNotIn(f"00000000:{preview.place.port:04X}", mine)

    def test_a_closed_tab_and_a_stopped_server_leave_nothing(self):
        before = set(os.listdir(self.folder))
        preview = self.preview()
        with preview:
            self.open(preview)
            self.browser.open("about:blank")
            with Browser() as second:
                second.open(preview.address)
                second.wait("return document.body.dataset.state === 'done'")
            self.open(preview)
            self.again(lambda: self.write("scene.sdl", SCENE.replace("0.8 0.6 0.3", "0.3 0.6 0.8")))
            tasks = f"/proc/{preview.program.pid}/task"
            with open(f"{tasks}/{preview.program.pid}/children", encoding="ascii") as children:
                self.assertEqual(children.read(), "")
            began = time.monotonic()
            self.assertEqual(preview.stop(), 0)
            self.assertLess(time.monotonic() - began, 5)
        self.assertEqual(set(os.listdir(self.folder)), before)
        with self.assertRaises(ConnectionRefusedError):
            preview.ask("GET", "/")
        self.browser.wait("return document.body.dataset.state === 'lost'")
        self.browser.messages()

    def test_the_camera_turns_and_its_lines_are_told(self):
        with self.preview() as preview:
            self.open(preview)
            self.browser.run("document.querySelector('#screen').focus()")
            self.again(lambda: self.browser.type("#screen", "\ue014"))  # the right arrow: 5 degrees
            self.browser.click("#lines")
            lines = self.browser.text("#camera").splitlines()
            self.assertEqual([line.split()[0] for line in lines], ["eye", "lookAt", "up", "fieldOfView"])
            x, y, z = (float(word) for word in lines[0].split()[1:])
            self.assertAlmostEqual(x, -6 * 0.08715574, 6)  # sin 5 degrees
            self.assertAlmostEqual(z, 6 * 0.99619470, 6)
            # They are lines of a scene.
            self.write("moved.sdl", SCENE.replace("eye 0 0 6 fieldOfView 30", "\n".join(lines)))
            with Preview(self.folder, "moved.sdl", "--spp", "8") as other:
                here = self.color()
                self.open(other)
                self.assertEqual(self.color(), here)

    def test_a_click_focuses(self):
        with self.preview() as preview:
            self.open(preview)
            self.browser.run("const a = document.querySelector('#aperture'); a.value = '0.4'")
            self.again(lambda: self.browser.run("document.querySelector('#aperture').onchange()"))
            at = self.browser.run("const b = screen_.canvas.getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2].map(Math.round)")
            far = self.browser.run("const s = screen_.zoom * screen_.canvas.getBoundingClientRect().width / screen_.canvas.width;"
                                   "return Math.round(12 * s)")
            self.again(lambda: self.browser.drag([at[0] - far, at[1]], [at[0] - far, at[1]]))
            self.browser.click("#lines")
            lines = dict(line.split(" ", 1) for line in self.browser.text("#camera").splitlines())
            self.assertEqual(lines["aperture"], "0.4")
            self.assertAlmostEqual(float(lines["focusDistance"]), 6.0, 6)  # the card

    def test_size_layer_region_and_integrator(self):
        choose = "const s = document.querySelector('#' + arguments[0]); s.value = arguments[1]; s.onchange()"
        with self.preview() as preview:
            self.open(preview)
            self.again(lambda: self.browser.run(choose, "size", "0.5"))
            self.assertEqual(self.browser.run("return [state.picture.frameWidth, state.picture.frameHeight]"), [24, 18])
            self.again(lambda: self.browser.run("setRegion('4,2,12,10')"))
            self.assertEqual(self.browser.run("return [state.picture.width, state.picture.height]"), [8, 8])
            self.again(lambda: self.browser.click("#whole"))
            self.again(lambda: self.browser.run(choose, "layer", "depth"))
            self.assertEqual(self.browser.run("return state.picture.channels"), 1)
            self.again(lambda: self.browser.run(choose, "layer", ""))
            self.again(lambda: self.browser.run(choose, "integrator", "whitted"))

    def test_what_is_not_rendered_yet_shows_the_coarse_picture(self):
        with Preview(self.folder, "scene.sdl", "--spp", "256", "--size", "640x480") as preview:
            self.browser.open(preview.address)
            self.browser.wait("return document.body.dataset.picture >= 2 && state.picture.frameWidth === 640")
            for y in (0.2, 0.4, 0.6, 0.8):  # from the card's upper edge to its lower one
                self.assertGreater(self.color(0.2, y)[0], 0.01)

    def test_narrow_and_dark(self):
        self.browser.size(400, 800)
        self.browser.media(prefers_color_scheme="dark")
        with self.preview() as preview:
            self.open(preview)
            self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), 400)
            red = self.browser.run("return Number(getComputedStyle(document.body).backgroundColor.match(/[0-9]+/)[0])")
            self.assertLess(red, 60)


if __name__ == "__main__":
    unittest.main()
