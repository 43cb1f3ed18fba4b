"""A lesson from its first step to its last, answered by mouse and keyboard, and presented with a clicker."""
import json
import re
import unittest

import browser
import native

LESSON = native.ROOT / "assets/lessons/01-view-is-the-inverse.json"


def said(text):
    """Returns the longest part of a text between its {expressions}."""
    return max(re.split(r"{[^}]*}", text), key=len)


class Lesson(browser.Test):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.lesson = json.loads(LESSON.read_text(encoding="utf-8"))
        cls.name = cls.lesson["id"]

    def at(self, step):
        self.assertEqual(self.page.opened(), f"#lesson={self.name}&step={step}")
        self.assertIn(f"{step} / {len(self.lesson['steps'])}", self.page.told())

    def has(self, settings):
        """Checks that the state has these values."""
        for path, value in (settings or {}).items():
            self.assertEqual(self.page.field(path), value, path)

    def answer(self, step, position):
        """Gives the right answer by mouse and keyboard."""
        ask = step["ask"]
        if ask["kind"] == "choice":
            right = [number for number, choice in enumerate(ask["choices"], 1) if choice.get("right")]
            self.page.click(f"lesson strip/answers/choice {right[0]}")
            return
        # A question with apply() asks where V sends the origin: to −position, as the camera has no rotation. Any other
        # question asks for the camera's position.
        vector = [-value for value in position] if "apply" in ask["expect"] else position
        for name, value in zip("xyz", vector):
            self.page.enter(f"lesson strip/answers/answer/{name}", f"{value:g}")
        self.page.click("lesson strip/Check")

    def test_every_step_can_be_answered(self):
        self.page.open(f"#lesson={self.name}")
        for number, step in enumerate(self.lesson["steps"], 1):
            with self.subTest(step["id"]):
                self.at(number)
                self.has(step["state"].get("set"))
                self.assertIn(step["ask"]["question"]["en"], self.page.told())
                revealed = said(step["reveal"]["say"]["en"])
                self.assertNotIn(revealed, self.page.told())
                if step["ask"]["kind"] != "goal":
                    self.answer(step, self.page.field("camera.position"))
                self.page.mouse("mouseMoved", (600, 200))
                # Whatever the answer was, the reveal comes next.
                if revealed not in self.page.told():
                    self.page.key("PageDown")
                self.assertIn(revealed, self.page.told())
                self.assertNotIn("{", self.page.told())  # its numbers are filled in
                self.has(step["reveal"].get("set"))
                self.page.key("PageDown")
        self.at(len(self.lesson["steps"]))

    def test_a_wrong_choice_is_explained(self):
        self.page.open(f"#lesson={self.name}")
        self.page.click("lesson strip/answers/choice 1")
        self.assertIn(self.lesson["steps"][0]["ask"]["choices"][0]["why"]["en"], self.page.told())

    def test_a_clicker_leads_through_the_lesson(self):
        steps = len(self.lesson["steps"])
        self.page.open(f"#lesson={self.name}")
        self.page.key("F5")
        self.at(1)
        for _ in range(2 * steps):
            self.page.key("PageDown")
        self.at(steps)
        self.page.key("PageUp")  # first hides the card that ends the lesson
        self.at(steps)
        self.page.key("PageUp")
        self.page.key("PageUp")
        self.at(steps - 1)


if __name__ == "__main__":
    unittest.main()
