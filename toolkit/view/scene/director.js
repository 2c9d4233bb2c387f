// A desk for shots: a floor map, a timeline, a form, and the characters in 3-D, computed in the browser (desk.js).
//
// Traits of the model: data (of shots/director.py's pack), scene {version, shots} as a file holds it, motion (what the kernel rendered of
// it, see desk.js), and height, pixels, or null to fill the element. The scene is sent to the kernel after every change that undo knows.
import { unpack } from "./body.js";
import { bvh } from "./character.js";
import { bisectRight } from "./course.js";
import { Desk } from "./desk.js";
import { summary } from "./findings.js";
import { colorOf, floorMap } from "./floor_map.js";
import { glb } from "./gltf.js";
import { LIMBS } from "./pins.js";
import { download, make } from "./player.js";
import { Scene } from "./scene.js";
import { missed } from "./shot.js";
import { button, shotForm } from "./shot_form.js";
import { timeline } from "./timeline.js";

const CSS = `
.tkd{--ink:#2b323b;--soft:#6d7580;--line:#ddd8ce;--accent:#7b68c4;display:grid;gap:8px;height:100%;min-height:0;color:var(--ink);
 font:13px/1.4 system-ui,-apple-system,"Segoe UI",Roboto,sans-serif;grid:auto minmax(0,1fr) auto/minmax(0,1.25fr) minmax(0,1fr) 250px;
 grid-template-areas:"bar bar bar" "stage map side" "time time time"}
.tkd *{box-sizing:border-box}.tkd [hidden]{display:none!important}
.tkd button,.tkd select,.tkd input{font:inherit;color:inherit}
.tkd button,.tkd select,.tkd input:not([type=range],[type=checkbox]){border:1px solid var(--line);background:#fff;border-radius:8px;height:30px;padding:0 9px}
.tkd button{cursor:pointer}.tkd button:disabled{opacity:.4;cursor:default}.tkd:focus{outline:none}
.tkd :focus-visible{outline:2px solid var(--accent);outline-offset:1px}
.tkd button[aria-pressed=true],.tkd button[aria-selected=true]{background:#efecfa;border-color:#c9c0ec;color:#4c3fa0}
.tkd-bar,.tkd-row{display:flex;flex-wrap:wrap;gap:6px;align-items:center}.tkd-bar{grid-area:bar}
.tkd-bar [role=tablist]{display:flex;gap:4px;flex-wrap:wrap;margin-right:auto;max-height:68px;overflow:auto}
.tkd-bar [role=tab]{max-width:14em;overflow:hidden;text-overflow:ellipsis;white-space:nowrap;border-bottom:3px solid var(--tone)!important}
.tkd-box{position:relative;min-height:0;min-width:0;overflow:hidden;border-radius:12px;background:#f3f1ec}
.tkd-stage{position:absolute;inset:0}.tkd-stage canvas{display:block}
.tkd-tools{position:absolute;left:8px;top:8px;display:flex;gap:5px}
.tkd-say{position:absolute;left:8px;right:8px;bottom:8px;max-height:60%;overflow:auto;display:grid;gap:4px;justify-items:start}.tkd-say p{margin:0;padding:3px 9px;border-radius:8px;background:#fff4e0;color:#7a4b00;overflow-wrap:anywhere}
.tkd-say .bad{background:#fde4e1;color:#8c1d13}
.tkd-map,.tkd-time{display:block;width:100%;touch-action:none;user-select:none;-webkit-user-select:none}
.tkd-map{height:100%;cursor:grab}
.tkd-map.drawing{cursor:crosshair}.tkd path{stroke-linejoin:round}.tkd .hollow{fill:none}.tkd .grid{stroke:#ddd8ce;stroke-width:1}
.tkd .axes{stroke:#b9b2a3;stroke-width:1.5}
.tkd-map .plan{stroke-width:3}.tkd-map .walked{stroke-width:1.5;stroke:#2b323b;stroke-opacity:.45}
.tkd .off{stroke:#d03a2b;stroke-width:4;stroke-linecap:round}
.tkd-map .stroke{stroke:var(--accent);stroke-width:3;stroke-dasharray:6 4}.tkd-map circle{stroke-width:2.5;cursor:move}
.tkd-map circle.on{fill:var(--ink)}.tkd-map .pin{fill:#d03a2b;stroke:#fff;stroke-width:1.5;cursor:move}.tkd-map .pin.on{stroke:var(--ink)}
.tkd-map .person{stroke:#fff;stroke-width:1;cursor:pointer}.tkd-map .walls{stroke:#6d7580;stroke-width:5;stroke-linecap:round}.tkd-map text{font-size:11px;fill:var(--soft);pointer-events:none}
.tkd-low{grid-area:time;background:#fbfaf7;border-radius:12px;overflow:hidden}
.tkd-time text{font-size:10px;fill:var(--soft);pointer-events:none}.tkd-time .names text{font-size:11px;fill:#1d232b}
.tkd-time .ruler{fill:#efece5;cursor:ew-resize}.tkd-time .speed{stroke:#2b323b;stroke-width:1.5}.tkd-time .off{stroke-width:3}
.tkd-time .now{stroke:var(--accent);stroke-width:2;pointer-events:none}
.tkd-time .grid,.tkd-time .speed,.tkd-time .off{pointer-events:none}
.tkd-time .pause{fill:#c9a22755}.tkd-time g path.key{fill:#fff;stroke:#2b323b;stroke-width:1.6;cursor:grab}
.tkd-time g path.key.on{fill:#2b323b}
.tkd-time g path.ghosts{stroke:#7b68c4}.tkd-time g path.pins{stroke:#d03a2b}.tkd-time g path.holds{stroke:#8a6d10}
.tkd-time .defect{fill:#d03a2b}.tkd-found{margin:0;padding:1px 14px 4px;color:var(--soft);min-height:1.9em}.tkd-found.bad{color:#8c1d13}
.tkd-side,.tkd-form{display:flex;flex-direction:column;gap:8px}.tkd-side{grid-area:side;overflow:auto;padding:2px}
.tkd-side h3{margin:0;font-size:14px}.tkd-side label{display:grid;grid-template-columns:84px 1fr;gap:6px;align-items:center}
.tkd-side label input,.tkd-side label select{min-width:0;width:100%}.tkd-side input[type=checkbox]{width:auto;justify-self:start}
.tkd-mix{display:grid;grid-template-columns:minmax(0,1.3fr) minmax(0,1fr) 42px 26px;gap:5px;align-items:center}
.tkd-mix button{padding:0;height:26px}.tkd-mix select,.tkd-mix input{min-width:0;width:100%}
.tkd-clock{font-variant-numeric:tabular-nums;color:var(--soft);min-width:7.5em}
@media(max-width:900px){.tkd{display:flex;flex-direction:column;overflow:auto}.tkd>*{flex:none}
.tkd-box{height:clamp(190px,28dvh,420px)}.tkd-side{overflow:visible;order:1}}
`;
const BUSY = 150, SHARE = 20; // ms between pictures while a motion is computed, and how many times as long as a picture takes
const LATE = 700; // ms after which the clock says how much of the motion is ready
const STILL = 12; // unchanged pictures before one with smooth edges
const APART = 2; // metres between a character and its copy

export function render({ model, el }) {
  const root = make("div", "tkd", el, { tabIndex: -1 });
  root.dataset.lmSuppressShortcuts = "true"; // keys are no shortcuts of JupyterLab
  if (model.get("height")) root.style.height = `${model.get("height")}px`;
  make("style", "", root, { textContent: CSS });
  const data = model.get("data"), ghosts = [];
  let selected = null, playing = false, last = 0, handle = 0, moved = true, rest = 0, painted = 0, pause = BUSY, focused = null, shown, arriving = false, problem = "", trailed = null;
  const desk = new Desk(data, model.get("scene"), changed);
  desk.seconds = 0;
  const fps = desk.rules.FPS;

  const bar = make("div", "tkd-bar", root), tabs = make("div", "", bar, { role: "tablist", ariaLabel: "Characters" });
  const view = make("div", "tkd-box", root), stage = make("div", "tkd-stage", view), floor = make("div", "tkd-box", root);
  view.style.gridArea = "stage", floor.style.gridArea = "map";
  const aside = make("div", "tkd-side", root), low = make("div", "tkd-low", root);
  const map = floorMap(floor, desk, { select, edit }), time = timeline(low, desk, { select, edit, seek, ghosts });
  const judged = make("p", "tkd-found", low, { role: "status", ariaLabel: "Defects" });
  const form = shotForm(aside, desk, { select, edit, remove: removeSelected });
  const say = make("div", "tkd-say", view, { role: "status", ariaLabel: "What cannot be met" });

  button(bar, "+ character", "Add a character", () => edit((shots) => {
    const copy = JSON.parse(JSON.stringify(desk.shot)), near = shots.length, right = Math.min(...shots.map(({ path: [{ x }] }) => x));
    const room = Math.max(APART, desk.more.apart ?? 0, ...shots.map(({ radius }) => 2 * (radius ?? 0)));
    for (const point of copy.path) point.x += right - desk.shot.path[0].x - room;
    shots.push({ ...copy, name: `shot ${near + 1}`, seed: copy.seed + 1 });
    desk.selected = near;
  }));
  const remove = button(bar, "− character", "Remove this character", () => edit((shots) => void shots.splice(desk.selected, 1)));
  const play = button(bar, "▶", "Play", () => run(!playing));
  const clock = make("span", "tkd-clock", bar);
  const undo = button(bar, "↶", "Undo", () => desk.undo()), redo = button(bar, "↷", "Redo", () => desk.redo());
  button(bar, "Onion skin", "Onion skin at this time, or away with it", () => {
    const at = ghosts.findIndex((t) => Math.abs(t - desk.seconds) < 0.05);
    if (at < 0) ghosts.push(Math.round(100 * desk.seconds) / 100);
    else ghosts.splice(at, 1);
    changed("look");
  });
  const file = make("input", "", bar, { type: "file", accept: ".json,application/json", hidden: true, ariaLabel: "File of shots" });
  button(bar, "Open", "Open a file of shots", () => file.click());
  file.onchange = async () => {
    const [chosen] = file.files;
    try {
      if (chosen) open(JSON.parse(await chosen.text()));
    } catch (error) {
      complain(`${chosen.name}: ${error instanceof SyntaxError ? "not a JSON file of shots" : error.message}`);
    }
    file.value = "";
  };
  const name = (ending) => `${desk.shot.name.replace(/[^\w.+-]+/g, "_") || "shot"}.${ending}`;
  button(bar, "Save", "Save the shots as JSON", () => download("shots.json", JSON.stringify(desk.scene, null, 1) + "\n"));
  const exported = (kind, write) => button(bar, kind.toUpperCase(), `Export the motion of this character as ${kind.toUpperCase()}`, () => {
    try {
      download(name(kind), write(desk.motion(desk.selected)));
    } catch (error) {
      complain(error.message);
    }
  });
  exported("glb", (motion) => glb({ ...data.skeleton, names: data.joints }, motion, fps, desk.shot.name, skin));
  exported("bvh", (motion) => bvh(data.bvh, motion, fps));
  const tools = make("div", "tkd-tools", floor);
  const pen = button(tools, "Draw", "Draw the path with the next drag", () => map.toggle());
  button(tools, "Fit", "Show all paths", () => { map.fit(); changed("look"); });

  let scene = null;
  try {
    scene = new Scene(stage, data.skeleton, { facing: Math.PI, distance: 6 });
    scene.controls.enableDamping = false;
    scene.controls.maxDistance = 30;
    scene.controls.addEventListener("change", () => (moved = true));
  } catch {
    stage.textContent = "This browser offers no WebGL, which the character needs.";
  }
  const skin = data.skeleton.mesh.own ? null : unpack(data.skeleton.mesh); // a character's own mesh has joints of its own
  const bodies = scene ? [scene.body] : [], pale = [];

  function complain(text) {
    problem = text;
    changed("look");
  }
  function edit(change) {
    try {
      desk.change(change);
      problem = "";
    } catch (error) {
      complain(error.message);
    }
  }
  function open(made) {
    const before = desk.shots;
    desk.open(made);
    problem = "";
    if (desk.shots === before) return;
    map.fit();
    changed("look");
  }
  function select(what) {
    if (selected?.list === what?.list && selected?.k === what?.k) return;
    selected = what;
    changed("look");
  }
  function seek(seconds) {
    desk.seconds = Math.min(Math.max(seconds, 0), longest());
    changed("look");
  }
  function run(on) {
    playing = on;
    last = 0;
    play.textContent = on ? "❚❚" : "▶";
    play.ariaLabel = play.title = on ? "Pause" : "Play";
    if (on && desk.seconds >= longest() - 0.01) seek(0);
  }
  const longest = () => Math.max(...desk.shots.map((_, k) => desk.take(k).count)) / fps;

  function changed(what) {
    const busy = what === "frames" && desk.making.some(Boolean);
    if (!busy || performance.now() - painted > pause) moved = true;
    if (what !== "kept" || arriving) return;
    model.set("scene", desk.scene);
    model.save_changes();
  }
  const arrived = () => {
    arriving = true; // it is not sent back
    open(JSON.parse(JSON.stringify(model.get("scene"))));
    arriving = false;
  };
  const rendered = () => {
    try {
      desk.filled(model.get("motion") ?? {});
    } catch (error) {
      complain(error.message);
    }
  };
  model.on("change:scene", arrived);
  model.on("change:motion", rendered);

  function removeSelected() {
    const { list, k } = selected;
    selected = null;
    if (list === "ghosts") ghosts.splice(k, 1);
    else if (list === "arrivals") edit((shots) => void (shots[desk.selected].path[k].time = null));
    else edit((shots) => void shots[desk.selected][list].splice(k, 1));
    changed("look");
  }

  function head() {
    while (tabs.children.length > desk.shots.length) tabs.lastChild.remove();
    desk.shots.forEach((shot, k) => {
      const tab = tabs.children[k] ?? button(tabs, "", "", () => (desk.selected = k, selected = null, changed("look")));
      tab.role = "tab", tab.ariaSelected = String(k === desk.selected);
      tab.style.setProperty("--tone", colorOf(k));
      if (tab.textContent !== shot.name) tab.textContent = tab.title = tab.ariaLabel = shot.name;
    });
    remove.disabled = desk.shots.length < 2;
    undo.disabled = !desk.past.length, redo.disabled = !desk.future.length;
    pen.ariaPressed = String(map.drawing);
    const late = desk.making.some((take) => take && performance.now() - take.since > (desk.network ? LATE : -1));
    const wait = !late || problem ? "" : desk.network ? `, ${Math.round(100 * desk.share)} % ready` : ", the kernel renders";
    clock.textContent = `${desk.seconds.toFixed(2)} / ${longest().toFixed(2)} s${wait}`;
  }

  function words() {
    const { more: { apart } } = desk, whose = ({ name: who }) => (desk.shots.length > 1 ? `${who}: ` : "");
    if (desk.making.some(Boolean) && !problem && desk.takes.every(Boolean)) return;
    const lines = !desk.takes.every(Boolean) ? [] : apart === undefined ? desk.shots.flatMap((shot, k) => [...missed(desk.take(k), desk.limits), ...desk.missedPins(k)].map((line) => whose(shot) + line))
      : [`All keep ${apart} m apart, or their own radii: they leave their paths for it, and their plans wait where they are held up.`];
    const text = [problem, ...lines].join("\n");
    if (text === shown) return;
    shown = text;
    say.replaceChildren(...[problem, ...lines].flatMap((line, k) => (line ? [make("p", k ? "" : "bad", null, { textContent: line })] : [])));
  }

  // what is broken, in a line under the timeline
  function judge() {
    const { findings, data: { gate } } = desk, line = findings ? summary(findings, gate, desk.shots.map((shot) => shot.name)) : "";
    if (judged.textContent !== line) judged.textContent = judged.title = line;
    judged.classList.toggle("bad", !!findings?.length);
  }

  function pose(list, at, k, seconds, ghost) {
    const found = desk.pose(k, Math.round(seconds * fps) - 1), body = (list[at] ??= scene.add({ ghost }));
    scene.show(body, !!found);
    if (!found) return;
    body.pose(found.root, found.rotations);
    if (!ghost) body.setContacts({ right: found.contacts[0] > 0.5, left: found.contacts[1] > 0.5 });
    if (!ghost && k === desk.selected) scene.follow(found.root[0] * body.scale, found.root[2] * body.scale, { jump: true });
  }

  function paint(still) {
    const frame = Math.round(desk.seconds * fps) - 1;
    const rows = { ...desk.shot, ghosts, arrivals: desk.shot.path };
    if (selected && rows[selected.list][selected.k] === undefined) selected = null;
    head(), form.draw(selected), words(), judge();
    map.draw(selected, Math.max(frame, 0));
    time.draw(selected, desk.seconds);
    if (focused && (!focused.isConnected || focused.disabled) && document.activeElement === document.body)
      root.focus({ preventScroll: true }); // the keys go on
    if (!scene) return;
    desk.shots.forEach((_, k) => pose(bodies, k, k, desk.seconds, false));
    const take = desk.take(desk.selected), { curve: { x, z, at } } = take.course, planned = take.course.distance[Math.max(frame, 0)];
    if (take !== trailed) scene.setTrail(Float32Array.from(x.flatMap((v, k) => [v * scene.body.scale, 0, z[k] * scene.body.scale])));
    trailed = take;
    scene.showTrail(planned === undefined ? at.length : bisectRight(at, planned) - 1);
    scene.setMarks(desk.shot.pins.flatMap((pin) => LIMBS.concat("look").flatMap((part) => (pin[part] ? [pin[part].map((v) => v * scene.body.scale)] : []))));
    ghosts.forEach((seconds, i) => pose(pale, i, desk.selected, seconds, true));
    bodies.slice(desk.shots.length).concat(pale.slice(ghosts.length)).forEach((body) => scene.show(body, false));
    scene.render({ still });
    desk.stats.drawn = (desk.stats.drawn ?? 0) + 1;
  }

  function tick(now) {
    handle = requestAnimationFrame(tick);
    if (document.hidden || !root.clientWidth) return;
    if (playing) {
      seek(desk.seconds + Math.min((now - (last || now)) / 1000, 0.25));
      last = now;
      if (desk.seconds >= longest() - 1e-9) run(false);
    }
    if (moved) {
      moved = false, rest = 0;
      const began = performance.now();
      paint(false);
      painted = performance.now(), pause = Math.max(BUSY, SHARE * (painted - began));
    } else if (++rest === STILL) paint(true);
  }

  root.addEventListener("focusin", (event) => (focused = event.target));
  root.addEventListener("keydown", (event) => {
    const command = event.ctrlKey || event.metaKey, { target } = event;
    const typing = /INPUT|SELECT/.test(target.tagName) && target.type !== "range";
    if (command && /^[zy]$/i.test(event.key)) event.key.toLowerCase() === "y" || event.shiftKey ? desk.redo() : desk.undo();
    else if (!typing && event.key === " " && target.tagName !== "BUTTON") run(!playing);
    else if (!typing && selected && (event.key === "Delete" || event.key === "Backspace")) removeSelected();
    else return;
    event.preventDefault(), event.stopPropagation();
  });
  const sizes = new ResizeObserver(() => changed("look"));
  sizes.observe(floor), sizes.observe(low);
  map.fit();
  rendered();
  el.toolkit = { desk, scene, map, ghosts, seek, run, open, get stats() { return desk.stats; } };
  handle = requestAnimationFrame(tick);
  return () => {
    cancelAnimationFrame(handle);
    sizes.disconnect();
    model.off("change:scene", arrived);
    model.off("change:motion", rendered);
    desk.dispose();
    scene?.dispose();
  };
}
