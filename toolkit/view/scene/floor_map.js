// The floor from above with the path of a shot: points are dragged, a press on the path adds one, a path is drawn by hand.
//
// floorMap(parent, desk, {select, edit}): `select({list: "path", k} or null)` is called when something is chosen, `edit(change)` to
//   change the shots. Returns {draw(selected, seconds), fit, toggle}. z is upwards and x to the left, as seen from behind a character.
import { LIMBS } from "./pins.js";
import { COLORS, make } from "./player.js";
import { beside } from "./shot.js";

const NS = "http://www.w3.org/2000/svg";
const CLOSE = 14, ROUGH = 0.08, LEAST = 0.3, SPREAD = 1.15; // pixels; metres of a drawn path that are left out; shortest path; margin

const TICKS = [1, 2, 5, 10, 20, 50, 100, 200]; // metres between lines
const clamp = (v, low, high) => Math.min(Math.max(v, low), high);

export const colorOf = (k) => COLORS[k % COLORS.length];

export function draw(parent, tag, attributes = {}) {
  const element = document.createElementNS(NS, tag);
  set(element, attributes);
  parent.append(element);
  return element;
}
export function set(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
}

// exactly so many elements in a group, which keep their focus when others come and go
export function pool(group, tag, count) {
  while (group.children.length < count) draw(group, tag);
  while (group.children.length > count) group.lastChild.remove();
  return [...group.children];
}

// the points of a line without those that are near the straight way (Douglas and Peucker 1973)
function simple(points, rough) {
  const [a, b] = [points[0], points.at(-1)], dx = b[0] - a[0], dz = b[1] - a[1], size = Math.hypot(dx, dz);
  let worst = 0, at = 0;
  points.forEach(([x, z], k) => {
    const apart = size < 1e-6 ? Math.hypot(x - a[0], z - a[1]) : Math.abs(dx * (z - a[1]) - dz * (x - a[0])) / size;
    if (apart > worst) worst = apart, at = k;
  });
  if (worst <= rough) return [a, b];
  return [...simple(points.slice(0, at + 1), rough), ...simple(points.slice(at), rough).slice(1)];
}

export function floorMap(parent, desk, { select, edit }) {
  const svg = draw(parent, "svg", { class: "tkd-map", role: "group", "aria-label": "Floor map: z is up, x is to the left" });
  const grid = draw(svg, "path", { class: "hollow grid" }), axes = draw(svg, "path", { class: "hollow axes" }), lines = draw(svg, "g");
  const names = ["z, m", "x, m"].map((text) => Object.assign(draw(svg, "text"), { textContent: text }));
  const walls = draw(svg, "path", { class: "hollow walls" }), off = draw(svg, "path", { class: "hollow off" }), stroke = draw(svg, "path", { class: "hollow stroke" });
  const people = draw(svg, "g"), points = draw(svg, "g"), pins = draw(svg, "g");
  const hands = new Map(); // pointers that are down
  let centre = [0, 3], scale = 50, drawing = false, line = null, held = null, spread = 0;

  const middle = () => [svg.clientWidth / 2, svg.clientHeight / 2];
  const out = ([x, z]) => { const [w, h] = middle(); return [w - (x - centre[0]) * scale, h - (z - centre[1]) * scale]; };
  const into = (event) => {
    const box = svg.getBoundingClientRect(), [w, h] = middle();
    return [centre[0] - (event.clientX - box.left - w) / scale, centre[1] - (event.clientY - box.top - h) / scale];
  };
  const trace = (places) => places.map((place, k) => `${k ? "L" : "M"}${out(place).map((v) => v.toFixed(1)).join(" ")}`).join("");
  const curveOf = ({ course: { curve } }) => curve.x.map((x, k) => [x, curve.z[k]]);
  const tidy = (v) => Math.round(100 * v) / 100;

  // all paths in view
  function fit() {
    const all = desk.shots.flatMap((shot) => shot.path), ends = ["x", "z"].map((name) => all.map((p) => p[name]));
    const low = ends.map((v) => Math.min(...v)), high = ends.map((v) => Math.max(...v));
    centre = low.map((v, i) => (v + high[i]) / 2);
    scale = clamp(Math.min(...middle().map((half, i) => (2 * half) / (SPREAD * (high[i] - low[i]) + 1))), 4, 120);
  }

  function zoom(factor, [x, z]) {
    const next = clamp(scale * factor, 2, 400);
    centre = [x + ((centre[0] - x) * scale) / next, z + ((centre[1] - z) * scale) / next];
    scale = next;
  }

  // index of the point after which a place on the path lies; null away from the path
  function onPath([x, z]) {
    const { course: { curve } } = desk.take(desk.selected);
    let best = CLOSE / scale, found = null;
    curve.x.forEach((cx, k) => {
      const apart = Math.hypot(cx - x, curve.z[k] - z);
      if (apart < best) best = apart, found = curve.knots.findLastIndex((at) => at <= curve.at[k] + 1e-9);
    });
    return found === null ? null : Math.min(found, desk.shot.path.length - 2);
  }

  // index of the nearest point that a finger beside it means
  function nearPoint(place) {
    const far = desk.shot.path.map(({ x, z }) => distance([x, z], place) * scale), least = Math.min(...far);
    return least < CLOSE ? far.indexOf(least) : undefined;
  }

  svg.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    svg.setPointerCapture(event.pointerId);
    hands.set(event.pointerId, event);
    const place = into(event), k = event.target.dataset?.k ?? nearPoint(place), who = event.target.dataset?.who;
    if (hands.size === 2) spread = apart(), line = held = null;
    else if (drawing) line = [place];
    else if (event.target.dataset?.pin !== undefined) {
      desk.begin();
      held = { pin: Number(event.target.dataset.pin), from: place };
      select({ list: "pins", k: held.pin });
    }
    else if (k === undefined && who !== undefined) select(null), desk.selected = Number(who);
    else if (k !== undefined || onPath(place) !== null) {
      desk.begin();
      held = { k: Number(k), from: place };
      if (k === undefined) {
        held.k = onPath(place) + 1;
        edit((shots) => void shots[desk.selected].path.splice(held.k, 0, point(place)));
      }
      select({ list: "path", k: held.k });
      points.children[held.k]?.focus({ preventScroll: true });
    } else {
      held = { pan: place };
      select(null);
    }
  });
  svg.addEventListener("pointermove", (event) => {
    if (!hands.has(event.pointerId)) return;
    hands.set(event.pointerId, event);
    const place = into(event);
    if (hands.size === 2) {
      const now = apart(), both = [...hands.values()].map(into);
      zoom(now / spread, [0, 1].map((i) => (both[0][i] + both[1][i]) / 2));
      spread = now;
    } else if (line) line.push(place);
    else if (held?.pin !== undefined) movePin(held.pin, held.from, place), (held.from = place);
    else if (held?.pan) centre = centre.map((v, i) => v + held.pan[i] - place[i]);
    else if (held && distance(place, held.from) * scale > 2) move(held.k, place), held.from = [1e9, 0];
    desk.changed("look");
  });
  const end = (event) => {
    if (!hands.delete(event.pointerId)) return;
    if (line) {
      const path = simple(line, ROUGH), length = line.reduce((sum, place, k) => (k ? sum + distance(place, line[k - 1]) : 0), 0);
      line = null;
      if (length > LEAST) edit((shots) => void (shots[desk.selected].path = path.map(point)));
      toggle(false);
    }
    held = null;
    desk.end();
    desk.changed("look");
  };
  svg.addEventListener("lostpointercapture", end);
  svg.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY / 500), into(event));
    desk.changed("look");
  }, { passive: false });
  svg.addEventListener("focusin", (event) => event.target.dataset.k && select({ list: "path", k: Number(event.target.dataset.k) }));
  svg.addEventListener("keydown", (event) => {
    const k = event.target.dataset?.k, by = event.shiftKey ? 0.01 : 0.1;
    const step = { ArrowLeft: [by, 0], ArrowRight: [-by, 0], ArrowUp: [0, by], ArrowDown: [0, -by] }[event.key];
    if (k === undefined || !step) return;
    event.preventDefault(), event.stopPropagation();
    const { x, z } = desk.shot.path[k];
    move(k, [x + step[0], z + step[1]]);
  });

  const distance = ([ax, az], [bx, bz]) => Math.hypot(ax - bx, az - bz);
  const apart = () => Math.max(distance(...[...hands.values()].map((hand) => [hand.clientX, hand.clientY])), 1);
  const point = ([x, z]) => ({ x: tidy(x), z: tidy(z), time: null, facing: null });
  const move = (k, [x, z]) => edit((shots) => void Object.assign(shots[desk.selected].path[k], { x: tidy(x), z: tidy(z) }));

  const movePin = (k, from, to) => edit((shots) => {
    const pin = shots[desk.selected].pins[k];
    for (const part of LIMBS.concat("look")) if (pin[part]) pin[part] = pin[part].map((v, i) => (i === 1 ? v : v + to[i / 2] - from[i / 2]));
  });

  // the next drag draws a path
  function toggle(on = !drawing) {
    drawing = on;
    svg.classList.toggle("drawing", on);
    desk.changed("look");
    return on;
  }

  return {
    svg, fit, toggle, out,
    get drawing() { return drawing; },
    draw(selected, frame) {
      const [w, h] = middle(), step = TICKS.find((n) => n * scale > 18) ?? 500, ticks = [], first = (v) => Math.ceil(v / step) * step;
      for (let x = first(centre[0] - w / scale); x < centre[0] + w / scale; x += step) ticks.push(`M${out([x, 0])[0]} 0v${2 * h}`);
      for (let z = first(centre[1] - h / scale); z < centre[1] + h / scale; z += step) ticks.push(`M0 ${out([0, z])[1]}h${2 * w}`);
      set(grid, { d: ticks.join("") });
      const [ox, oz] = out([0, 0]);
      set(axes, { d: `M${ox} 0v${2 * h}M0 ${oz}h${2 * w}` });
      set(names[0], { x: ox + 5, y: 2 * h - 6 }), set(names[1], { x: 5, y: oz - 5 });
      const count = desk.shots.length;
      set(walls, { d: (desk.more.walls ?? []).map(({ start, end }) => trace([start, end])).join("") });
      pool(lines, "path", 2 * count).forEach((path, i) => {
        const k = i >> 1, take = desk.take(k), walked = i & 1, own = k === desk.selected;
        set(path, { class: `hollow ${walked ? "walked" : "plan"}`, d: trace(walked ? take.places : curveOf(take)), stroke: colorOf(k),
                    opacity: own ? 1 : 0.45 });
      });
      const take = desk.take(desk.selected), { OFF } = desk.limits;
      const missed = beside(take).flatMap((apart, k) => (apart > OFF && k ? [trace([take.places[k - 1], take.places[k]])] : []));
      set(off, { d: missed.join("") });
      pool(people, "path", count).forEach((path, k) => {
        const found = desk.pose(k, frame);
        if (!found) return path.setAttribute("d", "");
        const { frames } = desk.take(k), [x, z, sin, cos] = frames[Math.min(frame, frames.length - 1)].history;
        const turn = (-Math.atan2(sin, cos) * 180) / Math.PI, transform = `translate(${out([x, z]).join(" ")})rotate(${turn})`;
        set(path, { d: "M0-11L7 8L0 4L-7 8Z", class: "person", fill: colorOf(k), transform, "data-who": k });
      });
      pool(points, "circle", desk.shot.path.length).forEach((circle, k) => {
        const p = desk.shot.path[k], [cx, cy] = out([p.x, p.z]), on = selected?.list === "path" && selected.k === k;
        const label = `Point ${k + 1} of the path at x ${p.x}, z ${p.z}: arrow keys move it, Delete removes it`, tone = colorOf(desk.selected);
        set(circle, { cx, cy, r: on ? 8 : 6, class: on ? "on" : "", fill: k ? "#fff" : tone, stroke: tone, tabindex: 0, role: "button",
                      "data-k": k, "aria-label": label });
      });
      const marks = desk.shot.pins.flatMap((pin, k) => LIMBS.concat("look").flatMap((part) => (pin[part] ? [[k, pin[part]]] : [])));
      pool(pins, "path", marks.length).forEach((path, i) => {
        const [k, [x, , z]] = marks[i], on = selected?.list === "pins" && selected.k === k;
        set(path, { class: `pin${on ? " on" : ""}`, d: "M0 0L-5-10a6 6 0 1 1 10 0Z", "data-pin": k, transform: `translate(${out([x, z]).join(" ")})` });
      });
      set(stroke, { d: line ? trace(line) : "" });
    },
  };
}
