"""A headless Chromium with the page in it, driven through the DevTools protocol: real mouse, keys and fingers.

Nothing here waits for a fixed time. An action is complete as soon as the page has drawn it and requests no more frames;
settle() waits for that, so a busy machine only takes longer. Read Page first, then a test.
"""
import base64
import contextlib
import functools
import http.server
import io
import json
import os
import pathlib
import re
import shutil
import tempfile
import threading
import time
import unittest

from PIL import Image
from selenium import webdriver
from selenium.common.exceptions import JavascriptException
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

FOLDER = pathlib.Path(os.environ.get("WEB_PAGE", pathlib.Path(__file__).parents[2] / "build/web"))
PATIENCE_S = 60  # before something counts as missing

MESA, SWIFTSHADER = "gl-egl", "swiftshader"  # ANGLE's backends: Mesa's llvmpipe as on the desktop, and Chromium's own

# Chromium's harmless messages, with the reason. Every other message of level WARNING or SEVERE is a failure.
HARMLESS = {
    r"GPU stall due to ReadPixels": "a note on speed: pictures are read here on purpose",
}

# Runs before the page's own scripts: counts frames and work items, and keeps uncaught errors.
WATCH = """
(() => {
  const watched = window.watched = {frames: 0, asked: 0, turns: 0, last: performance.now(), first: 0, errors: []};
  const ask = watched.ask = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (draw) => {
    ++watched.asked;
    return ask((time) => {
      --watched.asked;
      ++watched.frames;
      draw(time);
      watched.last = performance.now();
      watched.first ||= watched.last;
    });
  };
  window.MessageChannel = class extends MessageChannel {
    constructor() {
      super();
      ++watched.turns;
      watched.last = performance.now();
    }
  };
  window.addEventListener('error', (event) => watched.errors.push(String(event.message)));
  window.addEventListener('unhandledrejection', (event) => watched.errors.push(String(event.reason)));
})();
"""

# Resolves when no frame and no work item has run for `quiet_ms` and the program reports that it rests. A blinking caret
# and the clock of a stage request a frame now and then forever; the program rests in between.
SETTLE = """
const [quiet_ms, limit_ms, done] = arguments, begun = performance.now();
const look = () => {
  const now = performance.now();
  const is_there = typeof Module !== 'undefined' && Module.calledRun && Module._page_is_open && Module._page_is_open();
  const is_quiet = is_there && !watched.asked && now - watched.last >= quiet_ms && watched.frames > 0;
  const rests = is_quiet && Module._page_rests();
  if (rests) done('');
  else if (now - begun > limit_ms) done(is_there ? 'frames: ' + watched.frames + ', asked: ' + watched.asked : 'never open');
  else setTimeout(look, 25);
};
// Pending input arrives before the browser's next frames, which are requested without the page's counter.
const ask = window.watched ? watched.ask : requestAnimationFrame;
ask(() => ask(look));
"""

DOUBLE_CLICK = """((pointerType, clientX, clientY) => {
    const canvas = document.getElementById('view');
    canvas.setPointerCapture = () => {};  // knows no pointer that is made here
    for (const type of ['pointerdown', 'pointerup', 'pointerdown', 'pointerup'])
        canvas.dispatchEvent(new PointerEvent(type, {pointerType, pointerId: 7, clientX, clientY, cancelable: true}));
    delete canvas.setPointerCapture;
})(...arguments)"""

KEYS = {  # code: (key, Windows key code)
    "Enter": ("Enter", 13), "Escape": ("Escape", 27), "Tab": ("Tab", 9), "Backspace": ("Backspace", 8), "Home": ("Home", 36),
    "End": ("End", 35), "PageDown": ("PageDown", 34), "PageUp": ("PageUp", 33), "F1": ("F1", 112), "F12": ("F12", 123),
    "Minus": ("-", 189), "Period": (".", 190), "ControlLeft": ("Control", 17), "ShiftLeft": ("Shift", 16),
}
CTRL, SHIFT = 2, 8


class Server:
    """Serves the folder on 127.0.0.1, like any static server."""

    def __init__(self, folder):
        class Quiet(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *_):
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(folder)))
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.address = f"http://127.0.0.1:{self.server.server_address[1]}/"

    def close(self):
        self.server.shutdown()
        self.server.server_close()


class Checked(unittest.TestCase):
    """Fails if self.page has complaints at the end."""

    def tearDown(self):
        self.assertEqual(self.page.complaints(), [])


class Test(Checked):
    """All tests share one page, made with these `options` of Page."""
    options = {}

    @classmethod
    def setUpClass(cls):
        cls.page = Page(**cls.options)
        cls.addClassCleanup(cls.page.close)


class Page:
    """One Chromium with its own profile. `size` in page units of `scale` pixels each; `may_keep`: the user lets sites store
    data."""

    def __init__(self, angle=MESA, size=(1280, 720), scale=1, touch=False, folder=None, may_keep=True):
        self.size, self.scale = size, scale
        self.server = Server(folder or FOLDER)
        self.home = pathlib.Path(tempfile.mkdtemp(prefix="web-test-"))
        self.downloads = self.home / "downloads"
        options = Options()
        options.binary_location = shutil.which("chromium")
        for argument in (
            "--headless=new", "--no-sandbox", "--use-gl=angle", f"--use-angle={angle}", "--enable-unsafe-swiftshader",
            "--ignore-gpu-blocklist", "--disable-background-networking", "--disable-component-update", "--disable-sync",
            "--no-first-run", f"--user-data-dir={self.home / 'profile'}",
        ):
            options.add_argument(argument)
        if not may_keep:
            options.add_experimental_option("prefs", {"profile.default_content_setting_values.cookies": 2})
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))
        self.driver.set_script_timeout(PATIENCE_S + 30)
        self.cdp("Page.addScriptToEvaluateOnNewDocument", source=WATCH)
        self.cdp("Emulation.setFocusEmulationEnabled", enabled=True)
        self.cdp("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(self.downloads))
        self.cdp("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
        if touch:
            self.cdp("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=5)
        self.resize(size, scale)

    def close(self):
        self.driver.quit()
        self.server.close()
        shutil.rmtree(self.home, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    # ---- the browser

    def cdp(self, command, **values):
        return self.driver.execute_cdp_cmd(command, values)

    def js(self, script, *values):
        """Returns the value of an expression, in which `arguments` are the values."""
        return self.driver.execute_script("return " + script, *values)

    def ask(self, name, *values):
        """Returns the text from a function of app/browser."""
        return self.js("page.ask(arguments[0], ...arguments[1])", name, list(values))

    def resize(self, size, scale=1):
        self.size, self.scale = size, scale
        self.cdp("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=scale, mobile=False)

    def open(self, fragment="", address=None):
        """Opens a fresh page, even if only the fragment differs."""
        self.driver.get("about:blank")
        self.driver.get((address or self.server.address) + fragment)
        self.settle()

    def open_link(self, fragment):
        """Opens another link in the same page, as when it is typed into the address bar."""
        self.driver.execute_async_script("""
            const [fragment, done] = arguments;
            if (location.hash === fragment) return done();
            window.addEventListener('hashchange', () => done(), {once: true});
            location.hash = fragment;""", fragment)

    def travel(self, steps):
        """Goes back (negative) or forward."""
        self.driver.execute_async_script("""
            const [steps, done] = arguments, before = location.hash;
            window.addEventListener('popstate', () => {  // if the page opens the new address, that happens later
                if (location.hash === before) setTimeout(done);
                else window.addEventListener('hashchange', () => setTimeout(done), {once: true});
            }, {once: true});
            history.go(steps);""", steps)
        self.settle()

    def go_to(self, fragment):
        self.open_link(fragment)
        self.settle()

    def settle(self, quiet_s=0.08):
        trouble = self.driver.execute_async_script(SETTLE, 1000 * quiet_s, 1000 * PATIENCE_S)
        if trouble:
            raise AssertionError(f"the page does not come to rest: {trouble}; {self.complaints() or self.notice()}")

    def until(self, what, condition):
        """Waits for asynchronous results: a download, a browser window."""
        end = time.monotonic() + PATIENCE_S
        while not (found := condition()):
            if time.monotonic() > end:
                raise AssertionError(f"{what} does not appear")
            time.sleep(0.05)
        return found

    def complaints(self):
        """Returns messages of the console, WebGL errors and uncaught errors since the last call."""
        said = [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] in ("WARNING", "SEVERE")]
        with contextlib.suppress(JavascriptException):
            said += self.js("window.watched ? watched.errors.splice(0) : []")
        with contextlib.suppress(JavascriptException):
            error = self.js("typeof GLctx === 'undefined' ? 0 : GLctx.getError()")
            said += [f"gl.getError() is {error:#x}"] if error else []
        return [line for line in said if not any(re.search(pattern, line) for pattern in HARMLESS)]

    # ---- the program's state

    def state(self):
        return json.loads(self.ask("page_state"))

    def field(self, path):
        value = self.state()
        for name in path.split("."):
            value = value[name]
        return value

    def told(self):
        """Returns the text for screen readers."""
        return self.ask("page_told")

    def link(self):
        return self.ask("page_link")

    def opened(self):
        return self.ask("page_opened")

    def address(self):
        return self.js("location.hash")

    def notice(self):
        return self.js("document.getElementById('notice').hidden ? '' : document.getElementById('notice-text').textContent")

    def frames(self):
        return self.js("watched.frames")

    def camera(self):
        """Returns the camera's picture as PNG with its state, without the window's overlays."""
        return self.bytes_of(self.ask("page_picture", "camera", 0, 0, -1))

    def bytes_of(self, path):
        """Returns a file of the page's own file system."""
        return base64.b64decode(self.js("""(() => {
            const bytes = FS.readFile(arguments[0]), parts = [];
            for (let i = 0; i < bytes.length; i += 32768) parts.push(String.fromCharCode(...bytes.subarray(i, i + 32768)));
            return btoa(parts.join(''));
        })()""", path))

    def screen(self):
        """Returns a screenshot in pixels."""
        data = self.cdp("Page.captureScreenshot", format="png")["data"]
        return Image.open(io.BytesIO(base64.b64decode(data))).convert("RGB")

    # ---- places

    def places(self):
        """Returns every control on screen by window and label, with its rectangle in page units."""
        self.js("Module._page_note_places()")
        self.settle(0.05)
        found = json.loads(self.ask("page_places"))
        above = self.js("document.getElementById('view').getBoundingClientRect().top")  # the height of the bar, if there is one
        return {name: (x / self.scale, y / self.scale + above, width / self.scale, height / self.scale)
                for name, (x, y, width, height) in found.items()}

    def place(self, label):
        """Returns the center of the control whose name ends with `label`."""
        places = self.places()
        found = [box for name, box in places.items() if name == label or name.endswith("/" + label)]
        if not found:
            raise AssertionError(f"no control {label} on screen; there are: {', '.join(sorted(places))}")
        x, y, width, height = found[0]
        return x + width / 2, y + height / 2

    # ---- mouse

    def mouse(self, kind, at, button="none", buttons=0, **more):
        self.cdp("Input.dispatchMouseEvent", type=kind, x=at[0], y=at[1], button=button, buttons=buttons, **more)

    def click(self, label_or_place, button="left"):
        at = self.place(label_or_place) if isinstance(label_or_place, str) else label_or_place
        self.mouse("mouseMoved", at)
        self.mouse("mousePressed", at, button, {"left": 1, "right": 2, "middle": 4}[button], clickCount=1)
        self.mouse("mouseReleased", at, button, 0, clickCount=1)
        self.settle()

    def double_click(self, label, pointer="mouse"):
        """Clicks twice at one moment. WebDriver would send each event after the page has drawn the one before, which makes
        two single clicks of it on a busy machine."""
        at = self.place(label)
        if pointer == "mouse":
            self.mouse("mouseMoved", at)
        self.js(DOUBLE_CLICK, pointer, *at)
        self.settle()

    def drag(self, start, end, button="left", steps=8):
        bit = {"left": 1, "right": 2, "middle": 4}[button]
        self.mouse("mouseMoved", start)
        self.mouse("mousePressed", start, button, bit, clickCount=1)
        for step in range(1, steps + 1):
            share = step / steps
            self.mouse("mouseMoved", tuple(a + (b - a) * share for a, b in zip(start, end)), button, bit)
        self.mouse("mouseReleased", end, button, 0, clickCount=1)
        self.settle()

    def wheel(self, at, notches):
        """Positive turns the wheel away from the user."""
        self.mouse("mouseMoved", at)
        self.cdp("Input.dispatchMouseEvent", type="mouseWheel", x=at[0], y=at[1], deltaX=0, deltaY=-100 * notches)
        self.settle()

    # ---- keys

    @staticmethod
    def key_event(code):
        if code in KEYS:
            return {"code": code, "key": KEYS[code][0], "windowsVirtualKeyCode": KEYS[code][1]}
        sign = code[-1].lower()  # KeyW, Digit5
        return {"code": code, "key": sign, "windowsVirtualKeyCode": ord(sign.upper())}

    def key_down(self, code, modifiers=0, **more):
        event = self.key_event(code)
        if len(event["key"]) == 1 and not modifiers & CTRL:
            event["text"] = event["key"]
        if code == "Enter":
            event["text"] = "\r"
        self.cdp("Input.dispatchKeyEvent", type="keyDown" if "text" in event else "rawKeyDown", modifiers=modifiers,
                 **event, **more)

    def key_up(self, code, modifiers=0):
        self.cdp("Input.dispatchKeyEvent", type="keyUp", modifiers=modifiers, **self.key_event(code))

    def press(self, code, modifiers=0, **more):
        """`more`: commands that the browser itself runs on these keys, such as paste."""
        for bit, held in ((CTRL, "ControlLeft"), (SHIFT, "ShiftLeft")):
            if modifiers & bit:
                self.key_down(held, modifiers)
        self.key_down(code, modifiers, **more)
        self.key_up(code, modifiers)
        for bit, held in ((CTRL, "ControlLeft"), (SHIFT, "ShiftLeft")):
            if modifiers & bit:
                self.key_up(held)

    def key(self, code, modifiers=0, **more):
        self.press(code, modifiers, **more)
        self.settle()

    def strike(self, text):
        """Types digits, letters, minus and period, as fast as possible."""
        for sign in text:
            self.press({"-": "Minus", ".": "Period"}.get(sign) or ("Digit" if sign.isdigit() else "Key") + sign.upper())

    def type(self, text):
        self.strike(text)
        self.settle()

    def enter(self, label, text):
        """Replaces a number by typing."""
        self.double_click(label)
        self.type(text)
        self.key("Enter")

    # ---- fingers

    def fingers(self, kind, *places):
        """kind: touchStart, touchMove, touchEnd; `places` of all touching fingers."""
        points = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(places)]
        self.cdp("Input.dispatchTouchEvent", type=kind, touchPoints=points)

    # ---- files and clipboard

    def downloaded(self, pattern):
        """Returns the complete download with this name and removes it."""
        def whole():
            files = [file for file in self.downloads.glob(pattern) if file.suffix != ".crdownload"]
            return files[0] if files and not list(self.downloads.glob("*.crdownload")) else None

        file = self.until(f"a download of {pattern}", whole)
        return file.rename(self.home / file.name)

    def drop(self, file):
        """Drops a file onto the center of the page."""
        data = {"items": [], "files": [str(file)], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.cdp("Input.dispatchDragEvent", type=kind, x=self.size[0] / 2, y=self.size[1] / 2, data=data)
        self.settle()

    def clipboard(self):
        return self.driver.execute_async_script("navigator.clipboard.readText().then(arguments[0])")

    def put_into_clipboard(self, text):
        self.driver.execute_async_script("navigator.clipboard.writeText(arguments[0]).then(arguments[1])", text)
