// Live control: the page sends user input, the kernel sends poses, the newest one is drawn.
//
// Traits: skeleton (see scene.js), gate (see findings.js; without it nothing is looked for), styles [names], labels {name: in menus}, names [3], weights [3], speed, feet, arms, recording, status, and size
//   [width, height] of the picture, pixels; without one it fills its element
// Page → kernel: {kind: "input", id, move: [right, ahead], turn, run, heading: [x, z] or null}, {kind: "seen", frame}
// Kernel → page: {kind: "frame", frame, input}, from a page's own kernel with passed, the [root, rotations] of all frames since the last, and
//   one float32 buffer:
//   root [3], rotations [J * 4], trajectory [12 * 4] (x, z, direction x, z), contacts [2] right, left,
//   phases [4 * 2] (sin, cos) of a model with local phases; others are not shown
import * as THREE from "three";
import { brief, told, watch } from "./findings.js";
import triangle from "../static/triangle.js";
import { make } from "./player.js";
import { Scene } from "./scene.js";

const KEYS = { KeyW: "ahead", KeyS: "back", KeyA: "left", KeyD: "right", KeyQ: "turnLeft", KeyE: "turnRight",
               ArrowUp: "ahead", ArrowDown: "back", ArrowLeft: "turnLeft", ArrowRight: "turnRight",
               ShiftLeft: "run", ShiftRight: "run" };
const FPS = 60, MOMENT = 2; // milliseconds between two pictures that are spent on looking for defects
const SAMPLES = 12, NOW = 6, SILENCE = 1500, WAITING = 3, STALE = 12, LIMBS = ["left hand", "right hand", "left foot", "right foot"];
const CSS = `
.tkc{display:flex;flex-wrap:wrap;gap:14px;color:#2b323b;font:13px/1.4 system-ui,-apple-system,"Segoe UI",Roboto,sans-serif}
.tkc *{box-sizing:border-box}.tkc [hidden]{display:none}
.tkc-view{position:relative;overflow:hidden;border-radius:12px;background:#f3f1ec;flex:1 1 400px;align-self:flex-start}
.tkc-view:focus-within{outline:2px solid #7b68c4;outline-offset:1px}
.tkc-stage{position:absolute;inset:0;outline:none}.tkc-stage canvas{display:block}
.tkc-hint{position:absolute;left:14px;bottom:12px;color:#6d7580;pointer-events:none}
.tkc-found{color:#a8442a}.tkc-found:empty{display:none}
.tkc-alert{position:absolute;left:50%;top:14px;transform:translateX(-50%);padding:4px 12px;border-radius:9px;background:#2b323bdd;color:#fff}
.tkc-alert:empty{display:none}
.tkc-dials{position:absolute;left:12px;top:12px;display:flex;gap:6px;pointer-events:none;font-size:10px;text-align:center;color:#6d7580}
.tkc-dials svg{display:block;width:46px;height:46px;margin:auto}
.tkc-stick{position:absolute;right:14px;bottom:14px;width:96px;height:96px;border-radius:50%;background:#2b323b14;touch-action:none;cursor:grab}
.tkc-stick i{position:absolute;inset:34%;border-radius:50%;background:#2b323b99}
.tkc-side{display:flex;flex-direction:column;gap:8px;width:220px}
.tkc select,.tkc button{font:inherit;color:inherit;border:1px solid #ddd8ce;background:#fff;border-radius:8px;height:30px;padding:0 8px}
.tkc button{cursor:pointer}.tkc button[aria-pressed=true]{background:#efecfa;border-color:#c9c0ec;color:#4c3fa0}
.tkc .tkc-record[aria-pressed=true]{background:#c0392b;border-color:#c0392b;color:#fff}
.tkc-row{display:flex;flex-wrap:wrap;gap:6px;align-items:center}.tkc-row input{flex:1;min-width:0}
.tkc-menus{display:flex;flex-direction:column;gap:8px}
.tkc-fill{height:100%;flex-wrap:nowrap;user-select:none;-webkit-user-select:none;-webkit-tap-highlight-color:transparent}.tkc-fill .tkc-view{align-self:stretch;flex:1;min-height:0;min-width:0;outline:none}
.tkc-fill .tkc-side{overflow:auto}.tkc-fill .tkc-hint{max-width:calc(100% - 150px)}
@media(max-width:700px) and (orientation:portrait){.tkc-fill{flex-direction:column;gap:8px}.tkc-fill .tkc-view{flex:1 0 46%}
 .tkc-fill .tkc-side{display:grid;width:auto;grid-template:repeat(3,auto) 1fr/minmax(0,220px) minmax(122px,1fr);gap:8px;min-height:0}
 .tkc-fill .tkc-menus{grid-column:1/3;flex-direction:row}.tkc-fill select{flex:1;min-width:0}.tkc-fill .tkc-blend{grid-row:2/5}
 .tkc-fill .tkc-blend *{max-width:100%}.tkc-fill .tkc-blend svg{height:auto}
 .tkc-fill .tkc-row{gap:5px}.tkc-fill .tkc-row input{flex-basis:100%}.tkc-fill .tkc-row button{padding:0 7px}
 .tkc-fill .tkc-stick{width:31vmin;height:31vmin}.tkc-fill .tkc-dials svg{width:38px;height:38px}}
`;
const WALK = "W A S D to walk, Q E to turn, Shift to run", TOUCH = "Push the stick to walk, drag to look around";

// The trajectory window of a second before and after: an arrow per sample, flat on the floor.
function arrows(scene) {
  const shape = new THREE.Shape([[0, 0.09], [0.05, -0.05], [0, -0.02], [-0.05, -0.05]].map(([x, y]) => new THREE.Vector2(x, y)));
  const geometry = new THREE.ShapeGeometry(shape).rotateX(Math.PI / 2); // +y becomes +z
  const material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide });
  const mesh = new THREE.InstancedMesh(geometry, material, SAMPLES);
  mesh.frustumCulled = false;
  for (let i = 0; i < SAMPLES; i++) mesh.setColorAt(i, new THREE.Color(i < NOW ? "#a39b8b" : "#7b68c4"));
  scene.add(mesh);
  const matrix = new THREE.Matrix4();
  return {
    mesh,
    show(points, scale) {
      for (let i = 0; i < SAMPLES; i++) {
        const [x, z, dx, dz] = points.subarray(4 * i, 4 * i + 4);
        matrix.makeRotationY(Math.atan2(dx, dz)).setPosition(scale * x, 0.008, scale * z);
        mesh.setMatrixAt(i, matrix);
      }
      mesh.instanceMatrix.needsUpdate = true;
    },
  };
}

// A dial per limb: its pointer shows the phase and is as long as the phase vector.
function dials(parent) {
  const box = make("div", "tkc-dials", parent);
  const hands = LIMBS.map((limb) => {
    const dial = make("div", "", box);
    dial.innerHTML = `<svg viewBox="-12 -12 24 24"><circle r="11" fill="#fffc" stroke="#cfc8bb"/><line stroke-width="2.5"
      stroke-linecap="round"/></svg>${limb}`;
    return dial.querySelector("line");
  });
  return {
    box,
    show(phases) {
      hands.forEach((hand, i) => {
        const [s, c] = phases.subarray(2 * i, 2 * i + 2), size = Math.hypot(s, c), r = Math.min(10, 7 * size) / (size || 1);
        hand.setAttribute("x2", r * s);
        hand.setAttribute("y2", -r * c);
        hand.setAttribute("stroke", `hsl(${(Math.atan2(s, c) * 180) / Math.PI} 62% 45%)`);
      });
    },
  };
}

// User input: held keys, the on-screen stick or a gamepad. `read` gives it in the camera's frame.
function hand(stage, keys, stick, changed) {
  const held = new Set(), knob = stick.firstChild;
  let push = [0, 0];
  keys.addEventListener("keydown", (event) => press(event, true));
  keys.addEventListener("keyup", (event) => press(event, false));
  keys.addEventListener("blur", () => { held.clear(); changed(); });
  stage.addEventListener("pointerdown", () => stage.focus({ preventScroll: true }));
  function press(event, down) {
    if (!KEYS[event.code] || event.ctrlKey || event.metaKey || event.altKey || /SELECT|INPUT/.test(event.target.tagName)) return;
    down ? held.add(event.code) : held.delete(event.code);
    changed();
    event.preventDefault();
    event.stopPropagation();
  }
  function move(event) {
    const box = stick.getBoundingClientRect(), reach = box.width / 2;
    const x = (event.clientX - box.left) / reach - 1, y = 1 - (event.clientY - box.top) / reach;
    const scale = 1 / Math.max(1, Math.hypot(x, y));
    push = [x * scale, y * scale];
    knob.style.translate = `${push[0] * 0.68 * reach}px ${-push[1] * 0.68 * reach}px`;
  }
  stick.addEventListener("pointerdown", (event) => { stick.setPointerCapture(event.pointerId); move(event); });
  stick.addEventListener("pointermove", (event) => stick.hasPointerCapture(event.pointerId) && move(event));
  stick.addEventListener("lostpointercapture", () => { push = [0, 0]; knob.style.translate = ""; });
  return {
    read() {
      const on = (name) => Number([...held].some((code) => KEYS[code] === name));
      const wish = { move: [on("right") - on("left"), on("ahead") - on("back")], turn: on("turnLeft") - on("turnRight"),
                     run: !!on("run"), stick: push };
      const pad = navigator.getGamepads?.().find((p) => p?.connected);
      if (pad) {
        const [x, y, turn] = pad.axes.map((v) => (Math.abs(v) < 0.15 ? 0 : v));
        if (x || y) wish.stick = [x, -y];
        wish.turn ||= -(turn ?? 0);
        wish.run ||= !!pad.buttons[0]?.pressed;
      }
      return wish;
    },
  };
}

export function render({ model, el }) {
  const root = make("div", "tkc", el);
  root.dataset.lmSuppressShortcuts = "true"; // keys for the character are no shortcuts of JupyterLab
  make("style", "", root, { textContent: CSS });
  const size = model.get("size"), view = make("div", "tkc-view", root);
  if (size) Object.assign(view.style, { maxWidth: `${size[0]}px`, aspectRatio: size.join(" / ") });
  else root.classList.add("tkc-fill");
  const stage = make("div", "tkc-stage", view, { tabIndex: 0, role: "application", ariaLabel: "Character: W A S D, Q E, Shift" });
  let scene;
  try {
    const crowd = model.get("crowd"); // of a page
    scene = new Scene(stage, model.get("skeleton"), { facing: 0, distance: crowd ? 7 : 4.2 });
    if (crowd) scene.addCrowd(crowd.skeleton, crowd.tints);
  } catch (error) {
    view.textContent = "This browser offers no WebGL, which the character needs.";
    return undefined;
  }
  scene.controls.enableDamping = false;
  const ground = arrows(scene.scene), phases = dials(view);
  const below = make("div", "tkc-hint", view), defective = make("div", "tkc-found", below);
  make("div", "", below, {
    textContent: matchMedia("(pointer:coarse)").matches ? TOUCH : size ? `Click, then ${WALK}` : `${WALK}; drag to look around`,
  });
  const stick = make("div", "tkc-stick", view, { title: "Drag to walk" });
  make("i", "", stick);
  const alert = make("div", "tkc-alert", view, { role: "status" });
  const wish = hand(stage, size ? stage : window, stick, () => ask());

  const side = make("div", "tkc-side", root);
  const box = make("div", "tkc-menus", side), menus = [0, 1, 2].map((i) => {
    const menu = make("select", "", box, { ariaLabel: `Style ${i + 1}` });
    for (const style of model.get("styles")) make("option", "", menu, { value: style, textContent: model.get("labels")[style] });
    menu.onchange = () => {
      set("names", model.get("names").map((name, k) => (k === i ? menu.value : name)));
      stage.focus({ preventScroll: true }); // for the keys
    };
    return menu;
  });
  const leaveTriangle = triangle.render({ model, el: make("div", "tkc-blend", side) });
  const row = make("label", "tkc-row", side, { textContent: "Speed " });
  const slider = make("input", "", row, { type: "range", min: 0.2, max: 2.5, step: 0.05 });
  const reading = make("span", "", row);
  slider.oninput = () => set("speed", Number(slider.value));
  slider.onchange = () => stage.focus({ preventScroll: true });
  const shown = { phases: true, trajectory: true, contacts: true, chase: true };
  const switches = make("div", "tkc-row", side), local = make("div", "tkc-row", side);
  const toggles = [["feet", "Foot IK"], ["arms", "Arm IK"], ["recording", "● Record"]].map(([trait, text]) => {
    const toggle = make("button", trait === "recording" ? "tkc-record" : "", switches, { type: "button", textContent: text });
    toggle.onclick = () => set(trait, !model.get(trait));
    return [trait, toggle];
  });
  const locals = {};
  for (const [key, text] of [["phases", "Phases"], ["trajectory", "Trajectory"], ["contacts", "Contacts"], ["chase", "Camera behind"]]) {
    const toggle = (locals[key] = make("button", "", local, { type: "button", textContent: text, ariaPressed: "true" }));
    toggle.onclick = () => (toggle.ariaPressed = String((shown[key] = !shown[key])));
  }

  function set(trait, value) {
    model.set(trait, value);
    model.save_changes();
    refresh();
  }
  function refresh() {
    model.get("names").forEach((name, i) => (menus[i].value = name));
    slider.value = model.get("speed");
    reading.textContent = `${model.get("speed").toFixed(2)} m/s`;
    for (const [trait, toggle] of toggles) toggle.ariaPressed = String(model.get(trait));
  }
  const watched = ["names", "speed", "feet", "arms", "recording"].map((trait) => `change:${trait}`);
  for (const event of watched) model.on(event, refresh);
  refresh();

  // frames that are not drawn yet; times of the inputs; rates, for measurements
  const joints = model.get("skeleton").parents.length, asked = new Map(), waiting = [];
  const stats = { received: 0, drawn: 0, delays: [], frame: 0, looks: 0, slowest: 0 };
  const gate = model.get("gate"), eye = gate?.roles && watch(model.get("skeleton"), gate);
  let pose = null, late = 0, arrived = performance.now(), input = 0, last = "", first = true, handle = 0, counted = performance.now();
  let others = [];
  function receive(message, [bytes]) {
    if (message.kind === "others") others = bytes;
    if (message.kind !== "frame") return;
    waiting.push([new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength)), message.input]);
    if (waiting.length > WAITING) waiting.shift();
    arrived = performance.now();
    const [row] = waiting[waiting.length - 1], { frame, passed = [[row.subarray(0, 3), row.subarray(3, 3 + 4 * joints)]] } = message;
    passed.forEach((pose, k) => eye?.take(frame + 1 - passed.length + k, ...pose));
    stats.received += 1;
    stats.frame = message.frame;
    if (stats.received % 15 === 1) model.send({ kind: "seen", frame: message.frame });
  }

  // A network may deliver frames in groups. Each is drawn in turn, but only the newest while an input waits for its answer;
  // frames that would delay others for long are skipped.
  function next() {
    late = waiting.length > 1 ? late + 1 : 0;
    if (asked.size) waiting.splice(0, waiting.length - 1);
    else if (late > STALE) waiting.shift(), late = 0;
    return waiting.shift();
  }
  model.on("msg:custom", receive);

  function ask() {
    const { stick: [x, y], ...keys } = wish.read();
    let heading = null;
    if (x || y) { // the stick moves the character in the direction that it points to on the screen
      const to = scene.controls.target, from = scene.camera.position;
      const length = Math.hypot(to.x - from.x, to.z - from.z) || 1, ax = (to.x - from.x) / length, az = (to.z - from.z) / length;
      heading = [ax * y - az * x, az * y + ax * x].map((v) => Math.round(200 * v) / 200);
    }
    const now = JSON.stringify({ ...keys, heading });
    if (now === last) return;
    last = now;
    asked.set(++input, performance.now());
    model.send({ kind: "input", id: input, ...keys, heading });
  }

  function draw() {
    let at = 0;
    const take = (n) => pose.subarray(at, (at += n));
    const place = take(3), rotations = take(4 * joints), trajectory = take(4 * SAMPLES), contacts = take(2), phase = take(8);
    scene.setPose(place, rotations);
    scene.crowd?.pose(others);
    scene.setContacts(shown.contacts ? { right: contacts[0] > 0.5, left: contacts[1] > 0.5 } : {});
    ground.mesh.visible = shown.trajectory;
    ground.show(trajectory, scene.body.scale);
    locals.phases.hidden = phase.length < 2 * LIMBS.length;
    phases.box.hidden = !shown.phases || locals.phases.hidden;
    if (!phases.box.hidden && stats.drawn % 3 === 0) phases.show(phase); // updating the page takes longer than the picture
    scene.follow(scene.body.scale * place[0], scene.body.scale * place[2], { jump: first });
    if (shown.chase) turnBehind(Math.atan2(trajectory[4 * NOW + 2], trajectory[4 * NOW + 3]));
    first = false;
  }

  // the camera slowly turns to behind the character
  function turnBehind(facing) {
    const { target } = scene.controls, offset = scene.camera.position.clone().sub(target);
    const apart = facing + Math.PI - Math.atan2(offset.x, offset.z), angle = Math.atan2(Math.sin(apart), Math.cos(apart));
    scene.camera.position.copy(offset.applyAxisAngle(scene.camera.up, 0.02 * angle)).add(target);
  }

  // a quiet line of what is broken in the last seconds
  function look() {
    const began = performance.now(), found = eye?.look(began + MOMENT, FPS);
    stats.slowest = Math.max(stats.slowest, performance.now() - began);
    if (!found) return;
    stats.looks += 1;
    const say = brief(found);
    if (defective.textContent === say) return;
    defective.textContent = say;
    defective.title = found.map((one) => told(one, gate)).join("\n");
  }

  function tick(now) {
    handle = requestAnimationFrame(tick);
    if (document.hidden || !view.clientWidth) return;
    ask();
    const say = model.get("status") || (now - arrived > SILENCE ? "waiting for the kernel …" : "");
    if (alert.textContent !== say) alert.textContent = say;
    look();
    if (!waiting.length) {
      if (pose && !scene.still && now - arrived > 300) scene.render({ still: true });
      return;
    }
    const [newest, answered] = next();
    pose = newest;
    draw();
    scene.render();
    stats.drawn += 1;
    if (stats.drawn % 60 === 0) { // on a slow machine the picture gets simpler, not slower
      if (60000 / (now - counted) < 24 && scene.quality < 3) scene.setQuality(scene.quality + 1);
      counted = now;
    }
    for (const [id, since] of asked) if (id <= answered) asked.delete(id), stats.delays.push(performance.now() - since);
    if (stats.delays.length > 500) stats.delays.shift();
  }
  el.toolkit = { stats, scene, get pose() { return pose; } };
  model.send({ kind: "seen", frame: 0 });
  handle = requestAnimationFrame(tick);

  return () => {
    cancelAnimationFrame(handle);
    model.send({ kind: "closed" });
    model.off("msg:custom", receive);
    for (const event of watched) model.off(event, refresh);
    leaveTriangle();
    scene.dispose();
  };
}
