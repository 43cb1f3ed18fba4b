"""Files in and out: dropped, chosen, downloaded; and data that the browser keeps between visits."""
import json
import unittest

import browser
import native

TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
VIEW = (380, 150)


class Files(browser.Test):
    def setUp(self):
        self.page.open()

    def file(self, name, text):
        path = self.page.home / name
        path.write_text(text, encoding="utf-8")
        return path

    # ---- in

    def test_a_state_is_dropped(self):
        state = native.state("teapot", "--set", "projection.near=0.25")
        self.page.drop(self.file("mine.json", json.dumps(state)))
        self.assertEqual(self.page.field("scene"), state["scene"])
        self.assertEqual(self.page.field("projection.near"), 0.25)

    def test_a_mesh_is_dropped(self):
        before = self.page.screen()
        self.page.drop(self.file("tetrahedron 네 면.obj", TETRAHEDRON))
        self.assertRegex(self.page.field("scene"), r"tetrahedron 네 면\.obj$")
        self.assertGreater(native.share_beyond(30, before, self.page.screen()), 0.01)

    def test_a_broken_file_is_reported_in_one_sentence(self):
        before, silence = self.page.state(), self.page.told()
        self.page.drop(self.file("broken.json", '{"camera": '))
        said = self.page.told().replace(silence, "").strip()
        self.assertIn("broken.json", said)
        self.assertNotIn("\n", said)
        self.assertEqual(self.page.state(), before)

    def test_a_file_is_chosen(self):
        self.page.js("document.getElementById('file').addEventListener('click', () => window.is_asked = true)")
        self.page.cdp("Page.setInterceptFileChooserDialog", enabled=True)
        self.page.click("top/File")
        self.page.click("Open…")
        self.page.until("the browser's file dialog", lambda: self.page.js("window.is_asked === true"))
        self.page.cdp("Page.setInterceptFileChooserDialog", enabled=False)
        path = self.file("chosen.json", json.dumps(native.state("curved")))
        self.page.driver.find_element("id", "file").send_keys(str(path))
        self.page.settle()
        self.assertEqual(self.page.field("scene"), native.state("curved")["scene"])

    # ---- out

    def test_a_snapshot_carries_its_state(self):
        self.page.open("#preset=teapot")
        self.page.mouse("mouseMoved", VIEW)
        self.page.key("F12")
        picture = self.page.downloaded("viewing-*.png")
        self.assertEqual(native.state(picture), self.page.state())

    def test_a_state_is_saved(self):
        self.page.mouse("mouseMoved", VIEW)
        self.page.key("KeyS", browser.CTRL)
        self.page.click("Save")
        self.assertEqual(native.state(self.page.downloaded("*.json")), self.page.state())

    def test_a_copied_link_leads_to_this_page(self):
        self.page.enter("projection/fovy", "55")
        self.page.click("top/File")
        self.page.click("Copy link")
        self.assertEqual(self.page.clipboard(), self.page.server.address + self.page.link())


class Kept(browser.Checked):
    """Data that survives closing the page: looks and progress, only in this browser."""

    def setUp(self):
        self.page = browser.Page()
        self.addCleanup(self.page.close)
        self.page.open()

    def test_theme_and_language_are_kept(self):
        self.page.click("top/Look")
        self.page.click("Light")
        self.page.click("한국어")
        self.page.key("Escape")
        self.page.settle(0.8)
        self.page.open()
        self.page.settle(0.8)
        looks = self.page.field("ui")
        self.assertEqual((looks["theme"], looks["language"]), ("light", "ko"))
        self.assertEqual(self.page.js("document.documentElement.lang"), "ko")

    def test_progress_in_a_lesson_is_kept(self):
        self.page.open("#lesson=lens")
        for _ in range(4):
            self.page.key("PageDown")
        self.assertEqual(self.page.opened(), "#lesson=lens&step=3")
        self.page.open()
        self.page.click("top/Lesson")
        self.page.click("card 3")
        self.assertEqual(self.page.opened(), "#lesson=lens&step=3")

    def test_nothing_is_kept_or_fetched_elsewhere(self):
        self.assertEqual(self.page.js("document.cookie"), "")
        places = self.page.js("performance.getEntriesByType('resource').map((entry) => entry.name)")
        self.assertEqual([place for place in places if not place.startswith((self.page.server.address, "data:", "blob:"))], [])


if __name__ == "__main__":
    unittest.main()
