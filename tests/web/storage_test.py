"""Data kept by the browser, and the messages and offers when it keeps nothing."""
import contextlib
import json
import os
import random
import unittest

from selenium.common.exceptions import WebDriverException

import browser
import native
import student
from student import KEPT

ANSWERS = f"answers/{student.COURSE}~{student.NUMBER}.json"

FILL = """(() => {
    let text = 'x'.repeat(1 << 20), n = 0;
    while (text.length >= 1)
        try { localStorage.setItem('filler' + n++, text); } catch { text = text.slice(0, text.length >> 1); }
})()"""
IS_ASKED = """(() => {
    const event = new Event('beforeunload', {cancelable: true});
    window.dispatchEvent(event);
    return event.defaultPrevented;
})()"""
KEEP_LOOKS = """(async () => {
    const folder = '/home/web_user/.config/viewing-sandbox';
    FS.mkdirTree(folder);
    kept.keep(`${folder}/window.json`, new Uint8Array(9));
    await navigator.locks.request(net.kept, () => {});  // comes after the page's own
})()"""


class NotKept(student.Student, browser.Checked):
    def setUp(self):
        self.page = browser.Page(size=student.SIZE)
        self.addCleanup(self.page.close)

    def bar(self):
        return self.page.js("document.getElementById('bar').hidden ? '' : document.getElementById('bar-text').textContent")

    def press(self, label):
        """Returns a button of the bar."""
        [button] = [button for button in self.page.driver.find_elements("css selector", "#bar button") if button.text == label]
        button.click()
        self.page.settle()

    def attempts(self, file):
        hand_in = json.loads(file.read_text())
        self.assertEqual(hand_in["student"], student.NUMBER)
        return [attempt["answer"][0][0] for item in hand_in["items"] for attempt in item["attempts"]]

    def test_full_storage_is_reported_until_answers_are_saved(self):
        self.open_exercise()
        self.page.settle(0.8)
        self.assertEqual((self.bar(), self.page.js(IS_ASKED)), ("", False))
        self.page.js(FILL)
        self.answer(7)
        self.page.settle(0.8)
        self.assertRegex(self.bar(), r"full.* \d\d:\d\d .*lost when it closes\.$")
        self.assertTrue(self.page.js(IS_ASKED), "the page asks before it closes")
        bottom = self.page.js("document.getElementById('bar').getBoundingClientRect().bottom")
        self.assertEqual(self.page.js("document.getElementById('view').getBoundingClientRect().top"), bottom, "nothing is covered")
        self.press("Save answers")
        self.assertEqual(self.attempts(self.page.downloaded(f"{student.NUMBER}.json")), [7])
        self.assertEqual((self.bar(), self.page.js(IS_ASKED)), ("", False))
        self.answer(8)
        self.page.settle(0.8)
        self.assertNotEqual(self.bar(), "", "later answers are not saved")
        self.page.js("localStorage.clear()")
        self.answer(9)
        self.page.settle(0.8)
        self.assertEqual((self.bar(), self.page.js(IS_ASKED)), ("", False))
        self.assertIn("32201234", self.page.js("Object.keys(localStorage).join()"))

    def test_the_browser_is_asked_once_for_persistent_storage(self):
        self.page.cdp("Page.addScriptToEvaluateOnNewDocument", source="""
            window.asked = 0;
            if (navigator.storage) navigator.storage.persist = async () => { ++window.asked; return true; };""")
        self.open_exercise()
        self.page.settle(0.8)
        self.assertEqual(self.page.js("asked"), 0, "looks alone are no reason")
        for number in (7, 8):
            self.answer(number)
            self.page.settle(0.8)
            self.assertEqual(self.page.js("asked"), 1)

    def test_a_stopped_program_offers_unsaved_answers(self):
        self.open_exercise()
        self.page.js(FILL)
        self.answer(7)
        self.page.settle(0.8)
        self.page.js("setTimeout(() => Module._page_set(0xfffffff0))")
        self.page.until("the notice", self.page.notice)
        [button] = [button for button in self.page.driver.find_elements("css selector", "#notice button") if student.NUMBER in button.text]
        button.click()
        self.assertEqual(self.attempts(self.page.downloaded(f"{student.NUMBER}.json")), [7])
        self.page.complaints()  # discards the messages about the trap, which are expected

    def test_blocked_storage_is_reported_for_looks_and_answers(self):
        self.page.close()
        self.page = browser.Page(size=student.SIZE, may_keep=False)
        self.page.open()
        self.assertEqual(self.page.js("(() => { try { return localStorage.length } catch (error) { return error.name } })()"),
                         "SecurityError", "as in a frame of another site, or with sandbox")
        self.sign_in()
        self.page.settle(0.8)
        self.assertRegex(self.bar(), r"not let this page save anything.*theme.*closes\.$")
        self.press("Hide")
        self.assertEqual(self.bar(), "")
        self.choose_exercise()
        self.answer(7)
        self.page.settle(0.8)
        self.assertRegex(self.bar(), r"not let this page save anything.*answers since \d\d:\d\d .*closes\.$")
        self.press("Save answers")
        self.assertEqual(self.attempts(self.page.downloaded(f"{student.NUMBER}.json")), [7])

    def test_an_embed_does_not_mention_looks(self):
        self.page.open("#embed&preset=teapot")
        self.page.js(FILL)
        self.page.js(KEEP_LOOKS)
        self.assertEqual(self.bar(), "")
        self.page.open("#preset=teapot")
        self.page.js(KEEP_LOOKS)
        self.assertNotEqual(self.bar(), "")


# Runs in a tab as if another tab had written `hand_in`, with one attempt, `count` times; the attempts are numbered from
# `first` on. The program merges each `hand_in` with its own data and writes the result. Resolves when all is saved.
WRITE = """
const [name, hand_in, first, count, done] = arguments;
const [attempt] = hand_in.items[0].attempts;
let sent = 0;
const next = () => {
  if (sent === count) return net.unkept.size ? setTimeout(next) : done();
  const number = first + sent++;
  attempt.at = new Date(86400000 * number).toISOString().slice(0, 19);
  attempt.answer[0][0] = number;
  window.dispatchEvent(new StorageEvent('storage', {key: name, newValue: JSON.stringify(hand_in)}));
  setTimeout(next);
};
next();
"""


class TwoTabs(student.Student, browser.Checked):
    """Tabs of one browser write the same files: neither loses data saved by the other."""

    def setUp(self):
        self.page = browser.Page(size=student.SIZE)
        self.addCleanup(self.page.close)
        self.open_exercise()
        self.tabs = [self.page.driver.current_window_handle]
        self.tabs.append(self.open_tab())
        self.page.click("top/Exercises")
        self.choose_exercise()

    def open_tab(self):
        """Opens a separate window, because a hidden tab draws nothing and its timers run once a second."""
        self.page.driver.switch_to.new_window("window")
        self.page.cdp("Page.addScriptToEvaluateOnNewDocument", source=browser.WATCH)
        self.page.resize(student.SIZE)
        self.page.open()
        return self.page.driver.current_window_handle

    def kill(self, tab):
        """Simulates a killed process; another one replaces it."""
        self.to(tab)
        with contextlib.suppress(WebDriverException):
            self.page.cdp("Page.crash")
        self.page.driver.switch_to.window(self.tabs[1 - tab])
        self.tabs[tab] = self.open_tab()
        self.page.click("top/Exercises")  # reads the answers

    def to(self, tab):
        self.page.driver.switch_to.window(self.tabs[tab])
        self.page.cdp("Page.bringToFront")
        self.page.settle()

    def kept(self, name):
        return json.loads(self.page.js("localStorage.getItem(arguments[0])", KEPT + name))

    def keep(self, name, text):
        """Writes as another tab would, before its event arrives: a tab gets no events of its own writes."""
        self.page.js("localStorage.setItem(arguments[0], arguments[1])", KEPT + name, text)

    def with_another(self, number):
        """Returns the saved hand-in, one attempt, and another one."""
        hand_in = self.kept(ANSWERS)
        [item] = hand_in["items"]
        [attempt] = item["attempts"]
        item["attempts"].append(dict(attempt, answer=[[number] + attempt["answer"][0][1:]] + attempt["answer"][1:], at="2026-01-01T00:00:00"))
        return hand_in

    def answers(self):
        return sorted(attempt["answer"][0][0] for item in self.kept(ANSWERS)["items"] for attempt in item["attempts"])

    def test_answers_of_both_are_kept(self):
        for number, tab in ((1, 1), (2, 0), (3, 1), (4, 0)):
            self.to(tab)
            self.answer(number)
            self.page.settle(0.8)
        for tab in (0, 1):
            self.to(tab)
            self.page.until("all four", lambda: self.answers() == [1, 2, 3, 4])

    def test_simultaneous_writes_are_merged(self):
        """This tab gets no event for the other's write, as between two processes."""
        self.to(0)
        self.answer(1)
        self.page.settle(0.8)
        self.keep(ANSWERS, json.dumps(self.with_another(5)))
        self.answer(2)
        self.page.until("all three", lambda: self.answers() == [1, 2, 5])

    def test_looks_of_one_and_progress_of_the_other_are_kept(self):
        self.to(0)
        self.page.open("#lesson=lens")
        for _ in range(4):
            self.page.key("PageDown")
        self.page.settle(0.8)
        self.to(1)
        self.page.open()
        self.page.click("top/Look")
        self.page.click("Light")
        self.page.key("Escape")
        self.page.settle(0.8)
        self.to(0)
        self.page.key("PageDown")
        self.page.key("PageDown")
        self.page.settle(0.8)
        self.page.until("both", lambda: self.kept("window.json").get("theme") == "light" and self.kept("window.json")["lessons"]["lens"]["step"] == 4)

    def test_writes_during_loading_are_merged(self):
        self.to(0)
        self.answer(1)
        self.page.settle(0.8)
        other = self.with_another(5)
        early = f"""document.addEventListener('DOMContentLoaded', () => {{
            const key = {json.dumps(KEPT + ANSWERS)}, newValue = {json.dumps(json.dumps(other))};
            localStorage.setItem(key, newValue);
            window.dispatchEvent(new StorageEvent('storage', {{key, newValue}}));
        }})"""
        script = self.page.cdp("Page.addScriptToEvaluateOnNewDocument", source=early)["identifier"]
        self.page.driver.refresh()
        self.page.settle()
        self.page.cdp("Page.removeScriptToEvaluateOnNewDocument", identifier=script)
        self.page.click("top/Exercises")
        self.choose_exercise()
        self.answer(2)
        self.page.until("all three", lambda: self.answers() == [1, 2, 5])

    def test_all_writes_of_killed_windows_are_kept(self):
        """Both write in parallel; one is killed as soon as its own writes are saved, and another replaces it. About 80
        writes; 1,000 with TEST_ALL=1."""
        seed, is_long = 20261126, "TEST_ALL" in os.environ
        random_number = random.Random(seed)
        self.to(0)
        self.answer(0)
        self.page.settle(0.8)
        hand_in, name, expected = self.kept(ANSWERS), KEPT + ANSWERS, {0}
        for turn in range(6 if is_long else 2):
            counts = (random_number.randint(40, 120), 90) if is_long else (random_number.randint(10, 30), 20)
            first = [1000 * (2 * turn + tab + 1) for tab in (0, 1)]
            expected |= {first[tab] + i for tab in (0, 1) for i in range(counts[tab])}
            hand_in["items"][0]["exercise"] = ("E01", "E02")[turn % 2]  # each has at most 1,000 attempts
            self.to(1)
            self.page.driver.execute_script(f"window.written = new Promise((done) => ((...arguments) => {{{WRITE}}})(...arguments, done))",
                                            name, hand_in, first[1], counts[1])
            self.to(0)
            self.page.driver.execute_async_script(WRITE, name, hand_in, first[0], counts[0])
            self.kill(0)
            self.to(1)
            self.page.driver.execute_async_script("written.then(arguments[0])")
        lost = sorted(expected - set(self.answers()))
        self.assertEqual(lost, [], f"{len(lost)} of {len(expected)}; seed {seed}")

    def test_unreadable_data_is_kept_under_another_name(self):
        self.keep(ANSWERS, "{cut off")
        self.page.driver.refresh()
        self.page.settle()
        self.page.click("top/Exercises")
        self.choose_exercise()
        self.answer(1)
        self.page.settle(0.8)
        self.assertEqual(self.answers(), [1])
        self.assertIn("{cut off", self.page.js("Object.values(localStorage)"))


if __name__ == "__main__":
    unittest.main()
