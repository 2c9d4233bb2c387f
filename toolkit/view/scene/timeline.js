// Time from left to right: a ruler to scrub, the blend of styles as a coloured band, the planned speed, pauses, and their keys. Defects
// of the selected character are red on the ruler.
//
// timeline(parent, desk, {select, edit, seek, ghosts}) returns {draw(selected, seconds)}; `ghosts` are the times of onion skins.
import { draw, pool, set } from "./floor_map.js";
import { keyed } from "./course.js";
import { told } from "./findings.js";
import { PARTS } from "./pins.js";
import { layersOf } from "./shot.js";

const PAD = 14, RULER = 26, BAND = 44, SPEED = 50, PAUSE = 20, SAMPLES = 160, STEP = 0.1, APART = 0.02; // pixels; seconds
const TOPS = { arrivals: 17, ghosts: 17, pins: 16, styles: RULER + BAND - 8, speeds: 0, holds: RULER + BAND + SPEED + 11 };
const GLYPHS = { pins: "M0 8L-4 0a4.6 4.6 0 1 1 8 0Z", arrivals: "M0 7V-7h8v6h-8", ghosts: "M0-5a4 4 0 1 1 0 8 4 4 0 1 1 0-8M-4 7a4 4 0 0 1 8 0Z", styles: "M0-8L7 0L0 8L-7 0Z",
                 speeds: "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0", holds: "M-5-6h4v12h-4ZM1-6h4v12h-4Z" };
const STEPS = [0.5, 1, 2, 5, 10, 20, 60]; // seconds between lines
const WORDS = { pins: "Pin", arrivals: "Arrival", ghosts: "Onion skin", styles: "Style key", speeds: "Speed key", holds: "Pause" };

export const HEIGHT = RULER + BAND + SPEED + PAUSE + 4;

// colour of a style, different from those of the other styles that the shots use
export function hueOf({ styles, shots }, name) {
  const used = new Set(shots.flatMap((shot) => shot.styles.flatMap((key) => Object.keys(flat(key.blend)))));
  return `hsl(${(styles.filter((style) => used.has(style)).indexOf(name) * 137.5 + 250) % 360} 48% 66%)`;
}

// weights by style of a blend; of blends by layer, the mean
const flat = (blend) => layersOf(blend).reduce((sum, layer, _, all) => {
  for (const [name, weight] of Object.entries(layer)) sum[name] = (sum[name] ?? 0) + weight / all.length;
  return sum;
}, {});

export function timeline(parent, desk, { select, edit, seek, ghosts }) {
  const svg = draw(parent, "svg", { class: "tkd-time", height: HEIGHT, role: "group", "aria-label": "Timeline" });
  const ruler = draw(svg, "rect", { class: "ruler", x: 0, y: 0, height: RULER, tabindex: 0, role: "slider", "aria-label": "Time" });
  const path = (kind) => draw(svg, "path", { class: `hollow ${kind}` }), group = (kind = "") => draw(svg, "g", { class: kind });
  const ticks = path("grid"), texts = group(), bands = group(), names = group("names"), paces = group(), spans = group();
  const speed = path("speed"), fast = path("off"), now = path("now");
  const broken = group("broken"), keys = draw(svg, "g");
  let most = 2, length = 10, held = null;

  const take = () => desk.take(desk.selected), width = () => svg.clientWidth - 2 * PAD;
  const out = (seconds) => PAD + (seconds / length) * width(), into = (x) => ((x - PAD) / width()) * length;
  const high = (v) => RULER + BAND + SPEED - 5 - (v / most) * (SPEED - 12);
  const tidy = (v) => Math.round(100 * v) / 100;

  // when a pause begins: one at a place begins when the plan is there
  function begins(hold) {
    if (hold.time !== null) return hold.time;
    const at = take().course.distance.findIndex((d) => d >= Math.min(hold.distance, take().course.curve.length) - 1e-6);
    return (at < 0 ? take().count : at) / desk.rules.FPS;
  }

  function items() {
    const { shot } = desk, row = (list, times) => times.map((time, k) => ({ list, k, time }));
    const arrivals = row("arrivals", shot.path.map((p) => p.time)).filter(({ k, time }) => k && time !== null);
    return [...arrivals, ...row("ghosts", ghosts), ...row("pins", shot.pins.map((pin) => pin.at)), ...row("styles", shot.styles.map((key) => key.time)), ...row("speeds", shot.speeds.map((key) => key.time)),
            ...row("holds", shot.holds.map(begins))];
  }

  // moves a key in time, not past its neighbours; y: height of a speed
  function move({ list, k }, time, y = null) {
    const to = Math.min(Math.max(tidy(time), 0), desk.rules.LONGEST);
    if (list === "ghosts") ghosts[k] = to, desk.changed("look");
    else edit((shots) => {
      const { path, [list]: row } = shots[desk.selected], { course: { distance }, count } = take();
      if (list === "arrivals") path[k].time = Math.max(to, STEP);
      else if (list === "pins") row[k].to &&= tidy(row[k].to + to - row[k].at), row[k].at = to;
      else if (list === "holds" && row[k].time === null) row[k].distance = distance[Math.min(Math.round(to * desk.rules.FPS), count)];
      else {
        const least = list !== "holds" && k ? row[k - 1].time + APART : 0;
        row[k].time = Math.min(Math.max(to, least), list !== "holds" && k + 1 < row.length ? row[k + 1].time - APART : Infinity);
        if (list === "speeds" && y !== null) row[k].speed = tidy(Math.min(Math.max(y, 0), 20));
      }
    });
  }

  svg.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    svg.setPointerCapture(event.pointerId);
    const { list, k } = event.target.dataset, box = svg.getBoundingClientRect();
    held = list ? { list, k: Number(k), from: event.clientX, low: event.clientY } : { scrub: true };
    if (!list) return seek(into(event.clientX - box.left));
    desk.begin();
    select({ list, k: Number(k) });
    event.target.focus({ preventScroll: true });
  });
  svg.addEventListener("pointermove", (event) => {
    if (!held) return;
    const box = svg.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
    if (held.scrub) return seek(into(x));
    if (Math.hypot(event.clientX - held.from, event.clientY - held.low) < 3) return;
    held.from = -1e9;
    move(held, into(x), ((RULER + BAND + SPEED - 5 - y) / (SPEED - 12)) * most);
  });
  svg.addEventListener("lostpointercapture", () => {
    held = null;
    desk.end();
    desk.changed("look");
  });
  svg.addEventListener("focusin", ({ target: { dataset: { list, k } } }) => list && select({ list, k: Number(k) }));
  svg.addEventListener("keydown", (event) => {
    const { list, k } = event.target.dataset, by = event.shiftKey ? 1 : STEP, side = { ArrowLeft: -by, ArrowRight: by }[event.key];
    const up = { ArrowUp: 0.05, ArrowDown: -0.05 }[event.key];
    if (side === undefined && (up === undefined || list !== "speeds")) return;
    event.preventDefault(), event.stopPropagation();
    if (!list) return seek(desk.seconds + side);
    const { time } = items().find((item) => item.list === list && item.k === Number(k));
    move({ list, k: Number(k) }, time + (side ?? 0), up === undefined ? null : desk.shot.speeds[k].speed + up);
  });

  return {
    svg,
    draw(selected, seconds) {
      const { shot, rules: { FPS }, limits: { FASTER, SLOW } } = desk, { course, count, natural } = take(), all = items();
      if (!held) {
        length = Math.max(...desk.shots.map((_, k) => desk.take(k).count / FPS), ...all.map((item) => item.time), 1);
        most = Math.max(1.2 * Math.max(...course.speed, ...shot.speeds.map((key) => key.speed)), 0.5);
      }
      const w = Math.max(svg.clientWidth, 1), step = STEPS.find((s) => out(s) - out(0) > 46) ?? 120, marks = [];
      for (let t = 0; t <= length + 1e-9; t += step) marks.push(t);
      set(ruler, { width: w, "aria-valuenow": seconds.toFixed(2), "aria-valuemin": 0, "aria-valuemax": length.toFixed(2) });
      set(ticks, { d: marks.map((t) => `M${out(t)} 0V${HEIGHT}`).join("") });
      pool(texts, "text", marks.length).forEach((text, i) => {
        set(text, { x: out(marks[i]) + 3, y: 11 });
        if (text.textContent !== `${marks[i]} s`) text.textContent = `${marks[i]} s`;
      });
      const times = shot.styles.map((key) => key.time), easings = shot.styles.map((key) => key.easing);
      const end = Math.min(count / FPS, length);
      const weights = shot.styles.map((key) => flat(key.blend)), used = [...new Set(weights.flatMap(Object.keys))];
      const ways = used.map((name) => ({ times, easings, values: weights.map((blend) => blend[name] ?? 0) }));
      const floor = new Float64Array(SAMPLES + 1);
      pool(bands, "path", used.length).forEach((path, n) => {
        const top = [], low = [];
        for (let i = 0; i <= SAMPLES; i++) {
          const x = out((end * i) / SAMPLES).toFixed(1), v = Math.max(keyed(ways[n], (end * i) / SAMPLES), 0);
          low.unshift(`${x} ${(RULER + BAND * Math.min(floor[i], 1)).toFixed(1)}`);
          floor[i] += v;
          top.push(`${x} ${(RULER + BAND * Math.min(floor[i], 1)).toFixed(1)}`);
        }
        set(path, { d: `M${top.join("L")}L${low.join("L")}Z`, fill: hueOf(desk, used[n]) });
      });
      pool(names, "text", shot.styles.length).forEach((text, k) => {
        const from = out(times[k]), free = (k + 1 < times.length ? out(times[k + 1]) : w - PAD) - from - 14;
        const name = Object.keys(weights[k]).join(" + ");
        set(text, { x: from + 10, y: TOPS.styles + 4 });
        const short = free > 6.4 * name.length ? name : name.slice(0, Math.max(free / 6.4 - 1, 0)) + (free > 12 ? "…" : "");
        if (text.textContent !== short) text.textContent = short;
      });
      const words = shot.speeds.length ? shot.speeds.map((key) => [key.time, `${key.speed} m/s`, key.speed])
        : [[0, "the natural speed of the styles", Math.max(...course.speed)]];
      pool(paces, "text", words.length).forEach((text, k) => {
        const [time, word, v] = words[k], free = (words[k + 1] ? out(words[k + 1][0]) : w) - out(time) > 60;
        set(text, { x: out(time) + 8, y: high(v) - 4 });
        text.textContent = free ? word : "";
      });
      const line = (has) => course.speed.map((v, k) =>
        (has[k] ? `${k && has[k - 1] ? "L" : "M"}${out(k / FPS).toFixed(1)} ${high(v).toFixed(1)}` : "")).join("");
      set(speed, { d: line(course.speed.map(() => true)) });
      set(fast, { d: line(course.speed.map((v, k) => v > FASTER * Math.max(keyed(natural, k / FPS), SLOW))) });
      pool(spans, "rect", shot.holds.length).forEach((rect, k) => {
        const from = out(begins(shot.holds[k])), to = out(Math.min(begins(shot.holds[k]) + shot.holds[k].seconds, length));
        set(rect, { class: "pause", x: from, y: TOPS.holds - 8, width: Math.max(to - from, 2), height: 16, rx: 4 });
      });
      const found = (desk.findings ?? []).filter(({ characters }) => characters.includes(desk.selected));
      pool(broken, "rect", found.length).forEach((rect, i) => {
        const { start, end } = found[i], line = told(found[i], desk.data.gate);
        set(rect, { class: "defect", x: out(start), y: RULER - 6, width: Math.max(out(end) - out(start), 3), height: 6, "aria-label": line, role: "img" });
        if (rect.textContent !== line) rect.replaceChildren(), draw(rect, "title", {}).textContent = line;
      });
      set(now, { d: `M${out(seconds)} 0V${HEIGHT}` });
      pool(keys, "path", all.length).forEach((path, i) => {
        const { list, k, time } = all[i], on = selected?.list === list && selected.k === k, key = shot[list]?.[k];
        const what = { styles: () => `, ${Object.keys(weights[k]).join(" and ")}`, speeds: () => `, ${key.speed} m/s`, pins: () => `, ${PARTS.filter((part) => key[part]).join(" and ").replaceAll("_", " ")}` }[list]?.() ?? "";
        const label = `${WORDS[list]} ${k + 1} at ${time.toFixed(2)} s${what}: arrow keys move it, Delete removes it`;
        set(path, { d: GLYPHS[list], class: `key ${list}${on ? " on" : ""}`, tabindex: 0, role: "button", "aria-label": label,
                    "data-k": k, "data-list": list, transform: `translate(${out(time)} ${list === "speeds" ? high(key.speed) : TOPS[list]})` });
      });
    },
  };
}
