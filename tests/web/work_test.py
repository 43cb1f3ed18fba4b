"""Long work continues between frames while the page stays usable, and finishes."""
import csv
import re
import time
import unittest

import browser
import native


class Work(browser.Test):
    options = {"size": (1280, 1300)}  # so tall that the panel needs no scrolling

    def test_it_finds_a_view_where_the_key_fails(self):
        self.page.open(native.fragment("opening", "--set", "scene=sort-key-farthest", "--set", "visibility.method=painter"))
        before = self.page.state()["camera"]
        self.page.click("Find a view where this key fails")
        self.assertNotEqual(self.page.state()["camera"], before)

    def test_costs_are_measured_and_saved_while_the_page_is_in_use(self):
        self.page.open(native.fragment("cyclic-overlap", "--set", "view.lower_left=growth"))
        at, there = self.page.place("Measure"), self.page.place("projection/fovy")
        before = self.page.field("projection.fovy")
        turns = self.page.js("watched.turns")
        self.page.mouse("mouseMoved", at)
        self.page.mouse("mousePressed", at, "left", 1, clickCount=1)
        self.page.mouse("mouseReleased", at, "left", 0, clickCount=1)
        self.page.until("the work", lambda: self.page.js("watched.turns") > turns + 2)
        self.page.mouse("mouseMoved", there)
        self.page.mouse("mousePressed", there, "left", 1, clickCount=1)
        self.page.mouse("mouseReleased", there, "left", 0, clickCount=1)
        self.page.until("the slider's response", lambda: self.page.field("projection.fovy") != before)
        turns = self.page.js("watched.turns")
        self.page.until("more of the work", lambda: self.page.js("watched.turns") > turns)
        self.page.until("the end of the work", lambda: self.page.js("Module._page_rests()"))
        self.page.click("Save CSV")
        rows = list(csv.reader(self.page.downloaded("viewing-growth*.csv").read_text().splitlines()))
        self.assertGreater(len(rows), 10)
        self.assertEqual({len(row) for row in rows}, {len(rows[0])})


class InOneGo(browser.Test):
    """Browsers without JavaScript Promise Integration: the same result, and the reason why the page did not respond."""
    options = {"size": (1280, 1300)}

    def test_the_reason_for_a_stall_is_reported(self):
        self.page.cdp("Page.addScriptToEvaluateOnNewDocument", source="delete WebAssembly.Suspending; delete WebAssembly.promising")
        self.page.open(native.fragment("cyclic-overlap", "--set", "view.lower_left=growth"))
        self.assertNotIn("froze", self.page.told(), "short stalls are not reported")
        begun = time.monotonic()
        self.page.click("Measure")
        took = time.monotonic() - begun
        told = re.search(r"This took ([0-9.]+) s, and the page froze", self.page.told())
        self.assertIsNotNone(told, self.page.told())
        self.assertGreaterEqual(float(told[1]), 0.5)
        self.assertLess(float(told[1]), took)
        self.page.click("Save CSV")
        self.assertGreater(len(self.page.downloaded("viewing-growth*.csv").read_text().splitlines()), 10)


if __name__ == "__main__":
    unittest.main()
