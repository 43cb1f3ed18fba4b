"""Small valid inputs of every format that the program reads; tests/hostile/run breaks them by structure.

The program itself writes those that it can, so that they have every existing field.
"""
import json
import subprocess
from pathlib import Path

SCENE = {"title": "Room", "objects": [
    {"name": "box", "shape": "box", "position": [0, 1, 0], "rotation": [10, 0, 0], "scale": [1, 1, 1],
     "color": "#5a9ef0"},
    {"name": "tri", "shape": "triangle", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]},
    {"name": "mesh", "shape": "mesh", "file": "mesh.obj", "position": [2, 1, 0]}]}

FLIGHT = {"version": 1, "kind": "flight", "seconds": 1.05, "state": {"camera": {"yaw": 20}}, "frames": [
    {"t": 0.25, "set": {"camera.yaw": 25.000000000000004, "light.position": [1, 5, 2, 1]}},
    {"t": 0.5, "set": {"camera.position": [3.3, 2.1, 6.6], "projection.near": 0.7}},
    {"t": 0.5, "set": {"scene": "letters", "view.shows": "facing"}}]}

SUITE = {"suite": 1, "title": "Two", "references": "references", "report": "report",
         "defaults": {"size": [64, 36], "samples": 0, "worst": 3, "share": 0.002},
         "entries": [
             {"name": "opening", "about": "first", "masks": [[0, 0, 8, 8], "mask.png"]},
             {"name": "own", "state": "state.json", "set": {"projection.near": 0.1}, "view": "depth"},
             {"name": "written", "state": {"shadow": {"opacity": 0.8}}, "profile": "portable", "reach": 1},
             {"name": "S", "state": "shadow-derivation", "picture": False, "matrices": {"tolerance": 1e-9}},
             {"name": "order", "picture": False, "measure": {"what": "order", "tolerance": 0.02}},
             {"name": "said", "set": ["light.position=[1,0,0,1]"], "problems": {"must": ["plane"], "must_not": []}}],
         "loosened": [{"name": "own", "about": "noise", "share": 0.06}]}

LESSON = {"lesson": 1, "id": "mine", "title": {"en": "My lesson", "ko": "수업"}, "steps": [
    {"id": "nearer", "state": {"preset": "depth-fighting", "set": {"projection.near": 0.1}},
     "layout": {"big": "camera", "lower_left": "fighting", "controls": ["projection.near"]},
     "say": "z-near is 0.1.", "cover": ["column:fighting.safe_gap"],
     "ask": {"kind": "number", "question": "How wide is a code?", "expect": "depth_step(84)", "tol_rel": 0.05,
             "wrong": [{"when": "answer == 0.1", "try": 0.1, "say": "That is z-near."}], "hints": ["z² ÷ n"]},
     "reveal": {"set": {"projection.near": 1}, "over_s": 2, "say": "A tenth of it."},
     "claims": ["depth_step(84) < 1"]},
    {"id": "which", "state": {"set": {}}, "say": "Two ways.",
     "ask": {"kind": "choice", "question": "Which?", "choices": [
         {"say": "left", "right": True}, {"say": "right", "why": "No."}]},
     "reveal": {"say": "This."}}]}

EXERCISE = {"exercise": 1, "id": "X1-eye", "title": "The eye", "sets": ["mine"], "points": 2,
            "tags": {"M1": "a misconception"}, "pick": {"x": [2, 3, 4], "h": [20, 40]},
            "require": ["x ~= 3 or h ~= 40"],
            "step": {"state": {"preset": "opening",
                               "set": {"camera.position": "={x, 1.5, 5}", "camera.yaw": "=h"}},
                     "cover": ["control:camera", "matrix:C", "view:observer"],
                     "ask": {"kind": "vector", "question": "The heading is {h}°. Where is the eye?",
                             "expect": "=camera.position", "tol": 0.03,
                             "wrong": [{"value": "={V[0][3], V[1][3], V[2][3]}", "tag": "M1",
                                        "say": "That is V's last column."}]}}}

HAND_IN = {"answers": 1, "program": "0.1.0", "course": "viewing-2026", "student": "32201234", "name": "김학생", "items": [
    {"exercise": "E16-shadow-matrix", "variant": 0, "attempts": [
        {"at": "2026-11-21T10:03:12", "answer": [[4, -1, 0, 0], [0, 0, 0, 0], [0, -1, 4, 0], [0, -1, 0, 4]],
         "told": "no"}, {"at": "2026-11-21T10:04:00", "hint": 1}]},
    {"exercise": "E18-place-the-light", "variant": 0,
     "attempts": [{"at": "2026-11-21T10:05:00", "set": {"light.position": [1, 4, 1, 1]}}]}]}

OBJ = ("# a tetrahedron\nmtllib none.mtl\no body\ng side\nusemtl red\ns 1\n"
       "v 0 0 0\nv 2 0 0\nv 0 2 0 0.5 0.5 0.5\nv 0 0 2\nvt 0 0\nvn 0 0 1\n"
       "f 1//1 3//1 2//1\nf 1/1 2/1 4/1\nf -4 -1 -2\nf 2 3 4\n")

PIXELS = "0,0\n31,17\n63,35\n"

EXPRESSIONS = ["S[0][3]", "facts.plane_dot_light", "transpose(S)[1][2]", "depth_step(84)", "camera.position",
               "V[0][0] * 2 + 1", "fighting().wrong_fraction", "det(R)"]


class Forms:
    """`program` makes the figures, pictures, links and the complete state."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = Path(folder)
        self.fields = json.loads(self.said("params", "--format", "json"))
        self.state = json.loads(self.said("state"))
        self.link = self.said("state", "tilted-plane", "--link").strip()
        self.presets = [line.split()[0] for line in self.said("presets").splitlines() if line.strip()]
        small = ("--view", "camera", "--size", "64x36", "--samples", "0")
        self.pictures = {}
        for name, words in {"reference.png": small, "mask.png": ("--view", "depth", "--size", "64x36"),
                            "figure.svg": ("--view", "matrices", "--size", "480x320"),
                            "figure.pdf": ("--view", "matrices", "--size", "480x320")}.items():
            self.said("snapshot", *words, "-o", str(self.folder / name))
            self.pictures[name] = (self.folder / name).read_bytes()
        self.documents = {"state": self.state, "scene": SCENE, "flight": FLIGHT, "suite": SUITE, "lesson": LESSON,
                          "exercise": EXERCISE, "hand-in": HAND_IN}

    def said(self, *words):
        ended = subprocess.run([self.program, *words], capture_output=True, text=True, timeout=120, check=False)
        if ended.returncode != 0:
            raise RuntimeError(f"{' '.join(words)}: exit {ended.returncode}: {ended.stderr}")
        return ended.stdout

    def paths(self):
        """Returns the paths of the state file, for --set and --vary."""
        return [field["path"] for field in (self.fields["params"] if isinstance(self.fields, dict) else self.fields)]
