// The fields of what is selected in a director: a point, a key, a pause, or the shot as a whole.
//
// shotForm(parent, desk, {select, edit, remove}) returns {draw(selected)}; selected = {list, k} or null. `remove` removes it.
import { EASINGS } from "./course.js";
import { joined, mirrored, reversed, trimmed } from "./edits.js";
import { LIMBS } from "./pins.js";
import { make } from "./player.js";
import { blendAt, speedOf } from "./shot.js";
import { hueOf } from "./timeline.js";

const TITLES = { path: "Point", styles: "Style key", speeds: "Speed key", holds: "Pause", ghosts: "Onion skin", pins: "Pin" };
const UNITS = { x: "x, m", z: "z, m", time: "time, s", speed: "speed, m/s", distance: "at, m", seconds: "lasts, s", at: "time, s", to: "until, s" };
const NUMBERS = { path: ["x", "z", "time"], styles: ["time"], speeds: ["time", "speed"], holds: ["time", "distance", "seconds"], pins: ["at", "to"] };
const PLACES = [...LIMBS, "look"], placed = (key) => PLACES.filter((part) => key?.[part]);
const SWITCHES = { smooth: "smooth path", feet: "foot IK", arms: "arm IK" };
const FACES = ["the path", "a direction", "a point"], NUMBER = { type: "number", step: "any" }, NEAR = 0.02; // seconds: the same key

export const button = (parent, text, label, act) =>
  make("button", "", parent, { type: "button", textContent: text, ariaLabel: label, title: label, onclick: act });

// gives a style of a blend a share; the others keep their proportions
function share(blend, name, value) {
  const others = Object.keys(blend).filter((other) => other !== name), sum = others.reduce((total, other) => total + blend[other], 0);
  for (const other of others) blend[other] = sum > 1e-9 ? ((1 - value) * blend[other]) / sum : (1 - value) / others.length;
  blend[name] = others.length ? value : 1;
}

const degrees = (pair) => (pair ? rounded((Math.atan2(...pair) * 180) / Math.PI, 1) : null);
const rounded = (v, digits) => Math.round(v * 10 ** digits) / 10 ** digits;
const direction = (angle) => (angle === null ? null : [Math.sin, Math.cos].map((f) => rounded(f((angle * Math.PI) / 180), 6)));

export function shotForm(parent, desk, { select, edit, remove }) {
  const box = make("div", "tkd-form", parent, { role: "form", ariaLabel: "What is selected" });
  let made = "", list = null, k = 0;

  const target = (shots) => (list ? shots[desk.selected][list][k] : shots[desk.selected]), here = () => target(desk.shots);
  const change = (act) => edit((shots) => void act(target(shots)));

  function field(text, read, write, more = NUMBER, tag = "input") {
    const label = make("label", "", box, { textContent: text }), input = make(tag, "", label, more), { type } = input;
    let typing = false;
    input.refresh = () => {
      if (type === "checkbox") input.checked = read();
      else if (!typing) input.value = read() ?? "";
    };
    input.oninput = () => (typing = type === "number" || type === "text");
    input.onchange = () => {
      typing = false;
      const number = input.value === "" ? null : Number(input.value);
      change((one) => write(one, type === "checkbox" ? input.checked : type === "number" ? number : input.value));
      input.refresh();
    };
    return input;
  }
  const plain = (text, name, more) => field(text, () => here()[name], (one, value) => (one[name] = value), more);
  const choose = (text, values, read, write) => {
    const menu = field(text, read, write, {}, "select");
    for (const value of values) make("option", "", menu, { value, textContent: value });
  };

  // the fields of a point, a key or a pause
  function ofKey(key) {
    for (const name of NUMBERS[list]) if (list !== "holds" || name === "seconds" || key[name] !== null) plain(UNITS[name], name);
    if (list === "pins") ofPin(placed(key));
    if (list === "path") field("faces, °", () => degrees(here().facing), (one, value) => (one.facing = direction(value)));
    if (key.easing) choose("easing", Object.keys(EASINGS), () => here().easing, (one, value) => (one.easing = value));
    if (Array.isArray(key.blend)) make("p", "", box, { textContent: "A blend by layer; change it in the file." });
    else if (key.blend) mixer(Object.keys(key.blend));
  }

  // what is pinned, and where; of several parts at once the places alone
  function ofPin(parts) {
    if (parts.length === 1) choose("pins", PLACES, () => placed(here())[0], (one, value) =>
      Object.assign(one, { [parts[0]]: null, [value]: one[parts[0]] }));
    for (const part of parts) ["x", "y", "z"].forEach((axis, i) =>
      field(`${parts.length > 1 ? `${part.replace("_", " ")} ` : ""}${axis}, m`, () => here()[part]?.[i], (one, value) => (one[part][i] = value)));
  }

  // a row per style of a blend: its name, its share, away with it
  function mixer(names) {
    names.forEach((name, i) => {
      const row = make("div", "tkd-mix", box), menu = make("select", "", row, { ariaLabel: `Style ${i + 1}` });
      for (const style of desk.styles)
        make("option", "", menu, { value: style, textContent: desk.data.labels[style], disabled: style !== name && names.includes(style) });
      menu.value = name;
      menu.onchange = () => change((one) => {
        one.blend = Object.fromEntries(Object.entries(one.blend).map(([other, w]) => [other === name ? menu.value : other, w]));
      });
      const slider = make("input", "", row, { type: "range", min: 0, max: 100, ariaLabel: `Share of ${name}, percent` });
      const text = make("span", "", row), percent = () => Math.round(100 * (here().blend[name] ?? 0));
      slider.refresh = () => {
        menu.style.borderLeft = `8px solid ${hueOf(desk, name)}`;
        slider.value = percent();
        text.textContent = `${percent()} %`;
      };
      slider.onpointerdown = () => desk.begin();
      slider.oninput = () => change((one) => share(one.blend, name, slider.value / 100));
      slider.onchange = () => desk.end();
      button(row, "×", `Take ${name} out of the blend`, () => change((one) => {
        share(one.blend, name, 0);
        delete one.blend[name];
      })).disabled = names.length < 2;
    });
    const other = desk.styles.find((style) => !names.includes(style));
    if (other) button(box, "+ style in this blend", "Add a style to this blend", () =>
      change((one) => share(one.blend, other, 1 / (names.length + 1))));
  }

  function ofShot({ look_at: look, facing }) {
    plain("name", "name", { type: "text", maxLength: 100 });
    plain("seed", "seed", { type: "number", step: 1, min: 0 });
    plain("duration, s", "duration", { ...NUMBER, placeholder: "to the end" });
    choose("faces", FACES, () => FACES[desk.shot.look_at ? 2 : desk.shot.facing ? 1 : 0], (one, value) =>
      Object.assign(one, { look_at: value === FACES[2] ? [0, 0] : null, facing: value === FACES[1] ? [0, 1] : null }));
    const goal = look ? "look_at" : facing && "facing";
    if (goal) ["x", "z"].forEach((axis, i) => field(look ? `${axis} of it, m` : `to ${axis}`, () => here()[goal]?.[i], (one, value) => (one[goal][i] = value)));
    for (const [name, text] of Object.entries(SWITCHES)) plain(text, name, { type: "checkbox" });
    const row = make("div", "tkd-row", box), now = () => Math.round(100 * desk.seconds) / 100;
    const whole = (text, label, act) => button(row, text, label, () => edit((shots) => {
      const { selected: k } = desk;
      shots[k] = act(shots[k], desk.take(k).course);
    }));
    whole("Mirror", "Mirror this shot: left and right change places", mirrored);
    whole("Reverse", "Walk the path from its end to its start", reversed);
    whole("Cut before", "Cut off what is before this time", (one, course) => trimmed(one, course, now()));
    whole("Cut after", "Cut off what is after this time", (one, course) => trimmed(one, course, 0, now()));
    button(row, "Join next", "Put the shot of the next character at the end of this one", () => edit((shots) => {
      const { selected: k } = desk;
      if (!shots[k + 1]) throw new Error("the last character has no next one whose shot can be joined");
      shots.splice(k, 2, joined(shots[k], desk.take(k).course, shots[k + 1], desk.take(k + 1).course, desk));
    }));
  }

  // adds a key at the present time, with the values that are there
  function addKey(what) {
    const time = Math.round(100 * desk.seconds) / 100, { rules: { FPS } } = desk, { [what]: keys } = desk.shot;
    const there = keys.findIndex((key) => key.time !== null && Math.abs(key.time - time) < NEAR);
    if (there < 0) edit((shots) => {
      const { course: { speed } } = desk.take(desk.selected), now = speed[Math.min(Math.round(time * FPS), speed.length - 1)];
      const fresh = { styles: () => ({ blend: blendAt(keys, time), easing: "smooth" }), holds: () => ({ seconds: 1, distance: null }),
                      speeds: () => ({ speed: rounded(now || speedOf(desk.shot.styles[0].blend, desk), 2), easing: "smooth" }) };
      const { [what]: row } = shots[desk.selected];
      row.push({ time, ...fresh[what]() });
      row.sort((a, b) => a.time - b.time);
    });
    select({ list: what, k: desk.shot[what].findIndex((key) => key.time !== null && Math.abs(key.time - time) < NEAR) });
  }

  // a pin at the present time of the right hand, where it is
  function addPin() {
    const at = Math.round(100 * desk.seconds) / 100, { data: { figure }, rules: { FPS } } = desk;
    const place = desk.joints(desk.selected, Math.max(Math.round(at * FPS) - 1, 0))[figure.arms[0][2]].map((v) => rounded(v, 2));
    edit((shots) => void shots[desk.selected].pins.push({ at, right_hand: place }));
    select({ list: "pins", k: desk.shot.pins.length - 1 });
  }

  // a point halfway to the next one, or beyond the last one
  function addPoint() {
    const at = list === "path" ? k : desk.shot.path.length - 1;
    edit((shots) => {
      const { path } = shots[desk.selected], { [at]: a, [at + 1]: b, [at - 1]: from } = path;
      const place = b ? { x: (a.x + b.x) / 2, z: (a.z + b.z) / 2 } : { x: 2 * a.x - from.x, z: 2 * a.z - from.z };
      path.splice(at + 1, 0, { ...place, time: null, facing: null });
    });
    select({ list: "path", k: at + 1 });
  }

  function rebuild() {
    const controls = () => [...box.querySelectorAll("input,select,button")], at = controls().indexOf(document.activeElement);
    box.replaceChildren();
    make("h3", "", box, { textContent: list ? `${TITLES[list]} ${k + 1}` : "Shot" });
    if (!list) ofShot(desk.shot);
    else if (list !== "ghosts") ofKey(here());
    const row = make("div", "tkd-row", box);
    if (list) button(row, "Delete", `Delete this ${TITLES[list].toLowerCase()}`, remove);
    if (!list || list === "path") button(row, "+ point", "Add a point to the path", addPoint);
    button(row, "+ pin", "Add a pin at this time", addPin);
    for (const [what, text] of [["styles", "+ style"], ["speeds", "+ speed"], ["holds", "+ pause"]])
      button(row, text, `Add a ${TITLES[what].toLowerCase()} at this time`, () => addKey(what));
    if (at >= 0) controls()[at]?.focus({ preventScroll: true });
  }

  return {
    draw(selected) {
      list = selected?.list === "arrivals" ? "path" : selected?.list ?? null;
      k = selected?.k ?? 0;
      const key = list && list !== "ghosts" ? here() : null, { look_at: look, facing } = desk.shot;
      const kind = JSON.stringify([list, k, desk.selected, key?.blend && Object.keys(key.blend), key?.distance === null, !look, !facing, placed(key)]);
      if (kind !== made) made = kind, rebuild();
      for (const input of box.querySelectorAll("input,select")) input.refresh?.();
    },
  };
}
