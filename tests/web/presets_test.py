"""Presets opened in one page: no console message, no GL error, the link that the desktop program prints, and the camera's
picture as that program draws it. With both of Chromium's software drivers: every second preset with one, every fourth
with the other; TEST_TURN=N says which, and TEST_ALL=1 takes all."""
import collections
import io
import os
import pathlib
import statistics
import tempfile
import unittest

from PIL import Image

import browser
import native

Threshold = collections.namedtuple("Threshold", "levels share reason", defaults=("",))

# Presets that never rest, because every frame is a different picture.
MOVING = {"fighting-jiggle"}

# With the same Mesa as the desktop program: in at most `share` of the pixels, a channel differs by more than `levels`.
USUAL = Threshold(2, 0.001)
# SwiftShader rasterizes differently, so edges fall on different pixels.
USUAL_ELSEWHERE = Threshold(8, 0.01)
LOOSER = {}  # none: the driver is the same
FIGHTS = Threshold(8, 0.1, "surfaces at equal depth: the last bit of the driver's interpolation decides which wins at a pixel")
STEP = Threshold(8, 0.04, "the unit of an offset is one step of the depth buffer here, two in Mesa")
LOOSER_ELSEWHERE = {
    "depth-fighting": FIGHTS, "fighting-divider": FIGHTS, "fighting-decals": FIGHTS, "fighting-decals-equal": FIGHTS,
    "shadow-fights": FIGHTS, "shadow-writes-depth": FIGHTS, "fighting-offset-too-little": STEP,
}


def shared_by(turns):
    """Returns the presets whose turn it is, or all with TEST_ALL=1."""
    if "TEST_ALL" in os.environ:
        return native.presets()
    return native.presets()[int(os.environ.get("TEST_TURN", 0)) % turns::turns]


class Presets(unittest.TestCase):
    driver, usual, looser = browser.MESA, USUAL, LOOSER

    @classmethod
    def setUpClass(cls):
        cls.page = browser.Page(cls.driver)
        cls.addClassCleanup(cls.page.close)
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)

    def test_presets_match_the_desktop_program(self):
        self.page.open()
        self.assertEqual(self.page.complaints(), [])
        shares = {}
        for name in self.names():
            with self.subTest(name):
                shares[name] = self.look_at(name)
            if native.state(name)["ui"]["theme"] != "dark":
                self.page.open()  # a preset's theme stays until another preset sets one, and is part of the link
        equal = sum(share == 0 for share in shares.values())
        worst = max(shares, key=shares.get)
        print(f"{self.driver}: {len(shares)} camera pictures, {equal} without a pixel beyond {self.usual.levels} levels; "
              f"the median {statistics.median(shares.values()):.4%}, the most in {worst}: {shares[worst]:.4%}")

    def names(self):
        return shared_by(2)

    def look_at(self, name):
        page = self.page
        page.open_link(f"#preset={name}")
        if name in MOVING:
            page.until(f"five frames of {name}", lambda at=page.frames(): page.frames() >= at + 5)
        else:
            page.settle()
        self.assertEqual(page.complaints(), [])
        self.assertEqual(page.opened(), "" if name == "opening" else f"#preset={name}")
        link = page.link()
        self.assertEqual(link, native.fragment(name), "the page's link")
        self.assertEqual(native.parameters(link), native.parameters(name), "what the link opens")
        return 0 if name in MOVING else self.share_of_camera(name)

    def share_of_camera(self, name):
        """Compares without multisampling, a user setting that persists across presets."""
        page = self.page
        page.ask("page_set", "view.samples=0")
        page.settle()
        data = page.camera()
        page.ask("page_set", "view.samples=4")
        self.assertEqual(page.complaints(), [])
        drawn = Image.open(io.BytesIO(data)).convert("RGB")
        file = self.folder / "drawn.png"
        file.write_bytes(data)
        expected = native.camera(file, drawn.size, self.folder / "expected.png")
        threshold = self.looser.get(name, self.usual)
        share = native.share_beyond(threshold.levels, drawn, expected)
        self.assertLessEqual(share, threshold.share, f"{name}: pixels beyond {threshold.levels} levels")
        return share


class PresetsElsewhere(Presets):
    driver, usual, looser = browser.SWIFTSHADER, USUAL_ELSEWHERE, LOOSER_ELSEWHERE

    def names(self):
        return shared_by(4)


if __name__ == "__main__":
    unittest.main()
