"""A student at an exercise of the page: shared by the tests of answers and of their storage."""
import json

import browser

KEPT = "viewing-sandbox:/home/web_user/.config/viewing-sandbox/"
NUMBER, COURSE = "32201234", "viewing-2026"
SIZE = (960, 600)  # a frame costs its pixels: enough for the exercise and its answers


class Student:
    """For tests with a page of SIZE."""

    def fill_in(self, label, text):
        self.page.click(label)
        self.page.key("KeyA", browser.CTRL)
        self.page.type(text)

    def type_matrix(self, matrix):
        """Types from entry to entry by Tab, faster than the page draws."""
        self.page.double_click("lesson strip/answers/answer/r0c0")
        for row in matrix:
            for number in row:
                self.page.strike(f"{number:g}")
                self.page.press("Tab")
        self.page.key("Enter")

    def save(self):
        self.page.click("top/Exercises")
        self.page.click("exercises/Save answers…")
        self.page.click("Save")
        return self.page.downloaded("*.json")

    def sign_in(self):
        self.page.open()
        self.page.click("top/Exercises")
        self.fill_in("exercises/Student number", NUMBER)
        self.fill_in("exercises/Course", COURSE)
        self.page.key("Enter")

    def choose_exercise(self):
        """Opens the exercise on the shadow matrix from the exercise page."""
        page = self.page
        while (at := page.place("exercises/card 16"))[1] > SIZE[1] - 50:
            page.wheel((SIZE[0] / 2, SIZE[1] / 2), -2)
        page.click(at)
        self.assertIn("shadow matrix", page.told())

    def come_back(self):
        """Opens the page as in a browser in which the student has signed in before."""
        self.page.open()
        remembered = {"student": {"course": COURSE, "number": NUMBER, "name": ""}}
        self.page.js("localStorage.setItem(arguments[0], arguments[1])", KEPT + "window.json", json.dumps(remembered))
        self.page.open()
        self.page.click("top/Exercises")

    def open_exercise(self):
        self.come_back()
        self.choose_exercise()

    def answer(self, number):
        """Types one number of the matrix and presses Check."""
        self.page.double_click("lesson strip/answers/answer/r0c0")
        self.page.type(f"{number:g}")
        self.page.key("Enter")
        self.page.click("lesson strip/Check")
