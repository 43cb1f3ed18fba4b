"""Failures of the page as a whole: texts that are too long, a program that stops, missing files."""
import json
import pathlib
import shutil
import tempfile
import unittest

import browser
import native

LIMIT = 16 << 20  # bytes of a text, as on the command line
STACK = 1_310_720  # characters that once fit on the program's stack
PASTE = """(() => {
    const clipboard = new DataTransfer();
    clipboard.setData('text/plain', arguments[0] + ' '.repeat(arguments[1]));
    window.dispatchEvent(new ClipboardEvent('paste', {clipboardData: clipboard, cancelable: true}));
})()"""
ANSWERS = "/home/web_user/.config/viewing-sandbox/answers/viewing-2026~32201234.json"


def keep_answers(page):
    """Puts a hand-in into the browser's storage and returns it."""
    text = json.dumps({"answers": 1, "program": "", "course": "viewing-2026", "student": "32201234", "name": "", "items": []})
    page.js("localStorage.setItem('viewing-sandbox:' + arguments[0], arguments[1])", ANSWERS, text)
    return text


class LongTexts(browser.Test):
    def setUp(self):
        self.page.open()

    def paste(self, text, blanks):
        self.page.js(PASTE, text, blanks)
        self.page.settle()

    def test_a_state_longer_than_the_stack_is_pasted(self):
        self.paste(json.dumps(native.state("curved")), STACK + 100_000)
        self.assertEqual(self.page.field("scene"), native.state("curved")["scene"])

    def test_a_text_that_is_too_long_is_reported_with_size_and_limit(self):
        before, silence = self.page.state(), self.page.told()
        text = json.dumps(native.state("curved"))
        self.paste(text, LIMIT + 1 - len(text.encode()))
        said = self.page.told().replace(silence, "").strip()
        self.assertIn(f"{LIMIT + 1:,}", said)
        self.assertIn(f"{LIMIT:,}", said)
        self.assertNotIn("\n", said)
        self.assertEqual(self.page.state(), before)
        self.page.enter("projection/fovy", "55")
        self.assertEqual(self.page.field("projection.fovy"), 55)

    def test_a_text_of_the_maximum_length_is_accepted(self):
        text = json.dumps(native.state("curved"))
        self.paste(text, LIMIT - len(text.encode()))
        self.assertEqual(self.page.field("scene"), native.state("curved")["scene"])

    def test_a_link_longer_than_the_stack_is_reported(self):
        before, silence = self.page.state(), self.page.told()
        self.page.go_to("#1" + "A" * (STACK + 1000))
        self.assertRegex(self.page.told().replace(silence, "").strip(), r"^link: .{10,}")
        self.assertEqual(self.page.state(), before)

    def test_a_dropped_folder_is_reported(self):
        folder = self.page.home / "folder.json"
        folder.mkdir(exist_ok=True)
        before = self.page.state()
        self.page.drop(folder)
        self.page.until("a sentence", lambda: "folder.json" in self.page.told())
        self.assertEqual((self.page.state(), self.page.notice()), (before, ""))


class Ended(browser.Test):
    """The program stops: the last picture stays, and a notice over it says what happened and what can be done."""

    ENDS = {
        "a trap": "setTimeout(() => Module._page_set(0xfffffff0))",
        "an exception of C++ in a frame":
            "Module._page_frame = () => { throw new WebAssembly.Exception(new WebAssembly.Tag({parameters: []}), []); }; page.wake()",
        "a trap in work beside the frames": "Promise.reject(new WebAssembly.RuntimeError('unreachable'))",
        "the program's own abort": "setTimeout(() => abort('of a test'))",
    }

    def run_script(self, text):
        """Runs as a script of the page, because a page gets no errors of scripts that WebDriver runs."""
        self.page.js("(() => { const made = document.createElement('script'); made.textContent = arguments[0]; document.head.append(made); })()", text)

    def end(self, how="a trap"):
        self.run_script(self.ENDS[how])
        self.page.until("the notice", self.page.notice)

    def buttons(self):
        return {button.text: button for button in self.page.driver.find_elements("css selector", "#notice button")}

    def tearDown(self):
        self.page.complaints()  # the expected error
        self.page.js("localStorage.clear()")

    def test_every_end_is_reported(self):
        for how in self.ENDS:
            with self.subTest(how):
                self.page.open("#preset=teapot")
                self.end(how)
                self.assertRegex(self.page.notice(), r"stopped .*\.$")
                self.assertIn("Load again", self.buttons())
                frames = self.page.frames()
                self.page.press("KeyM")
                self.page.mouse("mouseMoved", (300, 300))
                self.page.js("window.dispatchEvent(new Event('pagehide'))")
                self.assertEqual(self.page.frames(), frames)
                self.page.complaints()
        self.assertEqual(self.page.js("page.ask('page_state')"), "", "nothing runs any more")

    def test_the_last_picture_shows_behind_the_notice(self):
        self.page.open("#preset=teapot")
        before = len(self.page.screen().resize((320, 180)).getcolors(1 << 20))
        self.end()
        self.assertGreater(len(self.page.screen().resize((320, 180)).getcolors(1 << 20)), before / 4)

    def test_load_again_restores_the_state(self):
        self.page.open("#preset=teapot")
        self.page.enter("projection/fovy", "55")
        self.page.settle(0.8)
        state = self.page.state()
        self.end()
        self.buttons()["Load again"].click()
        self.page.until("the page again", lambda: self.page.js("typeof watched !== 'undefined' && watched.frames > 0 && Module.calledRun"))
        self.page.settle()
        self.assertEqual((self.page.notice(), self.page.state()), ("", state))

    def test_stored_answers_are_offered(self):
        self.page.open()
        text = keep_answers(self.page)
        self.end()
        self.buttons()["Save answers of 32201234"].click()
        self.assertEqual(self.page.downloaded("32201234.json").read_text(), text)

    def test_it_is_reported_in_korean(self):
        self.page.open()
        self.page.click("top/Look")
        self.page.click("한국어")
        self.page.settle(0.8)
        self.end()
        self.assertRegex(self.page.notice(), "[가-힣]{2}.*니다")
        self.assertIn("다시 불러오기", self.buttons())

    def test_browser_refusals_and_notes_do_not_end_it(self):
        self.page.open()
        self.run_script("Promise.reject(new DOMException('no', 'NotAllowedError'))")
        self.page.js("window.dispatchEvent(new ErrorEvent('error', {message: 'ResizeObserver loop limit exceeded'}))")
        self.page.js("""(() => {
            const other = document.createElement('script');
            other.src = 'data:text/javascript,throw new TypeError("of an extension")';
            document.head.append(other);
            return new Promise((done) => { other.onload = done; });
        })()""")
        self.page.driver.execute_async_script("setTimeout(arguments[0], 50)")
        self.page.enter("projection/fovy", "55")
        self.assertEqual((self.page.field("projection.fovy"), self.page.notice()), (55, ""))


class Missing(unittest.TestCase):
    """A server that lacks one of the page's files."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="web-test-"))
        self.addCleanup(shutil.rmtree, self.folder)
        for file in browser.FOLDER.iterdir():
            (self.folder / file.name).symlink_to(file)
        self.page = browser.Page(folder=self.folder)
        self.addCleanup(self.page.close)
        self.page.cdp("Network.enable")
        self.page.cdp("Network.setCacheDisabled", cacheDisabled=True)

    def test_the_missing_file_is_named_and_answers_are_offered(self):
        self.page.open()
        keep_answers(self.page)
        for name in ("kept.js", "page.js", "messages.js", "page.css", "viewing-sandbox.js", "viewing-sandbox.wasm"):
            with self.subTest(name):
                (self.folder / name).unlink()
                self.page.driver.get("about:blank")
                self.page.driver.get(self.page.server.address)
                self.page.until("the sentence", lambda: name in self.page.notice())
                buttons = [button.text for button in self.page.driver.find_elements("css selector", "#notice button")]
                self.assertEqual(buttons, ["Load again", "Save answers of 32201234"])
                (self.folder / name).symlink_to(browser.FOLDER / name)
        (self.folder / "net.js").unlink()
        self.page.driver.get("about:blank")
        self.page.driver.get(self.page.server.address)
        self.page.until("a sentence about the missing net.js", lambda: "net.js" in self.page.notice())

    def tearDown(self):
        pass  # the complaints are about the missing file and its consequences


if __name__ == "__main__":
    unittest.main()
