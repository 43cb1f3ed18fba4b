// The page of a suite's report: the list, and one entry with its pictures shown in six ways. Pictures that differ come
// in a script (pictures/NAME.js), since a page opened from disk may not read the pixels of image files.
"use strict";

const outcomes = ["different", "failed", "new", "not drawn", "passed"];
const classOf = outcome => outcome.replaceAll(" ", "-");
const ways = ["2-up", "slider", "blink", "expected", "actual", "difference"];
const at = id => document.getElementById(id);

/** make("p", {class: "quiet"}, "text", node …): texts are never markup. */
function make(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes))
    if (key.startsWith("on")) node.addEventListener(key.slice(2), value);
    else if (value !== undefined && value !== false) node.setAttribute(key, value);
  node.append(...children.filter(child => child));
  return node;
}

const shown = {outcomes: new Set(), entry: null, way: "2-up", zoom: 1, boxes: true};
for (const outcome of outcomes) if (report.counts[outcome] > 0) shown.outcomes.add(outcome);
if (shown.outcomes.size > 1) shown.outcomes.delete("passed");

// ---- the list -------------------------------------------------------------------------------------------------------

const listed = () => {
  const part = at("search").value.toLowerCase();
  return report.entries.filter(entry => shown.outcomes.has(entry.outcome) && entry.name.toLowerCase().includes(part));
};

function drawFilters() {
  at("filters").replaceChildren(...outcomes.map(outcome => make("button", {
    "aria-pressed": String(shown.outcomes.has(outcome)), disabled: report.counts[outcome] ? undefined : "",
    onclick: () => {
      if (!shown.outcomes.delete(outcome)) shown.outcomes.add(outcome);
      drawFilters();
      drawList();
    }}, make("span", {class: "dot " + classOf(outcome)}), `${outcome} ${report.counts[outcome]}`)));
}

function drawList() {
  const entries = listed();
  at("list").replaceChildren(...entries.map(entry => make("li", {
    title: entry.name, "aria-current": String(entry === shown.entry), onclick: () => show(entry)},
    make("span", {class: "dot " + classOf(entry.outcome)}), entry.name)));
  if (!entries.includes(shown.entry)) show(entries[0] ?? null);
}

function step(by) {
  const entries = listed();
  const next = entries[entries.indexOf(shown.entry) + by];
  if (next) show(next);
}

function show(entry) {
  shown.entry = entry;
  const entries = listed();
  [...at("list").children].forEach((item, i) => item.setAttribute("aria-current", String(entries[i] === entry)));
  at("list").querySelector("[aria-current=true]")?.scrollIntoView({block: "nearest"});
  if (entry) history.replaceState(null, "", "#" + encodeURIComponent(entry.name));
  drawEntry();
}

// ---- pictures -------------------------------------------------------------------------------------------------------

const loaded = new Map();  // by file name: a promise of {expected, actual, difference} as images

/** Called by the script with an entry's pictures, pictures/NAME.js. */
function pictures(file, data) {
  const images = Object.entries(data).map(([name, url]) => new Promise(done => {
    const image = new Image();
    image.onload = () => done([name, image]);
    image.src = url;
  }));
  Promise.all(images).then(pairs => waiting.get(file)?.(Object.fromEntries(pairs)));
}
const waiting = new Map();

function load(entry) {
  if (!loaded.has(entry.file)) loaded.set(entry.file, new Promise(done => {
    if (entry.outcome === "not drawn") return done({});  // any files of the entry are from an earlier run
    if (!entry.details?.compare || entry.outcome === "passed") {
      const image = new Image();
      image.onload = () => done({actual: image});
      image.onerror = () => done({});
      image.src = `pictures/${encodeURIComponent(entry.file)}.actual.png`;
      return;
    }
    waiting.set(entry.file, done);
    document.head.append(make("script", {src: `pictures/${encodeURIComponent(entry.file)}.js`,
                                         onerror: () => done({})}));
  }));
  return loaded.get(entry.file);
}

function canvasOf(image) {
  const canvas = make("canvas", {width: image.naturalWidth, height: image.naturalHeight});
  canvas.getContext("2d", {willReadFrequently: true}).drawImage(image, 0, 0);
  canvas.style.width = image.naturalWidth * shown.zoom + "px";
  canvas.style.height = image.naturalHeight * shown.zoom + "px";
  return canvas;
}

/** Boxes around differences, in the picture's pixels. */
function boxesOf(entry) {
  if (!shown.boxes) return [];
  return (entry.details?.compare?.boxes ?? []).map(box => {
    const node = make("div", {class: "box"});
    Object.assign(node.style, {left: box.x * shown.zoom + "px", top: box.y * shown.zoom + "px",
                               width: box.width * shown.zoom + "px", height: box.height * shown.zoom + "px"});
    return node;
  });
}

function pixelAt(images, event, canvas) {
  const frame = canvas.getBoundingClientRect();
  const x = Math.floor((event.clientX - frame.left) / shown.zoom);
  const y = Math.floor((event.clientY - frame.top) / shown.zoom);
  const told = ["expected", "actual"].filter(name => images[name]).map(name => {
    try {
      const source = images[name].pixels ??= canvasOf(images[name]).getContext("2d");
      return `${name} (${[...source.getImageData(x, y, 1, 1).data].join(", ")})`;
    } catch { return ""; }  // the pixels of an image file cannot be read
  }).filter(Boolean);
  at("pixel").textContent = `(${x}, ${y})  ` + told.join("   ");
}

function framed(images, name, entry) {
  if (!images[name]) return null;
  const canvas = canvasOf(images[name]);
  canvas.addEventListener("mousemove", event => pixelAt(images, event, canvas));
  return make("figure", {class: "picture"}, make("div", {class: "picture"}, canvas, ...boxesOf(entry)),
              make("figcaption", {}, name));
}

let blinking = 0;

function stageOf(images, entry) {
  clearInterval(blinking);
  const has = images.expected && images.actual;
  const way = has ? shown.way : "actual";
  if (way === "2-up") return [framed(images, "expected", entry), framed(images, "actual", entry)];
  if (way === "blink") {
    const figures = [framed(images, "expected", entry), framed(images, "actual", entry)];
    let front = 0;
    const turn = () => { figures.forEach((figure, i) => { figure.hidden = i !== front; }); front = 1 - front; };
    turn();
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) figures.forEach(figure => figure.addEventListener("click", turn));
    else blinking = setInterval(turn, 600);
    return figures;
  }
  if (way === "slider") {
    const lower = framed(images, "actual", entry), upper = make("div", {class: "upper"}, canvasOf(images.expected));
    const width = images.actual.naturalWidth * shown.zoom;
    upper.style.width = width / 2 + "px";
    lower.firstChild.append(upper);
    upper.addEventListener("mousemove", event => pixelAt(images, event, lower.querySelector("canvas")));
    lower.lastChild.textContent = "expected | actual";
    lower.append(make("input", {type: "range", min: 0, max: width, value: width / 2, "aria-label": "divider",
                                oninput: event => { upper.style.width = event.target.value + "px"; }}));
    return [lower];
  }
  return [framed(images, way, entry)];
}

// ---- one entry ------------------------------------------------------------------------------------------------------

function table(title, heads, rows) {
  if (!rows?.length) return null;
  return make("div", {}, make("h3", {}, title), make("table", {}, make("tr", {}, ...heads.map(head => make("th", {}, head))),
              ...rows.map(row => make("tr", {}, ...row.map(cell => make("td", {}, cell))))));
}
const written = value => value === null || value === undefined ? "–" : typeof value === "string" ? value : JSON.stringify(value);
const changes = list => list?.map(change => [change.path, written(change.expected), written(change.actual)]);

function drawEntry() {
  const entry = shown.entry;
  clearInterval(blinking);
  if (!entry) return at("entry").replaceChildren(make("p", {class: "quiet"}, "No entries."));
  const details = entry.details ?? {};
  const stage = make("div", {class: "stage"});
  const differs = Boolean(details.compare) && entry.outcome !== "passed";
  at("entry").replaceChildren(...[
    make("h2", {}, entry.name),
    entry.about ? make("p", {class: "quiet"}, entry.about) : null,
    make("p", {class: classOf(entry.outcome)}, entry.outcome + (entry.kept ? " (unchanged, not drawn again)" : "")),
    ...entry.reasons.map(reason => make("p", {}, reason)),
    make("div", {class: "ways"}, ...ways.map((way, i) => make("button", {
      "aria-pressed": String(way === shown.way), disabled: differs ? undefined : "", title: String(i + 1),
      onclick: () => { shown.way = way; drawEntry(); }}, way)),
      make("button", {onclick: () => zoom(2)}, "+"), make("button", {onclick: () => zoom(0.5)}, "−"),
      make("span", {class: "quiet"}, `${shown.zoom * 100}%`)),
    stage, make("p", {id: "pixel"}),
    table("Numbers", ["", "expected", "actual"], changes(details.numbers)),
    table("State", ["", "reference", "now"], changes(details.state)),
    details.problems ? make("div", {}, make("h3", {}, "Problems"), ...details.problems.map(problem => make("p", {}, problem))) : null,
    entry.output ? make("div", {}, make("h3", {}, "Messages"), make("pre", {}, entry.output)) : null,
    differs ? make("div", {}, make("h3", {}, "To accept the new result"),
      make("pre", {}, `viewing-sandbox suite accept ${quoted(report.argument)} ${quoted(entry.name)}`)) : null,
    make("h3", {}, "To run it again"),
    make("pre", {}, `viewing-sandbox suite run ${quoted(report.argument)} --only ${quoted(entry.name)}\n` +
                    `viewing-sandbox open states/${quoted(entry.file)}.json      # in this report's folder`)].filter(Boolean));
  load(entry).then(images => {
    if (shown.entry !== entry) return;
    const figures = stageOf(images, entry).filter(Boolean);
    stage.replaceChildren(...(figures.length ? figures : [make("p", {class: "quiet"}, "No picture.")]));
  });
}
const quoted = text => /^[\w./-]+$/.test(text) ? text : "'" + text.replaceAll("'", "'\\''") + "'";

function zoom(by) {
  shown.zoom = Math.min(16, Math.max(0.25, shown.zoom * by));
  drawEntry();
}

// ---- keys -----------------------------------------------------------------------------------------------------------

document.addEventListener("keydown", event => {
  if (event.target.tagName === "INPUT" || event.ctrlKey || event.metaKey || event.altKey) return;
  const way = ways[Number(event.key) - 1];
  if (event.key === "j" || event.key === "ArrowDown") step(1);
  else if (event.key === "k" || event.key === "ArrowUp") step(-1);
  else if (event.key === "+" || event.key === "=") zoom(2);
  else if (event.key === "-") zoom(0.5);
  else if (event.key === "b") { shown.boxes = !shown.boxes; drawEntry(); }
  else if (way) { shown.way = way; drawEntry(); }
  else return;
  event.preventDefault();
});
at("search").addEventListener("input", drawList);
at("summary").textContent = `${report.entries.length} entries · ${report.renderer} · ${report.seconds.toFixed(1)} s` +
  (report.shard[1] > 1 ? ` · shard ${report.shard[0]} of ${report.shard[1]}` : "");
const wanted = decodeURIComponent(location.hash.slice(1));
shown.entry = report.entries.find(entry => entry.name === wanted) ?? null;
if (shown.entry) shown.outcomes.add(shown.entry.outcome);
drawFilters();
drawList();
if (shown.entry) show(shown.entry);
