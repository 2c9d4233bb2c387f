// Time from left to right: a ruler to scrub, the blend of styles as a coloured band, the planned speed, pauses, and their keys.
//
// timeline(parent, desk, {select, edit, seek, ghosts}): `ghosts` is the list of the times of onion skins. Returns {draw(selected, seconds)}.
import { draw, pool, set } from "./floor_map.js";
import { keyed } from "./course.js";

const PAD = 14, RULER = 26, BAND = 44, SPEED = 50, PAUSE = 20, SAMPLES = 160, STEP = 0.1;
const TOPS = { arrivals: 17, ghosts: 17, styles: RULER + BAND - 8, speeds: 0, holds: RULER + BAND + SPEED + 11 };
const GLYPHS = { arrivals: "M0-7h8v6h-8v8", ghosts: "M0-5a4 4 0 1 1 0 8 4 4 0 1 1 0-8M-4 7a4 4 0 0 1 8 0Z", styles: "M0-8L7 0L0 8L-7 0Z",
                 speeds: "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0", holds: "M-5-6h4v12h-4ZM1-6h4v12h-4Z" };
const WORDS = { arrivals: "Arrival", ghosts: "Onion skin", styles: "Style key", speeds: "Speed key", holds: "Pause" };

export const HEIGHT = RULER + BAND + SPEED + PAUSE + 4;
export const hueOf = (styles, name) => `hsl(${(styles.indexOf(name) * 137.5 + 250) % 360} 46% 62%)`;
const layersOf = (blend) => (Array.isArray(blend) ? blend : [blend]);

// weights by style of a blend; of blends by layer, the mean
const flat = (blend) => layersOf(blend).reduce((sum, layer, _, all) => {
  for (const [name, weight] of Object.entries(layer)) sum[name] = (sum[name] ?? 0) + weight / all.length;
  return sum;
}, {});

export function timeline(parent, desk, { select, edit, seek, ghosts }) {
  const svg = draw(parent, "svg", { class: "tkd-time", height: HEIGHT, role: "group", "aria-label": "Timeline" });
  const ruler = draw(svg, "rect", { class: "ruler", x: 0, y: 0, height: RULER, tabindex: 0, role: "slider", "aria-label": "Time" });
  const ticks = draw(svg, "path", { class: "hollow grid" }), texts = draw(svg, "g"), bands = draw(svg, "g"), names = draw(svg, "g", { class: "names" }), spans = draw(svg, "g");
  const speed = draw(svg, "path", { class: "hollow speed" }), fast = draw(svg, "path", { class: "hollow off" }), now = draw(svg, "path", { class: "hollow now" });
  const keys = draw(svg, "g");
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
    return [...shot.path.flatMap((p, k) => (k && p.time !== null ? [{ list: "arrivals", k, time: p.time }] : [])), ...row("ghosts", ghosts),
            ...row("styles", shot.styles.map((key) => key.time)), ...row("speeds", shot.speeds.map((key) => key.time)),
            ...row("holds", shot.holds.map(begins))];
  }

  // moves a key in time, not past its neighbours; y: height of a speed
  function move({ list, k }, time, y = null) {
    const to = Math.min(Math.max(tidy(time), 0), desk.rules.LONGEST);
    if (list === "ghosts") ghosts[k] = to, desk.changed("look");
    else edit((shots) => {
      const { path, [list]: row } = shots[desk.selected];
      if (list === "arrivals") path[k].time = Math.max(to, STEP);
      else if (list === "holds" && row[k].time === null) row[k].distance = take().course.distance[Math.min(Math.round(to * desk.rules.FPS), take().count)];
      else {
        row[k].time = to;
        if (list !== "holds") row[k].time = Math.min(Math.max(to, k ? row[k - 1].time + 0.02 : 0), k + 1 < row.length ? row[k + 1].time - 0.02 : Infinity);
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
        length = Math.max(count / FPS, ...all.map((item) => item.time), 1);
        most = Math.max(1.2 * Math.max(...course.speed, ...shot.speeds.map((key) => key.speed)), 0.5);
      }
      const w = Math.max(svg.clientWidth, 1), step = [0.5, 1, 2, 5, 10, 20, 60].find((s) => out(s) - out(0) > 34) ?? 120, marks = [];
      for (let t = 0; t <= length + 1e-9; t += step) marks.push(t);
      set(ruler, { width: w, "aria-valuenow": seconds.toFixed(2), "aria-valuemin": 0, "aria-valuemax": length.toFixed(2) });
      set(ticks, { d: marks.map((t) => `M${out(t)} 0V${HEIGHT}`).join("") });
      pool(texts, "text", marks.length).forEach((text, i) => {
        set(text, { x: out(marks[i]) + 3, y: 11 });
        if (text.textContent !== `${marks[i]} s`) text.textContent = `${marks[i]} s`;
      });
      const blends = { times: shot.styles.map((k) => k.time), easings: shot.styles.map((k) => k.easing) }, floor = new Float64Array(SAMPLES + 1);
      const used = [...new Set(shot.styles.flatMap((k) => Object.keys(flat(k.blend))))], end = Math.min(count / FPS, length);
      const ways = used.map((name) => ({ ...blends, values: shot.styles.map((key) => flat(key.blend)[name] ?? 0) }));
      pool(bands, "path", used.length).forEach((path, n) => {
        const top = [], low = [];
        for (let i = 0; i <= SAMPLES; i++) {
          const x = out((end * i) / SAMPLES).toFixed(1), v = Math.max(keyed(ways[n], (end * i) / SAMPLES), 0);
          low.unshift(`${x} ${(RULER + BAND * Math.min(floor[i], 1)).toFixed(1)}`);
          floor[i] += v;
          top.push(`${x} ${(RULER + BAND * Math.min(floor[i], 1)).toFixed(1)}`);
        }
        set(path, { d: `M${top.join("L")}L${low.join("L")}Z`, fill: hueOf(desk.styles, used[n]) });
      });
      pool(names, "text", shot.styles.length).forEach((text, k) => {
        const free = (shot.styles[k + 1] ? out(shot.styles[k + 1].time) : w - PAD) - out(shot.styles[k].time) - 14, name = Object.keys(flat(shot.styles[k].blend)).join(" + ");
        set(text, { x: out(shot.styles[k].time) + 10, y: TOPS.styles + 4 });
        const short = free > 6.4 * name.length ? name : name.slice(0, Math.max(free / 6.4 - 1, 0)) + (free > 12 ? "…" : "");
        if (text.textContent !== short) text.textContent = short;
      });
      const line = (test) => course.speed.map((v, k) => (test(v, k) ? `${k && test(course.speed[k - 1], k - 1) ? "L" : "M"}${out(k / FPS).toFixed(1)} ${high(v).toFixed(1)}` : "")).join("");
      set(speed, { d: line(() => true) });
      set(fast, { d: line((v, k) => v > FASTER * Math.max(keyed(natural, k / FPS), SLOW)) });
      pool(spans, "rect", shot.holds.length).forEach((rect, k) => {
        const from = out(begins(shot.holds[k])), to = out(Math.min(begins(shot.holds[k]) + shot.holds[k].seconds, length));
        set(rect, { class: "pause", x: from, y: TOPS.holds - 8, width: Math.max(to - from, 2), height: 16, rx: 4 });
      });
      set(now, { d: `M${out(seconds)} 0V${HEIGHT}` });
      pool(keys, "path", all.length).forEach((path, i) => {
        const { list, k, time } = all[i], on = selected?.list === list && selected.k === k, y = list === "speeds" ? high(shot.speeds[k].speed) : TOPS[list];
        const what = list === "styles" ? `, ${Object.keys(flat(shot.styles[k].blend)).join(" and ")}` : list === "speeds" ? `, ${shot.speeds[k].speed} m/s` : "";
        set(path, { d: GLYPHS[list], class: `key ${list}${on ? " on" : ""}`, transform: `translate(${out(time)} ${y})`, tabindex: 0, role: "button",
                    "data-list": list, "data-k": k, "aria-label": `${WORDS[list]} ${k + 1} at ${time.toFixed(2)} s${what}: arrow keys move it, Delete removes it` });
      });
    },
  };
}
