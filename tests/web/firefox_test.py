"""The page in another browser: Firefox opens it, draws presets like the desktop program, and accepts a key."""
import base64
import json
import shutil
import unittest

from PIL import Image

import browser
import firefox
import native

BEYOND = 8, 0.01  # another driver's antialiasing: at most this share of pixels differs by more than 8 levels

OPEN = """
const [fragment, done] = arguments;
// A preset is opened under its name, and a state is the page's own link.
const is_open = () => [Module._page_opened(), Module._page_link()].some((text) => UTF8ToString(text) === fragment);
const look = (turns) => is_open() || turns > 500 ? done() : setTimeout(look, 20, turns + 1);
location.hash = fragment;
look(0);
"""
SETTLE = """
const [done] = arguments;
const look = (times) => {
  const is_there = typeof Module !== 'undefined' && Module.calledRun && Module._page_is_open && Module._page_is_open();
  if (times > 10) done('');
  else setTimeout(look, 50, is_there && Module._page_rests() ? times + 1 : 0);
};
look(0);
"""
# Inserted into the page, since timers of Marionette's scripts end with the call.
TURNS = "var turns = 0; (function turn() { ++turns; setTimeout(turn); })();"
PICTURE = """(() => {
  const picture = page.ask('page_picture', 'camera', 0, 0, -1);
  const bytes = FS.readFile(picture), parts = [];
  for (let i = 0; i < bytes.length; i += 32768) parts.push(String.fromCharCode(...bytes.subarray(i, i + 32768)));
  return btoa(parts.join(''));
})()"""


@unittest.skipUnless(shutil.which("firefox-esr") and shutil.which("Xvfb"), "firefox-esr or xvfb is not installed here")
class Firefox(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = browser.Server(browser.FOLDER)
        cls.addClassCleanup(cls.server.close)
        cls.firefox = firefox.Firefox()
        cls.addClassCleanup(cls.firefox.close)
        cls.firefox.go_to(cls.server.address)
        if not cls.firefox.js("document.createElement('canvas').getContext('webgl2') !== null"):
            raise unittest.SkipTest("Firefox gives no WebGL 2 here")
        cls.firefox.wait(SETTLE)

    def test_presets_match_the_desktop_program(self):
        for name in ("teapot", "curved", "mirrors-facing"):
            with self.subTest(name):
                self.firefox.wait(OPEN, f"#preset={name}")
                self.firefox.wait(SETTLE)
                self.assertEqual(self.firefox.js("UTF8ToString(Module._page_opened())"), f"#preset={name}")
                self.assertEqual(self.firefox.js("UTF8ToString(Module._page_link())"), native.fragment(name))
                self.firefox.js("page.ask('page_set', 'view.samples=0')")
                self.firefox.wait(SETTLE)
                self.assertEqual(self.firefox.js("GLctx.getError()"), 0)
                file = self.firefox.home / "drawn.png"
                file.write_bytes(base64.b64decode(self.firefox.js(PICTURE)))
                drawn = Image.open(file).convert("RGB")
                expected = native.camera(file, drawn.size, self.firefox.home / "expected.png")
                levels, share = BEYOND
                self.assertLessEqual(native.share_beyond(levels, drawn, expected), share)

    def test_a_key_flies(self):
        before = json.loads(self.firefox.js("UTF8ToString(Module._page_state())"))["camera"]
        actions = [{"type": "key", "id": "keys", "actions": [
            {"type": "keyDown", "value": "w"}, {"type": "pause", "duration": 400}, {"type": "keyUp", "value": "w"}]}]
        self.firefox.call("WebDriver:PerformActions", actions=actions)
        self.firefox.wait(SETTLE)
        after = json.loads(self.firefox.js("UTF8ToString(Module._page_state())"))["camera"]
        self.assertNotEqual(after["position"], before["position"])

    def test_long_work_continues_between_frames(self):
        self.firefox.wait(OPEN, native.fragment("cyclic-overlap", "--set", "view.lower_left=growth"))
        self.firefox.wait(SETTLE)
        self.firefox.js("Module._page_note_places()")
        self.firefox.wait(SETTLE)
        places = json.loads(self.firefox.js("UTF8ToString(Module._page_places())"))
        left, top, width, height = next(box for name, box in places.items() if name.endswith("/Measure"))
        self.firefox.js(f"document.head.append(Object.assign(document.createElement('script'), {{text: {json.dumps(TURNS)}}}))")
        self.firefox.call("WebDriver:PerformActions", actions=[{"type": "pointer", "id": "mouse", "actions": [
            {"type": "pointerMove", "x": round(left + width / 2), "y": round(top + height / 2)}, {"type": "pause", "duration": 200},
            {"type": "pointerDown", "button": 0}, {"type": "pause", "duration": 100}, {"type": "pointerUp", "button": 0},
            {"type": "pause", "duration": 500}]}])
        self.assertEqual(self.firefox.js("Module._page_rests()"), 0, "the measurement is running")
        before = self.firefox.js("turns")
        self.firefox.wait(SETTLE)
        self.assertGreater(self.firefox.js("turns"), before + 20)
        self.assertNotIn("froze", self.firefox.js("UTF8ToString(Module._page_told())"))


if __name__ == "__main__":
    unittest.main()
