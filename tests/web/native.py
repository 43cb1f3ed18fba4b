"""The program built for this machine, the reference for the page."""
import json
import os
import pathlib
import subprocess

from PIL import Image, ImageChops

ROOT = pathlib.Path(__file__).parents[2]
PROGRAM = pathlib.Path(os.environ.get("VIEWING_SANDBOX", ROOT / "build/release/viewing-sandbox"))


def run(*arguments, status=0):
    """Returns standard output and checks the exit status."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, timeout=300)
    assert done.returncode == status, f"viewing-sandbox {' '.join(map(str, arguments))}: {done.stderr.decode().strip()}"
    return done.stdout


def presets():
    return [entry["name"] for entry in json.loads(run("presets", "--json")) if entry["kind"] == "preset"]


def state(argument="opening", *more):
    return json.loads(run("state", argument, *more))


def fragment(argument="opening", *more):
    """Returns the address fragment of this state: "#1…"."""
    return "#" + run("state", "--link", *more, "--", argument).decode().strip().split("#", 1)[1]


def camera(argument, size, to, *more):
    run("snapshot", argument, "--view", "camera", "--size", f"{size[0]}x{size[1]}", "--samples", 0, "-o", to, *more)
    return Image.open(to).convert("RGB")


def share_beyond(levels, one, other):
    """Returns the share of pixels with a channel that differs by more than `levels` of 255."""
    red, green, blue = ImageChops.difference(one, other).split()
    worst = ImageChops.lighter(ImageChops.lighter(red, green), blue).histogram()
    return sum(worst[levels + 1:]) / sum(worst)


def parameters(argument):
    """Returns only the fields of a state, without the file's description of itself."""
    told = ("title", "about", "group", "mended_by", "slides")
    return {name: value for name, value in state("--", argument).items() if name not in told}
