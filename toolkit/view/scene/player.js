// Recorded clips side by side with play, scrub, speed, style weights and contacts over time.
//
// player(element, {skeletons, clips: [{label, fps, frames, facing, skeleton, joints, root, rotations, contacts, styles}]})
//   skeletons  see scene.js;  skeleton  the number of one
//   joints     indices of the joints that rotate (the others keep the identity)
//   root       base64 float32 [F, 3], metres;  rotations  base64 int16 [F, joints, 4], units of 1/32767, w x y z
//   contacts   base64 uint8 [F, 2] right, left, 0 or 1 (or null)
//   styles     {names: [n], weights: base64 uint8 [F, n] in units of 1/255} (or null)
import { decode } from "./numbers.js";
import { Scene } from "./scene.js";

export const COLORS = ["#7b68c4", "#2fa596", "#d6598b", "#c9a227", "#5b8def", "#8a8f98"];
const FOOT = { right: "#e39a6c", left: "#6a9fcb" };
const STILL = 12; // pictures without a change before a paused picture gets smooth edges
const SPEEDS = [0.1, 0.25, 0.5, 1, 2];
const CSS = `
.tkv{--ink:#2b323b;--soft:#6d7580;--line:#ddd8ce;--paper:#fbfaf7;--accent:#7b68c4;display:flex;flex-direction:column;gap:12px;
 height:100%;min-height:320px;color:var(--ink);font:14px/1.4 system-ui,-apple-system,"Segoe UI",Roboto,sans-serif}
.tkv *{box-sizing:border-box}
.tkv-views{flex:1;min-height:0;display:grid;gap:12px}
.tkv-view{position:relative;min-height:0;overflow:hidden;border-radius:14px;background:#f3f1ec;box-shadow:0 1px 2px #0001,0 6px 24px #0000000f}
.tkv-stage{position:absolute;inset:0;cursor:grab}.tkv-stage:active{cursor:grabbing}.tkv-stage canvas{display:block}
.tkv-label{position:absolute;left:16px;top:12px;font-weight:650;font-size:15px;pointer-events:none}
.tkv-styles{position:absolute;right:14px;top:12px;width:150px;padding:8px 10px;border-radius:12px;background:#fffc;pointer-events:none}
.tkv-styles svg{display:block;width:100%;overflow:visible;margin:0 0 6px}
.tkv-row{display:grid;grid-template-columns:10px 1fr auto;gap:6px;align-items:center;font-size:12px}
.tkv-row i{width:9px;height:9px;border-radius:50%}.tkv-row b{font-weight:600;font-variant-numeric:tabular-nums}
.tkv-row span{overflow:hidden;text-overflow:ellipsis;white-space:nowrap}
.tkv-bar{display:flex;align-items:center;gap:12px;padding:10px 14px;border-radius:14px;background:var(--paper);
 box-shadow:0 1px 2px #0001,0 6px 24px #0000000f;flex-wrap:wrap}
.tkv button,.tkv select{font:inherit;color:inherit;border:1px solid var(--line);background:#fff;border-radius:9px;height:34px;padding:0 10px;cursor:pointer}
.tkv button:hover,.tkv select:hover{border-color:#bdb6a8}
.tkv :focus-visible{outline:2px solid var(--accent);outline-offset:2px}
.tkv .tkv-play{width:42px;height:42px;border-radius:50%;border:0;background:var(--accent);padding:0;display:grid;place-items:center}
.tkv .tkv-play svg{width:18px;height:18px;fill:#fff}
.tkv button[aria-pressed=true]{background:#efecfa;border-color:#c9c0ec;color:#4c3fa0}
.tkv-time{flex:1;min-width:220px;position:relative;cursor:pointer;touch-action:none;border-radius:8px}
.tkv-time canvas{display:block;width:100%;height:46px;border-radius:8px}
.tkv-clock{font-variant-numeric:tabular-nums;color:var(--soft);min-width:96px;text-align:right}
.tkv-none{display:grid;place-items:center;height:100%;padding:24px;text-align:center;color:var(--soft)}
@media(max-width:640px){.tkv-views{grid-template-columns:1fr!important}.tkv-styles{width:118px}}
`;
const PLAY = '<svg viewBox="0 0 18 18"><path d="M4 2.2v13.6a.8.8 0 0 0 1.2.7l11-6.8a.8.8 0 0 0 0-1.4l-11-6.8a.8.8 0 0 0-1.2.7z"/></svg>';
const PAUSE = '<svg viewBox="0 0 18 18"><rect x="3" y="2" width="4.4" height="14" rx="1.2"/><rect x="10.6" y="2" width="4.4" height="14" rx="1.2"/></svg>';

export function make(tag, className, parent, attributes = {}) {
  const element = Object.assign(document.createElement(tag), attributes);
  if (className) element.className = className;
  parent?.append(element);
  return element;
}

// saves a text or a Blob as a file
export function download(name, content) {
  const link = make("a", "", null, { download: name, href: URL.createObjectURL(new Blob([content])) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

// Poses of one clip, interpolated between frames.
export class Track {
  constructor(clip, { parents }) {
    Object.assign(this, { fps: clip.fps, frames: clip.frames, joints: clip.joints, seconds: clip.frames / clip.fps });
    this.root = decode(clip.root, Float32Array);
    this.packed = decode(clip.rotations, Int16Array);
    this.contacts = clip.contacts && decode(clip.contacts, Uint8Array);
    this.names = clip.styles?.names ?? [];
    this.weights = clip.styles && decode(clip.styles.weights, Uint8Array);
    this.rotations = new Float32Array(4 * parents.length);
    for (let j = 0; j < parents.length; j++) this.rotations[4 * j] = 1;
    this.place = [0, 0, 0];
    this.path = this.steady(Math.round(0.35 * clip.fps));
  }

  // the root's path on the floor [F * 2] without its sway, for the camera: the mean of 2 n + 1 frames
  steady(n) {
    const path = new Float32Array(2 * this.frames), sum = [0, 0], at = (f) => 3 * Math.min(Math.max(f, 0), this.frames - 1);
    for (let f = -n; f <= n; f++) sum[0] += this.root[at(f)], sum[1] += this.root[at(f) + 2];
    for (let f = 0; f < this.frames; f++) {
      path.set([sum[0] / (2 * n + 1), sum[1] / (2 * n + 1)], 2 * f);
      for (const i of [0, 1]) sum[i] += this.root[at(f + n + 1) + 2 * i] - this.root[at(f - n) + 2 * i];
    }
    return path;
  }

  frameAt(seconds) {
    return Math.min((seconds % this.seconds) * this.fps, this.frames - 1);
  }

  // sets .place [3], .rotations [J * 4] and the camera's .centre [2] for a moment between two frames
  sample(frame) {
    const a = Math.min(Math.floor(frame), this.frames - 1), b = Math.min(a + 1, this.frames - 1), t = frame - a;
    this.centre = [0, 1].map((i) => this.path[2 * a + i] * (1 - t) + this.path[2 * b + i] * t);
    for (let i = 0; i < 3; i++) this.place[i] = this.root[3 * a + i] * (1 - t) + this.root[3 * b + i] * t;
    const width = 4 * this.joints.length, q = [0, 0, 0, 0];
    this.joints.forEach((joint, k) => {
      let norm = 0;
      for (let i = 0; i < 4; i++) {
        q[i] = this.packed[a * width + 4 * k + i] * (1 - t) + this.packed[b * width + 4 * k + i] * t;
        norm += q[i] * q[i];
      }
      for (let i = 0; i < 4; i++) this.rotations[4 * joint + i] = q[i] / Math.sqrt(norm);
    });
  }

  touches(frame) {
    const f = Math.round(frame);
    return { right: !!this.contacts?.[2 * f], left: !!this.contacts?.[2 * f + 1] };
  }

  blend(frame) {
    const n = this.names.length, f = Math.round(frame);
    return Array.from({ length: n }, (_, i) => this.weights[f * n + i] / 255);
  }
}

// Names and weights of a blend; three or more styles also as a polygon with a marker.
class Styles {
  constructor(parent, names) {
    this.box = make("div", "tkv-styles", parent);
    this.corners = names.map((_, i) => {
      const a = (2 * Math.PI * i) / names.length - Math.PI / 2;
      return [50 + 44 * Math.cos(a), 48 + 44 * Math.sin(a)];
    });
    if (names.length > 2) {
      const dots = this.corners.map(([x, y], i) => `<circle cx="${x}" cy="${y}" r="5" fill="${COLORS[i % COLORS.length]}"/>`);
      const low = Math.max(...this.corners.map((c) => c[1])) + 6;
      this.box.innerHTML = `<svg viewBox="0 -2 100 ${low + 2}"><polygon points="${this.corners.map((c) => c.join()).join(" ")}" fill="#fff"
        stroke="#cfc8bb" stroke-width="1.5" stroke-linejoin="round"/><polyline fill="none" stroke="#2b323b" stroke-opacity=".25"
        stroke-width="1.5"/>${dots.join("")}<circle class="m" r="6" fill="#2b323b" stroke="#fff" stroke-width="2"/></svg>`;
      this.marker = this.box.querySelector(".m");
    }
    this.values = names.map((name, i) => {
      const row = make("div", "tkv-row", this.box);
      make("i", "", row).style.background = COLORS[i % COLORS.length];
      make("span", "", row, { textContent: name, title: name });
      return make("b", "", row);
    });
  }

  show(weights) {
    const total = weights.reduce((a, b) => a + b, 0) || 1;
    let x = 0, y = 0;
    weights.forEach((w, i) => {
      this.values[i].textContent = `${Math.round((100 * w) / total)} %`;
      x += (w / total) * this.corners[i][0];
      y += (w / total) * this.corners[i][1];
    });
    this.marker?.setAttribute("cx", x);
    this.marker?.setAttribute("cy", y);
  }
}

// The bar below: style weights as stacked areas, contacts as bars, the current moment as a line.
function drawTimeline(canvas, track, seconds, duration) {
  const ratio = Math.min(devicePixelRatio, 2), w = canvas.clientWidth * ratio, h = canvas.clientHeight * ratio;
  if (!w) return;
  if (canvas.width !== w || canvas.height !== h) {
    Object.assign(canvas, { width: w, height: h });
    canvas.base = null;
  }
  if (!canvas.base) {
    canvas.base = Object.assign(document.createElement("canvas"), { width: w, height: h });
    const g = canvas.base.getContext("2d");
    g.fillStyle = "#efece5";
    g.fillRect(0, 0, w, h);
    const n = track.names.length, foot = track.contacts ? 0.16 * h : 0, area = h - 2 * foot;
    const end = (track.seconds / duration) * w;
    for (let x = 0; n > 1 && x < end; x++) {
      const weights = track.blend(track.frameAt((x / w) * duration)), total = weights.reduce((a, b) => a + b, 0) || 1;
      let y = 0;
      weights.forEach((v, i) => {
        g.fillStyle = COLORS[i % COLORS.length] + "b0";
        g.fillRect(x, y, 1, (v / total) * area);
        y += (v / total) * area;
      });
    }
    for (let x = 0; foot && x < end; x++) {
      const on = track.touches(track.frameAt((x / w) * duration));
      ["right", "left"].forEach((side, i) => {
        g.fillStyle = FOOT[side];
        if (on[side]) g.fillRect(x, area + i * foot + 0.25 * foot, 1, 0.6 * foot);
      });
    }
  }
  const g = canvas.getContext("2d");
  g.drawImage(canvas.base, 0, 0);
  const x = (seconds / duration) * w;
  g.fillStyle = "#2b323b14";
  g.fillRect(0, 0, x, h);
  g.fillStyle = "#2b323b";
  g.fillRect(Math.max(0, x - 1.25 * ratio), 0, 2.5 * ratio, h);
}

export function player(element, { skeletons, clips, speed = 1, playing = true, height = null }) {
  const root = make("div", "tkv", element);
  make("style", "", root, { textContent: CSS });
  const views = make("div", "tkv-views", root);
  if (height) { // of the pictures; else they fill the element
    Object.assign(root.style, { height: "auto", minHeight: 0 });
    Object.assign(views.style, { flex: "none", height: `${height}px` });
  }
  const columns = clips.length < 4 ? clips.length : Math.ceil(Math.sqrt(clips.length));
  views.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;

  let shown;
  try {
    shown = clips.map(({ facing, skeleton }) => {
      const view = make("div", "tkv-view", views);
      const scene = new Scene(make("div", "tkv-stage", view), skeletons[skeleton], { facing });
      return { view, scene, label: make("div", "tkv-label", view) };
    });
  } catch (error) {
    views.innerHTML = '<div class="tkv-none">This browser offers no WebGL, which the animation needs.</div>';
    return { error };
  }

  const state = { seconds: 0, speed, playing, trail: true, feet: true, follow: true, drawn: 0, fps: 0 };
  const bar = make("div", "tkv-bar", root);
  const button = make("button", "tkv-play", bar, { type: "button" });
  const time = make("div", "tkv-time", bar, { tabIndex: 0, role: "slider", ariaLabel: "Time" });
  const timeline = make("canvas", "", time);
  const clock = make("div", "tkv-clock", bar);
  const speeds = make("select", "", bar, { title: "Speed", ariaLabel: "Speed" });
  for (const s of SPEEDS) make("option", "", speeds, { value: s, textContent: `${s}×`, selected: s === speed });
  const toggles = { follow: ["Follow", "Camera goes along"], trail: ["Path", "The hips' path on the floor"],
                    feet: ["Contacts", "Colour the feet that stand"] };
  for (const [key, [text, title]] of Object.entries(toggles)) {
    const toggle = (toggles[key] = make("button", "", bar, { type: "button", textContent: text, title, ariaPressed: "true" }));
    toggle.onclick = () => { toggle.ariaPressed = String((state[key] = !state[key])); draw(); };
  }
  let duration, longest, listed;

  // the motions of other clips, of the same skeletons
  function load(given) {
    given.forEach((clip, i) => {
      const one = shown[i], track = (one.track = new Track(clip, skeletons[clip.skeleton]));
      one.label.textContent = clip.label;
      one.styles?.box.remove();
      one.styles = track.names.length ? new Styles(one.view, track.names) : null;
      one.scene.setTrail(track.root);
    });
    duration = Math.max(...shown.map(({ track }) => track.seconds));
    longest = shown.find(({ track }) => track.seconds === duration).track;
    listed = shown.find(({ track }) => track.names.length > 1)?.track ?? longest;
    toggles.feet.hidden = !shown.some(({ track }) => track.contacts);
    state.seconds %= duration;
    timeline.base = null;
  }

  function pose(first) {
    for (const { scene, track, styles } of shown) {
      const frame = track.frameAt(state.seconds);
      track.sample(frame);
      scene.setPose(track.place, track.rotations);
      scene.setContacts(state.feet ? track.touches(frame) : {});
      scene.showTrail(frame, state.trail);
      scene.follow(...track.centre, { jump: true, camera: state.follow || first });
      styles?.show(track.blend(frame));
    }
  }

  let leader = shown[0].scene, moved = false, rest = 0; // pictures since anything moved
  shown.forEach(({ scene }) => scene.controls.addEventListener("change", () => (moved = true)));
  shown.forEach(({ scene }) => scene.canvas.addEventListener("pointerdown", () => (leader = scene)));
  shown.forEach(({ scene }) => scene.canvas.addEventListener("wheel", () => (leader = scene), { passive: true }));

  function draw(first = false, still = false) {
    if (!still) rest = 0;
    moved = false;
    pose(first);
    for (const { scene } of shown) {
      if (scene !== leader) scene.lookLike(leader);
      scene.render({ still });
    }
    drawTimeline(timeline, listed, state.seconds, duration);
    clock.textContent = `${state.seconds.toFixed(2)} / ${duration.toFixed(2)} s`;
    time.ariaValueNow = state.seconds.toFixed(2);
    time.ariaValueMax = duration.toFixed(2);
    state.drawn += 1;
  }

  function seek(seconds) {
    state.seconds = Math.min(Math.max(seconds, 0), duration - 1e-6);
    draw();
  }

  function play(on = true) {
    state.playing = on;
    root.dispatchEvent(new CustomEvent("playing", { detail: on }));
    button.innerHTML = on ? PAUSE : PLAY;
    button.ariaLabel = button.title = on ? "Pause (space)" : "Play (space)";
  }

  button.onclick = () => play(!state.playing);
  speeds.onchange = () => (state.speed = Number(speeds.value));
  const pick = (event) => {
    const box = timeline.getBoundingClientRect();
    seek((duration * (event.clientX - box.left)) / box.width);
  };
  time.onpointerdown = (event) => {
    time.setPointerCapture(event.pointerId);
    time.held = state.playing;
    play(false);
    pick(event);
  };
  time.onpointermove = (event) => time.hasPointerCapture(event.pointerId) && pick(event);
  time.onpointerup = () => play(time.held);
  root.addEventListener("keydown", (event) => {
    const step = event.shiftKey ? 0.5 : 1 / longest.fps;
    if (event.key === " " && event.target.tagName !== "BUTTON") play(!state.playing);
    else if (event.key === "ArrowRight") seek(state.seconds + step);
    else if (event.key === "ArrowLeft") seek(state.seconds - step);
    else return;
    event.preventDefault();
  });

  // one loop; on slow machines the picture gets simpler, not slower
  let last = performance.now(), slow = 0, count = 0, handle = 0;
  function tick(now) {
    handle = requestAnimationFrame(tick);
    if (!root.isConnected) return; // a notebook takes cells out of the page that are out of sight
    const passed = Math.min(Math.max(now - last, 0) / 1000, 0.25); // the first tick may be earlier than `last`
    last = now;
    if (state.playing) {
      state.seconds = (state.seconds + passed * state.speed) % duration;
      slow += passed;
      if (++count === 40 || slow > 1) {
        state.fps = count / slow;
        const level = shown[0].scene.quality;
        if (state.fps < 32 && level < 3) shown.forEach(({ scene }) => scene.setQuality(level + 1));
        slow = count = 0;
      }
    }
    if (!state.playing) shown.forEach(({ scene }) => scene.controls.update());
    if (state.playing || moved) draw();
    else if (++rest === STILL) draw(false, true);
  }

  function dispose() {
    cancelAnimationFrame(handle);
    shown.forEach(({ scene }) => scene.dispose());
    root.remove();
  }

  load(clips);
  play(playing);
  draw(true);
  handle = requestAnimationFrame(tick);
  return { root, seek, play, dispose, state, get tracks() { return shown.map((s) => s.track); }, scenes: shown.map((s) => s.scene),
           load: (given) => { load(given); draw(); } };
}

// A widget. Traits: skeletons, clips, playing, and size [width, height] of the picture, pixels.
export function render({ model, el }) {
  const [width, height] = model.get("size"), box = make("div", "", el);
  Object.assign(box.style, { width: `${width}px`, maxWidth: "100%" });
  box.dataset.lmSuppressShortcuts = "true"; // keys of the player are no shortcuts of JupyterLab
  let shown = null, skeletons, bodies;
  function load() {
    if (shown?.error) return;
    const clips = model.get("clips"), now = clips.map(({ skeleton }) => skeleton).join();
    if (shown && skeletons === model.get("skeletons") && bodies === now) return shown.load(clips);
    const seconds = shown?.state.seconds ?? 0;
    shown?.dispose();
    [skeletons, bodies] = [model.get("skeletons"), now];
    shown = player(box, { skeletons, clips, playing: model.get("playing"), height });
    if (shown.error) return;
    if (seconds) shown.seek(seconds);
    shown.root.addEventListener("playing", ({ detail }) => {
      model.set("playing", detail);
      model.save_changes();
    });
    el.toolkit = shown;
  }
  const play = () => shown.error || shown.state.playing === model.get("playing") || shown.play(model.get("playing"));
  model.on("change:clips", load);
  model.on("change:playing", play);
  load();
  return () => {
    model.off("change:clips", load);
    model.off("change:playing", play);
    shown.dispose?.();
  };
}
