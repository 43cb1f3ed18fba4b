"""The page itself: its size, pixel ratio, rest, accessibility, loss of the picture; and the single file from a disk."""
import gzip
import unittest

import browser
import native

VIEW = (380, 150)
MOST_BYTES = 2_500_000  # compressed, of everything that a reader of English loads
KOREAN = ("NanumBarunGothic.ttf", "NanumBarunGothicBold.ttf")


class Page(browser.Test):
    def tearDown(self):
        self.page.resize((1280, 720))
        super().tearDown()

    def canvas(self):
        return tuple(self.page.js("[document.getElementById('view').width, document.getElementById('view').height]"))

    def fetched(self):
        return self.page.js("performance.getEntriesByType('resource').map((entry) => entry.name.split('/').pop())")

    def test_it_has_a_title_a_language_and_text_for_screen_readers(self):
        self.page.open("#preset=teapot")
        self.page.settle(0.8)
        self.assertRegex(self.page.driver.title, "Viewing")
        self.assertEqual(self.page.js("document.documentElement.lang"), "en")
        self.assertIn(native.state("teapot")["title"], self.page.js("document.getElementById('told').textContent"))
        matrices = self.page.js("document.getElementById('matrices').textContent")
        for name in "SRVP":
            self.assertRegex(matrices, rf"\b{name}\b")

    def test_it_rests(self):
        self.page.open()
        self.page.mouse("mouseMoved", (2, 2))
        self.page.settle(1.5)
        before = self.page.frames()
        self.page.driver.execute_async_script("setTimeout(arguments[0], 3000)")
        self.assertEqual(self.page.frames() - before, 0, "frames in three idle seconds")

    def test_it_follows_the_size_of_the_window(self):
        self.page.open()
        state = self.page.state()
        for size in ((1280, 720), (800, 600), (1024, 768), (844, 390), (1920, 1080)):
            with self.subTest(size):
                self.page.resize(size)
                self.page.settle()
                self.page.until(f"a canvas of {size}", lambda: self.canvas() == size)
                self.page.settle()
                self.assertEqual(self.page.screen().size, size)
                right = max(x + width for x, _, width, _ in self.page.places().values())
                self.assertLessEqual(right, size[0] + 1, "a control beyond the edge")
        self.assertEqual(self.page.state(), state)

    def test_it_supports_two_pixels_per_unit(self):
        self.page.open()
        at = self.page.place("projection/fovy")
        # The size also changes a little, because DevTools' emulation does not report a change of scale alone.
        self.page.resize((1270, 710), 2)
        self.page.until("a canvas of 2540×1420", lambda: self.canvas() == (2540, 1420))
        self.page.settle()
        there = self.page.place("projection/fovy")
        self.assertAlmostEqual(there[0], at[0], delta=12)
        self.assertAlmostEqual(there[1], at[1], delta=12)
        self.page.enter("projection/fovy", "55")
        self.assertEqual(self.page.field("projection.fovy"), 55)

    def test_with_reduced_motion_reveals_are_instant(self):
        self.page.cdp("Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": "reduce"}])
        self.addCleanup(self.page.cdp, "Emulation.setEmulatedMedia", features=[])
        self.page.open("#lesson=view-is-the-inverse")
        before = self.page.frames()
        self.page.key("PageDown")
        self.assertEqual(self.page.field("camera.position"), [0, 0.9, 10])
        self.assertLess(self.page.frames() - before, 15, "frames of a reveal that takes two seconds with motion")

    def test_a_lost_picture_is_reported_and_reloaded(self):
        self.page.open("#preset=teapot")
        self.page.enter("projection/fovy", "55")
        self.page.settle(0.8)
        state = self.page.state()
        self.page.js("GLctx.getExtension('WEBGL_lose_context').loseContext()")
        self.page.until("the notice", self.page.notice)
        self.assertRegex(self.page.notice(), r"^\S.{20,}\.$")
        button = self.page.driver.find_element("css selector", "#notice button")
        self.assertTrue(button.is_displayed())
        self.page.complaints()  # CONTEXT_LOST_WEBGL is expected
        button.click()
        self.page.until("the page again", lambda: self.page.js("typeof watched !== 'undefined' && watched.frames > 0 && Module.calledRun"))
        self.page.settle()
        self.assertEqual(self.page.notice(), "")
        self.assertEqual(self.page.state(), state)

    def test_it_is_small_and_fetches_korean_on_demand(self):
        self.page.open()
        self.assertEqual([name for name in self.fetched() if name in KOREAN], [])
        used = {"index.html", *self.fetched()} - {""}
        size = sum(len(gzip.compress((browser.FOLDER / name).read_bytes(), 9)) for name in used)
        print(f"gzipped: {size / 1e6:.2f} MB of {', '.join(sorted(used))}")
        self.assertLessEqual(size, MOST_BYTES)
        english = self.page.screen()
        self.page.open(native.fragment("opening", "--set", "ui.language=ko"))
        if self.page.field("ui.language") != "ko":  # a link does not carry the user's language
            self.page.ask("page_set", 'ui.language="ko"')
            self.page.settle()
        self.page.until("a Korean font", lambda: KOREAN[0] in self.fetched())
        self.page.settle(0.5)
        self.assertGreater(native.share_beyond(30, english, self.page.screen()), 0.005)


class SingleFile(browser.Checked):
    def setUp(self):
        self.page = browser.Page()
        self.addCleanup(self.page.close)
        self.address = (browser.FOLDER / "viewing-sandbox.html").resolve().as_uri()

    def test_it_opens_from_a_disk(self):
        self.page.open("#preset=teapot")
        expected = self.page.screen()
        self.page.open("#preset=teapot", self.address)
        self.assertEqual(self.page.field("scene"), native.state("teapot")["scene"])
        self.assertEqual(native.share_beyond(8, expected.crop((0, 40, 1280, 690)), self.page.screen().crop((0, 40, 1280, 690))), 0)
        self.page.drag(VIEW, (440, 160))
        self.assertNotEqual(self.page.state()["camera"], native.state("teapot")["camera"])

    def test_korean_works_from_a_disk(self):
        self.page.open("", self.address)
        self.page.click("top/Look")
        self.page.click("한국어")
        self.page.key("Escape")
        self.page.mouse("mouseMoved", (600, 704))  # a place where the pointer highlights nothing
        self.page.settle(0.5)
        korean = self.page.screen()
        self.assertEqual(self.page.field("ui.language"), "ko")
        self.page.open()
        self.page.ask("page_set", 'ui.language="ko"')
        self.page.settle(1)
        self.assertEqual(native.share_beyond(8, korean.crop((0, 40, 300, 690)), self.page.screen().crop((0, 40, 300, 690))), 0)


if __name__ == "__main__":
    unittest.main()
