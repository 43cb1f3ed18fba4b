"""The sandbox embedded in another page, which queries and sets values by messages."""
import base64
import io
import json
import pathlib
import re
import tempfile
import unittest

from PIL import Image

import browser
import native

HOST = """<!DOCTYPE html><title>Slides</title><link rel="icon" href="data:,"><style>body {{ margin: 0 }}</style>
<iframe id="sandbox" width="800" height="450" frameborder="0" src="{address}"></iframe><br>
<input id="note">
<script>
const said = [], pressed = [];
document.getElementById('note').focus();
document.addEventListener('keydown', (event) => pressed.push([event.code, event.keyCode]));
window.addEventListener('message', (event) => {{
  said.push(event.data);
  if (event.data.is !== 'ready') return;
  event.source.postMessage({{to: 'viewing-sandbox', id: 'first', get: 'state'}}, '*');
}});
const ask = (what) => new Promise((done) => {{
  const id = Math.random();
  const hear = ({{data}}) => {{
    if (data.id !== id) return;
    window.removeEventListener('message', hear);
    done(data);
  }};
  window.addEventListener('message', hear);
  document.getElementById('sandbox').contentWindow.postMessage({{to: 'viewing-sandbox', id, ...what}}, '*');
}});
</script>"""


class Host(browser.Test):
    """A page of another origin that embeds the sandbox."""
    fragment = "#embed&preset=teapot&matrices=V"
    def setUp(self):
        self.show(self.fragment)

    def show(self, fragment):
        host = self.page.home / "host.html"
        host.write_text(HOST.format(address=self.page.server.address + fragment), encoding="utf-8")
        self.page.driver.get(host.as_uri())
        self.page.until("the sandbox's greeting", lambda: self.page.js("said.some((data) => data.is === 'ready')"))
        self.rest()

    def inside(self, script, *values):
        """Evaluates an expression in the sandbox's own frame."""
        self.page.driver.switch_to.frame("sandbox")
        try:
            return self.page.js(script, *values)
        finally:
            self.page.driver.switch_to.default_content()

    def said(self, kind):
        return self.page.js("said.filter((data) => data.is === arguments[0])", kind)

    def ask(self, **what):
        return self.page.driver.execute_async_script("ask(arguments[0]).then(arguments[1])", what)

    def get(self, what, **more):
        reply = self.ask(get=what, **more)
        self.assertNotIn("error", reply)
        return reply["answer"]

    def rest(self):
        self.page.until("rest", lambda: self.get("rests"))
        self.page.driver.execute_async_script("setTimeout(arguments[0], 500)")
        self.page.until("rest", lambda: self.get("rests"))

    def picture(self, **how):
        head, data = self.get("picture", **how).split(",", 1)
        self.assertEqual(head, "data:image/png;base64")
        return base64.b64decode(data)


class Embedded(Host):
    def test_it_reports_its_state_matrices_and_link(self):
        state = self.get("state")
        self.assertEqual(state["scene"], native.state("teapot")["scene"])
        self.assertEqual(state["camera"], native.state("teapot")["camera"])
        told, expected = self.get("matrices"), json.loads(native.run("matrices", "teapot", "--format", "json"))
        self.assertEqual(told.keys(), expected.keys())
        for name in ("view_from_world", "shadow_from_world", "mirror_from_world"):
            for row, expected_row in zip(told[name], expected[name]):
                for number, expected_number in zip(row, expected_row):
                    self.assertAlmostEqual(number, expected_number, delta=1e-12, msg=name)
        self.assertRegex(self.get("link"), "^#1")

    def test_it_greets_when_the_addressed_state_is_shown(self):
        first = self.page.js("said.find((data) => data.id === 'first')")["answer"]
        self.assertEqual(first["scene"], native.state("teapot")["scene"])
        self.assertEqual(first["view"]["layout"]["matrices"], ["V"])

    def test_it_gives_its_picture(self):
        data = self.picture()
        file = self.page.home / "picture.png"
        file.write_bytes(data)
        self.assertEqual(native.state(file)["scene"], native.state("teapot")["scene"])
        self.assertGreater(len(Image.open(io.BytesIO(data)).convert("RGB").getcolors(1 << 24)), 100)
        self.assertEqual(Image.open(io.BytesIO(self.picture(view="window"))).size, (800, 450))
        self.assertEqual(Image.open(io.BytesIO(self.picture(view="depth", size=[320, 200]))).size, (320, 200))

    def test_fields_are_set(self):
        before = self.picture()
        reply = self.ask(set={"light.position": [1, 6, 2, 1], "projection.fovy": 60})
        self.assertNotIn("error", reply)
        self.rest()
        state = self.get("state")
        self.assertEqual(state["light"]["position"], [1, 6, 2, 1])
        self.assertEqual(state["projection"]["fovy"], 60)
        self.assertNotEqual(self.picture(), before)

    def test_errors_are_sentences(self):
        before = self.get("state")
        for wrong in ({"set": {"light.positon": [1, 2, 3, 1]}}, {"set": {"projection.near": "here"}}, {"set": {"": 1}},
                      {"set": {"light.position": None}}, {"set": {}}, {"set": 5}, {"set": {"projection.fovy": 33, "projection.nera": 1}},
                      {"set": {"projection.fovy=33\nprojection.near": 0.5}}, {"get": "everything"}, {"get": None},
                      {"get": "constructor"}, {"get": "state", "size": [1, 1]}, {"get": "state", "set": {"projection.fovy": 33}},
                      {"got": "state"}, {}):
            with self.subTest(wrong):
                self.assertRegex(self.ask(**wrong).get("error", ""), r"^\S[^\n]{10,}$")
        self.assertEqual(self.get("state"), before)

    def test_errors_list_the_allowed_values(self):
        for wrong, named in (({"get": "everything"}, ["state", "matrices", "link", "rests", "picture"]), ({}, ["set", "open", "get"]),
                             ({"get": "picture", "wide": 5}, ["view", "size", "samples", "wide"]),
                             ({"get": "picture", "view": "codes"}, ["camera", "depth", "stencil", "window"]),
                             ({"open": "teapto"}, ["teapto", "teapot", "state", "link"]), ({"get": "picture", "samples": 3}, ["0", "4", "3"])):
            with self.subTest(wrong):
                for name in named:
                    self.assertIn(name, self.ask(**wrong).get("error", ""))

    def test_open_answers_when_the_state_is_loaded(self):
        before = self.get("state")
        wrong_field = dict(native.state("curved"), projection={"near": "here"})
        no_mesh = dict(native.state("curved"), scene="nowhere.obj")
        for wrong in ("nonsense", "", 5, True, None, [], ["teapot"], "/etc/passwd", "../presets/teapot.json", "#1broken", "{", wrong_field, no_mesh,
                      dict(native.state("curved"), blanks=0)):
            with self.subTest(wrong):
                self.assertRegex(self.ask(open=wrong).get("error", ""), r"^\S[^\n]{10,}$")
                self.assertEqual(self.get("state"), before)
        for right in ("curved", native.state("curved"), native.fragment("curved"), json.dumps(native.state("curved"))):
            with self.subTest(right):
                self.ask(open="room")
                self.assertEqual(self.get("state")["scene"], native.state("room")["scene"])
                self.assertIs(self.ask(open=right).get("answer"), True)
                self.assertEqual(self.get("state")["scene"], native.state("curved")["scene"])
                self.assertEqual(self.get("state")["view"]["layout"]["matrices"], ["V"], "the embedding page's layout")

    def test_states_beyond_the_stack_open_up_to_the_limit(self):
        text, limit = json.dumps(native.state("curved")), 16 << 20
        for blanks in (1_400_000, limit + 1 - len(text.encode())):
            reply = self.page.driver.execute_async_script(
                "ask({open: arguments[0] + ' '.repeat(arguments[1])}).then(arguments[2])", text, blanks)
            if blanks < limit // 2:
                self.assertIs(reply.get("answer"), True, reply)
            else:
                self.assertIn(f"{limit + 1:,}", reply["error"])
                self.assertIn(f"{limit:,}", reply["error"])
        self.assertEqual(self.get("state")["scene"], native.state("curved")["scene"])

    def test_an_empty_picture_is_an_error_sentence(self):
        before = self.picture()
        for size in ([20000, 20000], [16385, 1], [1e9, 1e9], [4294967297, 200], [8000, 8000], [0, 10], [0, 0], [-5, 5], [1.5, 2], [5], [1, 2, 3], 5, "x", None,
                     ["a", "b"]):
            with self.subTest(size):
                self.assertRegex(self.ask(get="picture", size=size).get("error", ""), r"^picture: size must be [^\n]+, got ")
        for wrong in ({"view": 5}, {"view": "window", "size": [10, 10]}, {"samples": "4"}, {"samples": -1}, {"samples": 1e10}):
            with self.subTest(wrong):
                self.assertRegex(self.ask(get="picture", **wrong).get("error", ""), r"^picture: [^\n]{10,}")
        self.assertEqual(self.picture(), before)
        size = [4096, 4096]
        image = Image.open(io.BytesIO(self.picture(size=size, samples=4)))
        self.assertEqual(list(image.size), size)
        self.assertEqual(image.convert("RGBA").getextrema()[3], (255, 255), "the picture is opaque")
        self.assertGreater(len(image.convert("RGB").resize((256, 256)).getcolors(1 << 20)), 100)

    def test_the_end_of_the_program_is_reported(self):
        self.inside("setTimeout(() => Module._page_set(0xfffffff0))")
        self.page.until("the message", lambda: self.said("ended"))
        self.assertRegex(self.said("ended")[0]["error"], r"stopped .*\.$")
        self.assertEqual(self.ask(get="state")["error"], self.said("ended")[0]["error"])
        self.page.complaints()  # the expected error

    def test_foreign_messages_are_ignored(self):
        self.page.js("""(() => {
            const there = document.getElementById('sandbox').contentWindow;
            for (const data of [null, 1, 'text', [], {}, {get: 'state'}, {to: 'somebody else', id: 1, get: 'state'}])
                there.postMessage(data, '*');
            said.length = 0;
        })()""")
        self.get("rests")
        self.assertEqual(len(self.page.js("said")), 1)


class Address(Host):
    """Errors in the address are reported in the sandbox and to the host, and defaults are used instead."""

    def test_every_part_is_checked(self):
        for wrong, named in (("big=nonsense", "nonsense"), ("matrices=nonsense", "nonsense"), ("controls=light.positon", "light.positon"),
                             ("controls=%", "%"), ("big=camera&big=matrices", "twice")):
            with self.subTest(wrong):
                self.show("#embed&preset=curved&" + wrong)
                [trouble] = self.said("trouble")
                self.assertIn(named, trouble["error"])
                self.assertIn(trouble["error"], self.inside("page.ask('page_told')"))
                self.assertIn(self.get("state")["view"]["layout"]["big"], ("camera", "matrices"))
                self.assertEqual(self.get("state")["scene"], native.state("curved")["scene"])
                self.inside("Module._page_note_places()")
                self.rest()
                places = json.loads(self.inside("page.ask('page_places')"))
                [(x, y, width, height)] = [box for name, box in places.items() if name.endswith("/Dismiss")]
                self.assertTrue(0 <= x and x + width <= 800 and 0 <= y and y + height <= 450, "the message fits the frame")


class Keyboard(Host):
    """An embed never takes the keyboard focus by itself, and passes on keys that it does not use."""

    def strike(self, kind, code, key, number):
        """Strikes a key in the sandbox's frame, a separate process that DevTools' keys do not reach."""
        self.inside("void window.dispatchEvent(new KeyboardEvent(...arguments))", kind,
                    {"code": code, "key": key, "keyCode": number, "bubbles": True, "cancelable": True})

    def point(self, x, y):
        self.inside("""void document.getElementById('view').dispatchEvent(new PointerEvent('pointermove', {clientX: arguments[0], clientY: arguments[1],
                       pointerType: 'mouse'}))""", x, y)
        self.rest()

    def test_the_focus_stays_with_the_host(self):
        self.assertEqual(self.page.js("document.activeElement.id"), "note")
        self.page.press("KeyM")
        self.assertEqual(self.page.js("document.getElementById('note').value"), "m")

    def test_window_keys_belong_to_the_host(self):
        self.point(300, 60)
        before = self.get("state")
        keys = ["PageDown"] * 5 + ["KeyM", "KeyG", "Home", "F1", "Escape", "ArrowRight"]
        for code in keys:
            for kind in ("keydown", "keyup"):
                self.strike(kind, code, code[3:].lower() if code.startswith("Key") else code, 34 if code == "PageDown" else 0)
        self.page.until("the last key", lambda: len([data for data in self.said("key") if data["type"] == "keydown"]) >= len(keys))
        self.rest()
        self.assertEqual(self.get("state"), before)
        self.assertEqual(self.inside("page.ask('page_opened')"), "#preset=teapot")
        self.assertEqual([data["event"]["code"] for data in self.said("key") if data["type"] == "keydown"], keys)
        self.assertEqual(self.said("key")[0]["event"]["keyCode"], 34)

    def test_it_keeps_keys_for_flying_and_typing(self):
        self.point(300, 60)
        before = self.get("state")["camera"]["position"]
        self.strike("keydown", "KeyW", "w", 87)
        self.page.until("flight", lambda: self.get("state")["camera"]["position"] != before)
        self.strike("keyup", "KeyW", "w", 87)
        self.rest()
        self.inside("void document.getElementById('view').dispatchEvent(new PointerEvent('pointerleave', {pointerType: 'mouse'}))")
        self.rest()
        self.assertEqual(self.said("key"), [])
        self.strike("keydown", "KeyW", "w", 87)  # the pointer is elsewhere
        self.page.until("the key that is passed on", lambda: self.said("key"))
        self.assertEqual({data["event"]["code"] for data in self.said("key")}, {"KeyW"})


class KeyboardOfOneOrigin(browser.Checked):
    """If the host has the sandbox's own origin, its listeners receive the keys as if they were pressed in it."""

    def test_slides_turn_without_a_script(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "viewing").symlink_to(browser.FOLDER)
            pathlib.Path(folder, "index.html").write_text(HOST.format(address="viewing/index.html#embed&preset=teapot"), encoding="utf-8")
            self.page = browser.Page(size=(1000, 700), folder=folder)
            self.addCleanup(self.page.close)
            self.page.driver.get(self.page.server.address)
            self.page.until("the sandbox's greeting", lambda: self.page.js("said.some((data) => data.is === 'ready')"))
            for kind, buttons in (("mouseMoved", 0), ("mousePressed", 1), ("mouseReleased", 0)):
                self.page.mouse(kind, (300, 60), "left" if kind != "mouseMoved" else "none", buttons, clickCount=1)
            for key in ("PageDown", "KeyM"):
                self.page.press(key)
            self.page.until("both keys", lambda: len(self.page.js("pressed")) >= 2)
            self.assertEqual(self.page.js("pressed"), [["PageDown", 34], ["KeyM", 77]])
            self.assertEqual(self.page.js("document.getElementById('sandbox').contentWindow.eval('page.ask(\"page_opened\")')"), "#preset=teapot")


class Opener(browser.Checked):
    """A page of another site that opened the sandbox in a window is ignored."""

    def test_it_gets_no_answer(self):
        self.page = browser.Page()
        self.addCleanup(self.page.close)
        host = self.page.home / "opener.html"
        host.write_text("<!DOCTYPE html><title>Opener</title><script>const said = [];"
                        "window.addEventListener('message', (event) => said.push(event.data));</script>", encoding="utf-8")
        self.page.driver.get(host.as_uri())
        first = self.page.driver.current_window_handle
        self.page.js("void (window.there = window.open(arguments[0]))", self.page.server.address + "#preset=teapot")
        second = self.page.until("the window", lambda: [name for name in self.page.driver.window_handles if name != first])[0]
        self.page.driver.switch_to.window(second)
        self.page.until("the page", lambda: self.page.js("typeof Module !== 'undefined' && Module.calledRun && Module._page_is_open() === 1"))
        self.page.js("""window.addEventListener('message', () => setTimeout(() => window.opener.postMessage('heard', '*'), 100))""")
        self.page.driver.switch_to.window(first)
        self.page.js("""(() => {
            for (const what of [{get: 'state'}, {get: 'picture', view: 'window'}, {get: 'link'}, {}])
                there.postMessage({to: 'viewing-sandbox', id: 1, ...what}, '*');
        })()""")
        self.page.until("that all was heard", lambda: len(self.page.js("said.filter((data) => data === 'heard')")) == 4)
        self.assertEqual(set(self.page.js("said")), {"heard"})


class InTheReadme(browser.Checked):
    """The README's example, copied verbatim into a page beside the folder that it names."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        readme = (native.ROOT / "sandbox/app/browser/README.md").read_text(encoding="utf-8")
        example = re.search(r"```html\n(<iframe.*?)```", readme, re.DOTALL).group(1)
        pathlib.Path(folder.name, "index.html").write_text("<!DOCTYPE html><title>Slides</title><link rel=icon href=data:,>\n" + example,
                                                         encoding="utf-8")
        pathlib.Path(folder.name, "viewing").symlink_to(browser.FOLDER)
        self.page = browser.Page(size=(1000, 700), folder=folder.name)
        self.addCleanup(self.page.close)
        self.page.cdp("Page.addScriptToEvaluateOnNewDocument",
                      source="window.logged = []; console.log = (what) => logged.push(what);")

    def logged(self, key):
        """Returns the first logged object with this key."""
        return self.page.until(key, lambda: self.page.js("logged.find((what) => what?.[arguments[0]])", key))

    def test_the_example_shows_the_matrices_and_turns_the_camera(self):
        self.page.driver.get(self.page.server.address)
        expected = json.loads(native.run("matrices", "orbit", "--format", "json"))["view_from_world"]
        for row, expected_row in zip(self.logged("view_from_world")["view_from_world"], expected):
            for number, expected_number in zip(row, expected_row):
                self.assertAlmostEqual(number, expected_number, delta=1e-12)
        self.page.js("""(() => {
            const yaw = document.getElementById('yaw');
            yaw.value = 30;
            yaw.dispatchEvent(new Event('input'));
            document.getElementById('sandbox').contentWindow.postMessage({to: 'viewing-sandbox', id: 2, get: 'state'}, '*');
        })()""")
        self.assertEqual(self.logged("camera")["camera"]["yaw"], 30)


class WithoutBars(browser.Checked):
    def setUp(self):
        self.page = browser.Page(size=(800, 450))
        self.addCleanup(self.page.close)

    def test_only_the_view_and_the_chosen_controls_show(self):
        self.page.open("#embed&preset=teapot")
        self.page.settle(0.5)
        names = self.page.places()
        self.assertEqual([name for name in names if "top/" in name or name.startswith(("panel/", "matrices/"))], [])
        self.assertTrue(any(name.endswith("camera view") for name in names), names)

        self.page.open("#embed&preset=teapot&controls=light.position,projection.near&matrices=S")
        self.page.settle(0.5)
        names = " ".join(self.page.places())
        for chosen in ("light/position", "z-near", "matrices/S/"):
            self.assertIn(chosen, names)
        for other in ("fovy", "matrices/R/", "top/"):
            self.assertNotIn(other, names)

    def test_the_address_stays_unchanged(self):
        self.page.open("#embed&preset=teapot")
        self.page.drag((400, 60), (460, 70))
        self.page.settle(0.8)
        self.assertEqual(self.page.address(), "#embed&preset=teapot")


if __name__ == "__main__":
    unittest.main()
