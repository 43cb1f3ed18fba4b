"""The sandbox as a part of somebody else's page, which asks and sets by messages."""
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

HOST = """<!DOCTYPE html><title>Slides</title>
<iframe id="sandbox" width="800" height="450" src="{address}#embed&preset=teapot&matrices=V"></iframe>
<script>
const said = [];
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


class Embedded(browser.Test):
    def setUp(self):
        host = self.page.home / "host.html"  # from another origin than the sandbox
        host.write_text(HOST.format(address=self.page.server.address), encoding="utf-8")
        self.page.driver.get(host.as_uri())
        self.page.until("the sandbox's greeting", lambda: self.page.js("said.some((data) => data.is === 'ready')"))
        self.rest()

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

    def test_it_tells_its_state_its_matrices_and_its_link(self):
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

    def test_it_greets_when_what_the_address_names_is_shown(self):
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

    def test_what_is_wrong_is_a_sentence(self):
        before = self.get("state")
        for wrong in ({"set": {"light.positon": [1, 2, 3, 1]}}, {"set": {"projection.near": "here"}}, {"set": {"": 1}},
                      {"set": {"light.position": None}}, {"get": "everything"}, {"get": None}, {"get": "constructor"}, {}):
            with self.subTest(wrong):
                self.assertRegex(self.ask(**wrong).get("error", ""), r"^\S.{10,}")
        self.assertEqual(self.get("state"), before)

    def test_messages_of_others_are_nobodys_business(self):
        self.page.js("""(() => {
            const there = document.getElementById('sandbox').contentWindow;
            for (const data of [null, 1, 'text', [], {}, {get: 'state'}, {to: 'somebody else', id: 1, get: 'state'}])
                there.postMessage(data, '*');
            said.length = 0;
        })()""")
        self.get("rests")
        self.assertEqual(len(self.page.js("said")), 1)


class InTheReadme(browser.Checked):
    """Its example, put into a page as it is printed, beside the folder that it names."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        readme = (native.ROOT / "README.md").read_text(encoding="utf-8")
        example = re.search(r"```html\n(<iframe.*?)```", readme, re.DOTALL).group(1)
        pathlib.Path(folder.name, "index.html").write_text("<!DOCTYPE html><title>Slides</title><link rel=icon href=data:,>\n" + example,
                                                         encoding="utf-8")
        pathlib.Path(folder.name, "viewing").symlink_to(browser.FOLDER)
        self.page = browser.Page(size=(1000, 700), folder=folder.name)
        self.addCleanup(self.page.close)
        self.page.cdp("Page.addScriptToEvaluateOnNewDocument",
                      source="window.logged = []; console.log = (what) => logged.push(what);")

    def logged(self, key):
        """The first of what the page has logged that has this key."""
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

    def test_only_the_view_and_the_chosen_controls(self):
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

    def test_the_address_stays_the_hosts(self):
        self.page.open("#embed&preset=teapot")
        self.page.drag((400, 60), (460, 70))
        self.page.settle(0.8)
        self.assertEqual(self.page.address(), "#embed&preset=teapot")


if __name__ == "__main__":
    unittest.main()
