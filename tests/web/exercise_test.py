"""A student in the browser: an exercise is answered wrongly and rightly, saved as a download, and graded by the program."""
import unittest

import browser
import native
import student

def shadow_matrix(plane, light):
    """S = (P·L) I − L Pᵀ, as in the lecture."""
    factor = sum(p * l for p, l in zip(plane, light))
    return [[(factor if row == column else 0) - light[row] * plane[column] for column in range(4)] for row in range(4)]


class Exercise(student.Student, browser.Test):
    options = {"size": student.SIZE}

    def grade(self, file, status):
        header, line = native.run("grade", file, "--set", "E16", "--format", "csv", status=status).decode().splitlines()[:2]
        return dict(zip(header.split(","), line.split(",")))

    def test_the_last_input_is_saved_when_the_page_closes(self):
        self.page.open()
        self.page.js("localStorage.clear()")  # as another student's browser
        self.open_exercise()
        self.page.double_click("lesson strip/answers/answer/r0c0")
        kept = self.page.js("""(() => {
            const typed = document.getElementById('typed');
            typed.value = '7.125';
            typed.dispatchEvent(new InputEvent('input'));
            for (const kind of ['keydown', 'keyup']) window.dispatchEvent(new KeyboardEvent(kind, {code: 'Enter', key: 'Enter'}));
            window.dispatchEvent(new Event('pagehide'));
            return Object.values(localStorage).join();
        })()""")
        self.assertIn("7.125", kept)

    def test_an_exercise_is_answered_saved_and_graded(self):
        page = self.page
        self.sign_in()
        self.choose_exercise()

        right = shadow_matrix(page.field("plane.equation"), page.field("light.position"))
        self.type_matrix([list(column) for column in zip(*right)])
        page.click("lesson strip/Check")
        graded = self.grade(self.save(), 1)
        self.assertIn(student.NUMBER, graded.values())
        self.assertIn("w:M33", graded.values(), "the misconception of a transposed matrix")

        self.type_matrix(right)
        page.click("lesson strip/Check")
        handed_in = self.save()
        graded = self.grade(handed_in, 0)
        self.assertIn("3", graded.values(), "the points")

        with self.subTest("kept over a reload"):
            page.settle(0.8)
            page.open()
            self.assertEqual(self.grade(self.save(), 0), graded)
        with self.subTest("opened elsewhere"):
            page.js("localStorage.clear()")
            page.open()
            page.cdp("Page.setInterceptFileChooserDialog", enabled=True)
            page.click("top/Exercises")
            page.click("exercises/Open answers…")
            page.driver.find_element("id", "file").send_keys(str(handed_in))
            page.settle()
            self.assertEqual(self.grade(self.save(), 0), graded)


if __name__ == "__main__":
    unittest.main()
