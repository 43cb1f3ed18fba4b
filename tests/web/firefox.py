"""A Firefox over Marionette, its own protocol on a socket: Debian 12 packages Firefox, but no geckodriver. It has
WebGL 2 only with a display, not headless, so Xvfb provides one."""
import base64
import io
import json
import os
import pathlib
import shutil
import socket
import subprocess
import tempfile
import time

from PIL import Image

PATIENCE_S = 120
SETTINGS = {
    "marionette.port": 0,  # any free port
    "webgl.force-enabled": True,  # even with a software driver
    "browser.shell.checkDefaultBrowser": False, "datareporting.policy.dataSubmissionEnabled": False, "app.update.enabled": False,
    "network.captive-portal-service.enabled": False, "network.connectivity-service.enabled": False,
    "browser.startup.homepage_override.mstone": "ignore", "browser.newtabpage.enabled": False,
}


class Firefox:
    """One Firefox with its own display and profile."""

    def __init__(self, size=(1280, 720)):
        self.home = pathlib.Path(tempfile.mkdtemp(prefix="web-test-firefox-"))
        self.processes = []
        lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in SETTINGS.items()]
        (self.home / "user.js").write_text("\n".join(lines))
        try:
            display = self.display()
            self.begin("firefox-esr", "--marionette", "--no-remote", "--profile", self.home, f"--width={size[0]}",
                       f"--height={size[1] + 86}", env={**os.environ, "DISPLAY": display, "HOME": str(self.home)})
            self.number = 0
            self.socket = self.connected()
            self.read()
            self.call("WebDriver:NewSession", capabilities={"alwaysMatch": {}})
            self.call("WebDriver:SetTimeouts", script=1000 * PATIENCE_S, pageLoad=1000 * PATIENCE_S)
        except BaseException:
            self.close()
            raise

    def begin(self, *command, **more):
        self.processes.append(subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                               stderr=subprocess.DEVNULL, **more))

    def display(self):
        """Xvfb chooses a free number and writes it."""
        ours, its = os.pipe()
        self.begin("Xvfb", "-displayfd", str(its), "-screen", "0", "1600x1000x24", "-nolisten", "tcp", pass_fds=[its])
        os.close(its)
        with os.fdopen(ours) as said:
            number = said.readline().strip()
        assert number, "Xvfb does not start"
        return f":{number}"

    def connected(self):
        end = time.monotonic() + PATIENCE_S
        while True:  # the port is written once Firefox listens to it
            try:
                port = int((self.home / "MarionetteActivePort").read_text())
                return socket.create_connection(("127.0.0.1", port), timeout=PATIENCE_S + 10)
            except (OSError, ValueError):
                if time.monotonic() > end or self.processes[-1].poll() is not None:
                    raise AssertionError("Firefox does not listen") from None
                time.sleep(0.1)

    def read(self):
        size = b""
        while (sign := self.socket.recv(1)) != b":":
            assert sign, "Firefox has gone"
            size += sign
        data = b""
        while len(data) < int(size):
            data += self.socket.recv(int(size) - len(data))
        return json.loads(data)

    def call(self, command, **values):
        self.number += 1
        data = json.dumps([0, self.number, command, values]).encode()
        self.socket.sendall(str(len(data)).encode() + b":" + data)
        _, number, error, result = self.read()
        assert number == self.number
        if error:
            raise AssertionError(f"{command}: {error['error']}: {error['message']}")
        return result

    def go_to(self, address):
        self.call("WebDriver:Navigate", url=address)

    def js(self, expression):
        """Returns the expression's value in the page's own scope, since Marionette's scripts do not see the page's constants."""
        script = "return window.eval(arguments[0])"
        return self.call("WebDriver:ExecuteScript", script=script, args=[expression], sandbox=None)["value"]

    def wait(self, script, *values):
        """Returns the value that a script passes to its last argument asynchronously."""
        return self.call("WebDriver:ExecuteAsyncScript", script=script, args=list(values), sandbox=None)["value"]

    def screen(self):
        data = self.call("WebDriver:TakeScreenshot", full=False)["value"]
        return Image.open(io.BytesIO(base64.b64decode(data))).convert("RGB")

    def close(self):
        for process in reversed(self.processes):
            process.terminate()
            process.wait(60)
        shutil.rmtree(self.home, ignore_errors=True)
