"""The state in the address: opening links, errors of broken ones, and back and forward."""
import base64
import json
import unittest
import zlib

import browser
import native


VIEW = (380, 150)  # in the camera's view, away from handles and objects


def fragment_of(data):
    return "#1" + base64.urlsafe_b64encode(data).rstrip(b"=").decode()


def packed(text):
    return fragment_of(zlib.compress(text.encode()))


BOMB = zlib.compress(b"[" * 20_000_000, 9)
BROKEN = {
    "cut off": lambda: native.fragment("teapot")[:-12],
    "damaged": lambda: native.fragment("teapot")[:20] + "AAAA" + native.fragment("teapot")[24:],
    "of another version": lambda: "#9" + native.fragment("teapot")[2:],
    "no base64": lambda: "#1%%%<script>alert(1)</script>",
    "no JSON": lambda: packed("not JSON"),
    "of a wrong type": lambda: packed('{"camera": {"position": "here"}}'),
    "of a field that does not exist": lambda: packed('{"camera": {"positon": [1, 2, 3]}}'),
    "out of range": lambda: packed('{"projection": {"near": -1}}'),
    "nested a million deep": lambda: packed("[" * 1_000_000),
    "20 MB unpacked": lambda: fragment_of(BOMB),
    "a file outside": lambda: packed('{"scene": "../../etc/passwd"}'),
    "a preset that does not exist": lambda: "#preset=teapott",
    "a preset with a path": lambda: "#preset=../scenes/teapot",
    "a lesson that does not exist": lambda: "#lesson=lenses",
    "a step that does not exist": lambda: "#lesson=lens&step=99",
    "a step that is no number": lambda: "#lesson=lens&step=two",
    "a step too large for any number": lambda: "#lesson=lens&step=99999999999999999999999",
    "a mark alone": lambda: "#1",
    "a word": lambda: "#somewhere",
}


class Links(browser.Test):
    def test_a_printed_link_opens_the_same_state(self):
        self.page.open(native.fragment("teapot", "--set", "camera.position=[1,2,3]", "--set", "shadow.opacity=0.25"))
        self.assertEqual(self.page.field("camera.position"), [1, 2, 3])
        self.assertEqual(self.page.field("shadow.opacity"), 0.25)
        self.assertEqual(self.page.field("scene"), native.state("teapot")["scene"])

    def test_broken_links_show_the_opening_state_and_a_sentence(self):
        self.page.open()
        opening, silence = self.page.state(), self.page.told()
        for what, made in BROKEN.items():
            with self.subTest(what):
                self.page.open(made())
                self.assertEqual(self.page.state(), opening)
                said = self.page.told().replace(silence, "").strip()
                self.assertRegex(said, r"^\S.{10,}", "no sentence")
                self.assertNotIn("\n", said, "more than one sentence")
                self.assertEqual(self.page.notice(), "")
                self.assertEqual(self.page.complaints(), [])

    def test_a_broken_link_keeps_the_open_state(self):
        self.page.open("#preset=teapot")
        before = self.page.state()
        self.page.go_to("#1broken")
        self.assertEqual(self.page.state(), before)

    def test_back_and_forward_visit_opened_states(self):
        self.page.open("#preset=teapot")
        self.page.go_to("#preset=curved")
        self.page.drag(VIEW, (VIEW[0] + 60, VIEW[1] + 10))  # looking around adds no history entry
        self.page.settle(0.8)  # the address follows half a second later
        self.assertRegex(self.page.address(), "^#1")
        self.page.go_to("#preset=room")
        self.page.travel(-1)
        self.assertEqual(self.page.field("scene"), native.state("curved")["scene"])
        self.page.travel(-1)
        self.assertEqual(self.page.opened(), "#preset=teapot")
        self.assertEqual(self.page.field("scene"), native.state("teapot")["scene"])
        self.page.travel(1)
        self.page.travel(1)
        self.assertEqual(self.page.opened(), "#preset=room")

    def test_a_link_typed_as_the_page_comes_to_rest_is_opened(self):
        self.page.open("#preset=teapot")
        self.page.js("""(() => {
            const later = window.setTimeout;
            window.setTimeout = (call, ms, ...more) => ms === 500 ? (window.rest = call, 0) : later(call, ms, ...more);
        })()""")
        self.page.ask("page_set", "view.samples=0")
        self.page.settle()
        self.page.js("(location.hash = '#preset=room', window.rest())")  # before the browser reports the new address
        self.page.settle()
        self.assertEqual(self.page.opened(), "#preset=room")
        self.assertEqual(self.page.address(), "#preset=room")

    def test_a_reload_restores_the_state(self):
        self.page.open("#preset=teapot")
        self.page.drag(VIEW, (VIEW[0] + 60, VIEW[1] + 10))
        self.page.settle(0.8)
        before = self.page.state()
        self.assertNotEqual(before["camera"], native.state("teapot")["camera"])
        self.page.driver.refresh()
        self.page.settle()
        self.assertEqual(self.page.state(), before)

    def test_the_address_names_a_lesson_and_its_step(self):
        self.page.open("#lesson=lens&step=3")
        self.assertEqual(self.page.opened(), "#lesson=lens&step=3")
        self.page.key("PageDown")
        self.page.key("PageDown")
        self.assertEqual(self.page.opened(), "#lesson=lens&step=4")
        self.page.settle(0.8)
        self.assertEqual(self.page.address(), "#lesson=lens&step=4")
        self.page.open("#lesson=lens")
        self.assertEqual(self.page.opened(), "#lesson=lens&step=1")


if __name__ == "__main__":
    unittest.main()
