"""Runs abbe for the tests of its pages."""

import os
import subprocess
import tempfile
import unittest

from webdriver import Browser

ABBE = os.environ["ABBE"]  # the program; tests/browser/run sets it

# A card under two lamps, and a prism that colours a part of it.
SCENE = """imageSize 48 36 bands 81 eye 0 0 6 fieldOfView 30 integrator path falloff none
lightGroup key light D65 2 3 5 1
lightGroup fill light A -4 1 4 1
defaultMaterials diffuse 0.8 0.6 0.3
push scale 1.6 1.2 1 square pop
glass N-SF11 push translate 0.2 0 1.2 scale 0.5 0.5 0.5 sphere pop
"""


def abbe(folder, *arguments):
    """What the program says on standard output; it must end with 0."""
    done = subprocess.run([ABBE, *arguments], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"abbe {' '.join(arguments)}: {done.returncode}\n{done.stderr}")
    return done.stdout


class Desk(unittest.TestCase):
    """Tests with a folder of their own."""

    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory(prefix="abbe-pages-")
        cls.folder = cls.place.name

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name)

    @classmethod
    def write(cls, name, text):
        with open(cls.path(name), "w", encoding="utf-8") as out:
            out.write(text)


class BrowserDesk(Desk):
    """The same with a browser, whose window each test finds at its usual size, and without complaints."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        super().tearDownClass()

    def setUp(self):
        self.browser.size(1280, 900)
        self.browser.media()

    def complaints(self):
        """What the page has complained of since the last call."""
        return self.browser.messages()

    def tearDown(self):
        self.assertEqual(self.complaints(), [])
