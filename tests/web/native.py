"""The program as it is built for this machine: what the page is held against."""
import json
import os
import pathlib
import subprocess

from PIL import Image, ImageChops

ROOT = pathlib.Path(__file__).parents[2]
PROGRAM = pathlib.Path(os.environ.get("VIEWING_SANDBOX", ROOT / "build/release/viewing-sandbox"))


def run(*arguments, status=0):
    """Standard output, of a call that ends with this status."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, timeout=300)
    assert done.returncode == status, f"viewing-sandbox {' '.join(map(str, arguments))}: {done.stderr.decode().strip()}"
    return done.stdout


def presets():
    return [entry["name"] for entry in json.loads(run("presets", "--json")) if entry["kind"] == "preset"]


def state(argument="opening", *more):
    return json.loads(run("state", argument, *more))


def fragment(argument="opening", *more):
    """What stands behind an address for this state: "#1…"."""
    return "#" + run("state", "--link", *more, "--", argument).decode().strip().split("#", 1)[1]


def camera(argument, size, to, *more):
    run("snapshot", argument, "--view", "camera", "--size", f"{size[0]}x{size[1]}", "--samples", 0, "-o", to, *more)
    return Image.open(to).convert("RGB")


def share_beyond(levels, one, other):
    """The share of the pixels a channel of which differs by more than so many levels of 255."""
    red, green, blue = ImageChops.difference(one, other).split()
    worst = ImageChops.lighter(ImageChops.lighter(red, green), blue).histogram()
    return sum(worst[levels + 1:]) / sum(worst)


def parameters(argument):
    """Of a state its fields alone, without what a file says about itself."""
    told = ("title", "about", "group", "mended_by")
    return {name: value for name, value in state("--", argument).items() if name not in told}
