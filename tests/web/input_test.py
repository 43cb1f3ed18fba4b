"""Mouse, keys, fingers and clipboard through the browser; their effect is read from the state."""
import json
import math
import time
import unittest

import browser
import native

VIEW = (380, 150)  # in the camera's view, away from handles and objects


def ahead(camera):
    """Returns the direction in which the camera looks."""
    yaw, pitch = math.radians(camera["yaw"]), math.radians(camera["pitch"])
    return -math.sin(yaw) * math.cos(pitch), math.sin(pitch), -math.cos(yaw) * math.cos(pitch)


def along(direction, start, end):
    return sum(d * (b - a) for d, a, b in zip(direction, start, end))


class Input(browser.Test):
    def setUp(self):
        self.page.open()

    # ---- mouse

    def test_a_slider_follows_the_mouse(self):
        x, y = self.page.place("projection/fovy")
        before = self.page.field("projection.fovy")
        self.page.drag((x, y), (x + 40, y))
        self.assertGreater(self.page.field("projection.fovy"), before + 5)

    def test_a_click_switches(self):
        self.page.click("depth/Depth test")
        self.assertFalse(self.page.field("depth.test"))

    def test_a_click_within_one_frame_counts(self):
        """Pressed and released before the page has drawn once."""
        at = self.page.place("depth/Depth test")
        self.page.mouse("mouseMoved", at)
        self.page.settle()
        self.page.js("""(() => {
            const view = document.getElementById('view');
            for (const kind of ['pointerdown', 'pointerup'])
                view.dispatchEvent(new PointerEvent(kind, {pointerId: 1, clientX: arguments[0], clientY: arguments[1], button: 0}));
        })()""", *at)
        self.page.settle()
        self.assertFalse(self.page.field("depth.test"))

    def test_a_drag_in_the_view_looks_around(self):
        before = self.page.field("camera.yaw")
        self.page.drag(VIEW, (VIEW[0] + 80, VIEW[1] + 20))
        self.assertNotAlmostEqual(self.page.field("camera.yaw"), before, delta=1)
        self.assertEqual(self.page.field("camera.position"), native.state()["camera"]["position"])

    def test_the_wheel_moves_the_camera_or_the_panel(self):
        before = self.page.state()["camera"]
        self.page.wheel(VIEW, 2)
        after = self.page.state()["camera"]
        self.assertNotEqual(after, before)
        self.page.open()
        above = self.page.place("projection/fovy")[1]
        self.page.wheel((250, above), -2)  # beside the slider
        self.assertLess(self.page.place("projection/fovy")[1], above)
        self.assertEqual(self.page.state()["camera"], before)

    def test_the_pointer_changes_its_shape_over_controls(self):
        shape = lambda: self.page.js("document.getElementById('view').style.cursor")
        self.page.double_click("projection/fovy")
        self.assertEqual(shape(), "text")
        self.page.key("Escape")
        self.page.mouse("mouseMoved", VIEW)
        self.page.settle()
        self.assertNotEqual(shape(), "text")

    # ---- keys

    def test_w_flies_while_held(self):
        before = self.page.state()["camera"]
        self.page.mouse("mouseMoved", VIEW)
        self.page.key_down("KeyW")
        self.page.until("a flight", lambda: self.page.field("camera.position") != before["position"])
        self.page.key_up("KeyW")
        self.page.settle()
        after = self.page.state()["camera"]
        self.assertGreater(along(ahead(before), before["position"], after["position"]), 0)
        self.assertEqual(self.page.state()["camera"], after, "it continues after the key was released")

    def test_a_number_is_typed(self):
        self.page.enter("projection/fovy", "55")
        self.assertEqual(self.page.field("projection.fovy"), 55)
        self.page.enter("camera/position/x", "-1.25")
        self.assertEqual(self.page.field("camera.position")[0], -1.25)

    def test_a_double_click_counts_while_frames_take_longer_than_it(self):
        self.page.js("""(() => {
            const draw = Module._page_frame;
            Module._page_frame = (...all) => {
                const end = performance.now() + 400;
                while (performance.now() < end);
                return draw(...all);
            };
        })()""")
        self.page.enter("projection/fovy", "55")
        self.assertEqual(self.page.field("projection.fovy"), 55)

    def test_typing_w_does_not_fly(self):
        before = self.page.state()
        self.page.double_click("camera/position/x")
        self.page.type("w")
        self.page.key("Escape")
        self.assertEqual(self.page.state(), before)

    def test_undo_and_redo(self):
        opening = self.page.state()
        self.page.enter("camera/position/x", "2")
        changed = self.page.state()
        self.page.mouse("mouseMoved", VIEW)
        self.page.key("KeyZ", browser.CTRL)
        self.assertEqual(self.page.state(), opening)
        self.page.key("KeyZ", browser.CTRL | browser.SHIFT)
        self.assertEqual(self.page.state(), changed)

    def test_a_held_key_is_released_when_the_page_loses_focus(self):
        self.page.mouse("mouseMoved", VIEW)
        self.page.key_down("KeyW")
        self.page.js("window.dispatchEvent(new Event('blur'))")
        self.page.settle()
        before = self.page.state()["camera"]
        self.page.js("window.dispatchEvent(new Event('focus'))")
        self.page.settle()
        self.assertEqual(self.page.state()["camera"], before)
        self.page.key_up("KeyW")

    # ---- clipboard

    def test_the_state_is_copied(self):
        self.page.enter("projection/fovy", "55")
        self.page.mouse("mouseMoved", VIEW)
        self.page.key("KeyC", browser.CTRL)
        self.assertEqual(json.loads(self.page.clipboard()), self.page.state())

    def test_a_state_is_pasted(self):
        self.page.put_into_clipboard('{"projection": {"near": 0.25}}')
        self.page.mouse("mouseMoved", VIEW)
        self.page.key("KeyV", browser.CTRL, commands=["paste"])
        self.assertEqual(self.page.field("projection.near"), 0.25)
        before = self.page.state()
        self.page.put_into_clipboard("junk")
        self.page.key("KeyV", browser.CTRL, commands=["paste"])
        self.assertEqual(self.page.state(), before)

    def test_a_link_is_pasted(self):
        self.page.put_into_clipboard("https://example.org/sandbox/" + native.fragment("teapot"))
        self.page.mouse("mouseMoved", VIEW)
        self.page.key("KeyV", browser.CTRL, commands=["paste"])
        self.assertEqual(self.page.field("scene"), native.state("teapot")["scene"])


class Touch(browser.Checked):
    def setUp(self):
        # One browser per test: after a two-finger gesture, Chromium sends no touches to the next page that it loads.
        self.page = browser.Page(size=(1024, 768), touch=True)
        self.addCleanup(self.page.close)
        self.page.open()

    def slide(self, starts, ends, steps=6):
        self.page.fingers("touchStart", *starts)
        for step in range(1, steps + 1):
            share = step / steps
            self.page.fingers("touchMove", *[tuple(a + (b - a) * share for a, b in zip(start, end))
                                             for start, end in zip(starts, ends)])
        self.page.fingers("touchEnd")
        self.page.settle()

    def test_one_finger_drags_a_slider(self):
        x, y = self.page.place("projection/fovy")
        before = self.page.field("projection.fovy")
        self.slide([(x, y)], [(x + 40, y)])
        self.assertGreater(self.page.field("projection.fovy"), before + 5)

    def test_one_finger_taps_a_control(self):
        at = self.page.place("depth/Depth test")
        self.page.fingers("touchStart", at)
        self.page.fingers("touchEnd")
        self.page.settle()
        self.assertFalse(self.page.field("depth.test"))

    def test_a_finger_that_rests_in_the_picture_asks_why(self):
        before = self.page.state()
        self.page.fingers("touchStart", (500, 300))
        begun = time.monotonic()
        while self.page.state()["view"]["lower_right"] != "why" and time.monotonic() - begun < browser.PATIENCE_S:
            time.sleep(0.1)
        self.page.fingers("touchEnd")
        self.page.settle()
        after = self.page.state()
        self.assertEqual(after["view"]["lower_right"], "why")
        self.assertEqual(after["camera"], before["camera"])
        self.assertEqual(after["follow"], before["follow"])  # the finger's end is no click

    def test_a_finger_that_rests_on_a_slider_resets_nothing(self):
        at = self.page.place("projection/fovy")
        self.slide([at], [(at[0] + 40, at[1])])
        before = self.page.field("projection.fovy")
        self.page.fingers("touchStart", (at[0] + 40, at[1]))
        time.sleep(0.8)
        self.page.fingers("touchEnd")
        self.page.settle()
        self.assertAlmostEqual(self.page.field("projection.fovy"), before, delta=3)

    def test_two_fingers_zoom(self):
        before = self.page.state()["camera"]
        self.slide([(480, 300), (520, 300)], [(400, 300), (600, 300)])
        after = self.page.state()["camera"]
        self.assertGreater(along(ahead(before), before["position"], after["position"]), 0.1)

    def test_two_fingers_side_by_side_shift_the_camera(self):
        before = self.page.state()["camera"]
        self.slide([(480, 300), (520, 300)], [(560, 300), (600, 300)])
        after = self.page.state()["camera"]
        self.assertNotEqual(after["position"], before["position"])
        self.assertAlmostEqual(along(ahead(before), before["position"], after["position"]), 0, delta=0.05)

    def test_two_fingers_leave_nothing_held(self):
        self.slide([(480, 300), (520, 300)], [(400, 300), (600, 300)])
        before = self.page.state()
        self.page.mouse("mouseMoved", (560, 340))
        self.page.settle()
        self.assertEqual(self.page.state(), before)

    def test_a_number_opens_the_on_screen_keyboard(self):
        self.page.double_click("projection/fovy", pointer="touch")
        self.assertEqual(self.page.js("document.activeElement.id"), "typed")
        self.page.cdp("Input.insertText", text="62")  # as an on-screen keyboard does: no keys
        self.page.key("Enter")
        self.assertEqual(self.page.field("projection.fovy"), 62)


if __name__ == "__main__":
    unittest.main()
