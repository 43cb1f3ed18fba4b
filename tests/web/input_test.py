"""Mouse, keys, fingers and clipboard, as the browser brings them; what came of them is read from the state."""
import json
import math
import unittest

import browser
import native

VIEW = (380, 150)  # in the camera's view, where neither a handle nor an object is in the way of a drag


def ahead(camera):
    """The direction that the camera looks in."""
    yaw, pitch = math.radians(camera["yaw"]), math.radians(camera["pitch"])
    return -math.sin(yaw) * math.cos(pitch), math.sin(pitch), -math.cos(yaw) * math.cos(pitch)


def along(direction, start, end):
    return sum(d * (b - a) for d, a, b in zip(direction, start, end))


class Input(browser.Test):
    def setUp(self):
        self.page.open()

    # ---- mouse

    def test_a_slider_follows_the_mouse(self):
        # Both taps at once: between two commands a busy machine may let the time of a double tap pass.
        self.page.js("""(([x, y]) => {
            const canvas = document.getElementById('view');
            canvas.setPointerCapture = () => {};  // knows no finger that is made here
            for (const type of ['pointerdown', 'pointerup', 'pointerdown', 'pointerup'])
                canvas.dispatchEvent(new PointerEvent(type, {pointerId: 7, pointerType: 'touch', clientX: x, clientY: y}));
        })(arguments[0])""", self.page.place("projection/fovy"))
        self.page.settle()
        self.assertEqual(self.page.js("document.activeElement.id"), "typed")
        self.page.cdp("Input.insertText", text="62")  # as a keyboard on the screen does: no keys
        self.page.key("Enter")
        self.assertEqual(self.page.field("projection.fovy"), 62)


if __name__ == "__main__":
    unittest.main()
