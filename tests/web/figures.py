"""Times and sizes of the page in both drivers, as a table: nothing here passes or fails. The machine should be idle.
Run by tests/web/run --figures."""
import gzip
import math
import pathlib
import shutil
import statistics
import tempfile
import time

import browser
import native

# Measures stalls of the main thread: the gaps between consecutive turns of a chain of timers. Beside each gap it counts
# the time that the page spent in frames, and the part of it in GL calls that wait for drawing (done by the CPU here).
MEASURE = """(() => {
  const kept = window.kept = {gaps: [], frames: [], frame_ms: 0, gl_ms: 0, draws: 0};
  const timed = (object, name, note) => {
    const does = object[name];
    object[name] = function (...values) {
      const begun = performance.now();
      try {
        return does.apply(this, values);
      } finally {
        note(performance.now() - begun);
      }
    };
  };
  timed(GLctx, 'drawElements', () => { ++kept.draws; });
  timed(Module, '_page_frame', (ms) => {
    if (kept.draws) kept.frames.push(ms);  // else it has given its turn back
    kept.draws = 0;
    kept.frame_ms += ms;
  });
  for (const name of ['readPixels', 'getBufferSubData', 'clientWaitSync', 'finish', 'getParameter', 'getError',
                      'checkFramebufferStatus', 'getProgramParameter', 'getShaderParameter'])
    timed(GLctx, name, (ms) => { kept.gl_ms += ms; });
  let last = performance.now(), frame_ms = 0, gl_ms = 0;
  const turn = () => {
    const now = performance.now();
    kept.gaps.push([now - last, kept.frame_ms - frame_ms, kept.gl_ms - gl_ms]);
    [last, frame_ms, gl_ms] = [now, kept.frame_ms, kept.gl_ms];
    setTimeout(turn);
  };
  turn();
})()"""


def kept(page):
    return page.js("(() => { const {gaps, frames} = kept; kept.gaps = []; kept.frames = []; return {gaps, frames}; })()")


def row(name, value, note=""):
    print(f"| {name} | {value} | {note} |", flush=True)


def sizes():
    for name in ("viewing-sandbox.wasm", "viewing-sandbox.js", "page.js", "index.html", "page.css", "viewing-sandbox.html"):
        data = (browser.FOLDER / name).read_bytes()
        row(name, f"{len(data):,} B", f"gzipped {len(gzip.compress(data, 9)):,} B")


def first_frames(page):
    times = []
    for _ in range(5):
        page.open()
        times.append(page.js("watched.first"))
    row("first frame after navigation", f"{statistics.median(times):.0f} ms", f"{min(times):.0f} to {max(times):.0f} of {len(times)}, local server")


def rest(page):
    page.mouse("mouseMoved", (2, 2))
    page.settle(1.5)
    before = page.frames()
    time.sleep(5)
    row("frames in 5 s of rest", page.frames() - before)


def in_flight(page, name, act):
    page.js(MEASURE)
    kept(page)
    begun = time.monotonic()
    act()
    took = time.monotonic() - begun
    measured = kept(page)
    frames = sorted(measured["frames"])
    if not frames:
        return row(name, "no frames")
    waits = sum(gl for _, _, gl in measured["gaps"]) / len(frames)
    row(name, f"{statistics.median(frames):.1f} ms a frame", f"95%: {frames[int(0.95 * (len(frames) - 1))]:.1f} ms; of it waiting for GL "
        f"{waits:.1f} ms on average; {len(frames) / took:.1f} frames/s")


def fly(page):
    page.key_down("KeyW")
    time.sleep(3)
    page.key_up("KeyW")
    page.settle()


def hover(page):
    for step in range(60):
        page.mouse("mouseMoved", (400 + 4 * step, 250))
    page.settle()


def stalls(page, name, fragment, act_at):
    """`act_at`, a function of the page, prepares and returns the function that acts."""
    page.open(fragment)
    act = act_at(page)
    page.js(MEASURE)
    page.settle()
    kept(page)
    begun = time.monotonic()
    act()
    took = time.monotonic() - begun
    gaps = kept(page)["gaps"]
    longest, frame, gl = max(gaps)
    work = max(whole - frame for whole, frame, _ in gaps)
    own = max(whole - gl for whole, _, gl in gaps)
    row(name, f"{longest:.0f} ms at most", f"in that frames {frame:.0f} ms, waiting for GL {gl:.0f} ms; the longest without frames {work:.0f} ms, "
        f"without waits for GL {own:.0f} ms; {took:.1f} s in all")


def clicking(label):
    def act_at(page):
        at = page.place(label)
        return lambda: page.click(at)
    return act_at


def dropping_torus(around, along):
    """A mesh of 2 × around × along triangles."""
    def act_at(page):
        file = page.home / "torus.obj"
        angles = [[2 * math.pi * i / count for i in range(count)] for count in (around, along)]
        points = [((1 + 0.4 * math.cos(b)) * math.cos(a), 1.5 + 0.4 * math.sin(b), (1 + 0.4 * math.cos(b)) * math.sin(a))
                  for a in angles[0] for b in angles[1]]
        corners = lambda i, j: ((i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j))
        faces = [[a % around * along + b % along + 1 for a, b in corners(i, j)] for i in range(around) for j in range(along)]
        file.write_text("".join(f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in points) +
                        "".join(f"f {' '.join(map(str, face))}\n" for face in faces), encoding="utf-8")

        def act():
            page.drop(file)
            page.until("the mesh", lambda: str(page.field("scene")).endswith("torus.obj"))
            page.settle()
        return act
    return act_at


# One rotating mesh, drawn by a well-known library: the minimum cost of a page with a picture on this machine.
THREE = pathlib.Path("/usr/share/javascript/three/three.min.js")  # from Debian's libjs-three
THREE_PAGE = """<!DOCTYPE html><title>one mesh</title><style>body { margin: 0 } canvas { display: block }</style>
<script src="three.min.js"></script><script>
  const canvas = document.body.appendChild(document.createElement('canvas'));
  const renderer = new THREE.WebGLRenderer({canvas, context: canvas.getContext('webgl2', {antialias: true})});
  renderer.setSize(innerWidth, innerHeight);
  const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(55, innerWidth / innerHeight, 0.5, 40);
  camera.position.z = 4;
  const light = new THREE.DirectionalLight(0xffffff, 1);
  light.position.set(1, 2, 3);
  const mesh = new THREE.Mesh(new THREE.TorusBufferGeometry(1, 0.4, 32, 64), new THREE.MeshPhongMaterial({color: 0xe08030}));
  scene.add(light, mesh);
  const frames = [];
  requestAnimationFrame(function draw() {
    const begun = performance.now();
    mesh.rotation.y += 0.02;
    renderer.render(scene, camera);
    frames.push(performance.now() - begun);
    requestAnimationFrame(draw);
  });
</script>"""


def one_mesh_by_three(driver):
    """The same figures for a page with one mesh of 4,096 triangles."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(THREE, folder)
        pathlib.Path(folder, "index.html").write_text(THREE_PAGE.replace("<script>", "<body><script>"), encoding="utf-8")
        with browser.Page(driver, size=(1280, 720), folder=folder) as page:
            times = []
            for _ in range(5):
                page.driver.get("about:blank")
                page.driver.get(page.server.address)
                page.until("its first frame", lambda: page.js("window.watched && watched.first"))
                times.append(page.js("watched.first"))
            row("three.js, one mesh: first frame", f"{statistics.median(times):.0f} ms", f"{min(times):.0f} to {max(times):.0f} of {len(times)}; "
                f"gzipped {len(gzip.compress(THREE.read_bytes(), 9)):,} B")
            time.sleep(1)
            page.js("frames.splice(0).length")
            time.sleep(3)
            frames = sorted(page.js("frames"))
            row("three.js, one mesh: turning", f"{statistics.median(frames):.1f} ms a frame",
                f"95%: {frames[int(0.95 * (len(frames) - 1))]:.1f} ms; {len(frames) / 3:.1f} frames/s")


def main():
    print("| | | |\n|---|---|---|")
    sizes()
    for driver in (browser.MESA, browser.SWIFTSHADER):
        with browser.Page(driver, size=(1280, 720)) as page:
            row(f"**{driver}**", page.js("navigator.userAgent.match(/Chrome\\/[0-9.]+/)[0]"), page.js("""(() => {
                const known = GLctx ? GLctx.getExtension('WEBGL_debug_renderer_info') : null;
                return known ? GLctx.getParameter(known.UNMASKED_RENDERER_WEBGL) : '';
            })()""") if page.open() is None else "")
            first_frames(page)
            rest(page)
            page.mouse("mouseMoved", (380, 150))
            in_flight(page, "flying (W held), 1280×720", lambda: fly(page))
            page.open()
            in_flight(page, "pointer over the camera's view", lambda: hover(page))
        one_mesh_by_three(driver)
        with browser.Page(driver, size=(1280, 1300)) as page:
            stalls(page, "costs as they grow", native.fragment("cyclic-overlap", "--set", "view.lower_left=growth"), clicking("Measure"))
            stalls(page, "find a view where this key fails", native.fragment(
                "opening", "--set", "scene=sort-key-farthest", "--set", "visibility.method=painter"), clicking("Find a view where this key fails"))
            stalls(page, "a mesh of 20,000 triangles dropped", "", dropping_torus(100, 100))
            stalls(page, "a mesh of 200,000 triangles dropped", "", dropping_torus(400, 250))


if __name__ == "__main__":
    main()
