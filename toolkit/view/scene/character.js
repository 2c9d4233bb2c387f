// A character whose network runs in the page, without the kernel of a notebook (view/widgets/controller.py).
//
// Character(data) steps and poses; advance steps many, which share a network, at once. Kernel(data) also takes user input and the
// triangle's blend; it is the `model` of controller.js.
// data = {
//   network, rules, body: see network.js, frame.js, pose.js;  start: the state in the first frame;  skeleton: see body.js
//   life: {amount, period}: how the styles wander, see life.js
//   styles: [names], labels: {name: in menus}, vectors: numbers [styles * D];  speeds: [m/s], natural;  gate: see findings.js;  turn, run, ease: as in view/pages/live_page.py
//   others: [{style, radius, angle, way, speed, tint}]: characters that walk on rings around the start, of a crowd; [] without
//   crowd: the skeleton of these bodies, or null
//   bvh: {header, joints, centimetre} of a recording;  traits: first values for controller.js
// }
import { afterNetwork, copy, stand, steer, unit } from "./frame.js";
import { Life } from "./life.js";
import { Network } from "./network.js";
import { numbers } from "./numbers.js";
import { plant, pose } from "./pose.js";

export class Character {
  constructor({ network, rules, body, start }, shared = new Network(network)) {
    const [x, , z] = shared.means;
    Object.assign(this, { rules, body, first: start, network: shared });
    this.x = new Float64Array(x.length);
    this.z = new Float64Array(z.length);
    this.rotations = new Float64Array(4 * body.parents.length);
    this.root = new Float64Array(3);
    this.restart();
  }

  restart() {
    this.state = copy(this.first);
    this.spare = copy(this.first);
  }

  // the next frame: command {velocity, facing}, metres per second and directions (x, z) in the world; a style vector
  step(command, style) {
    advance([this], [command], [style]);
  }

  // sets .rotations [J' * 4], local, and .root [3]
  pose(ik = { feet: true, arms: true }, pin = null) {
    pose(this.state, this.body, this.rules, ik, this.rotations, this.root, pin);
  }
}

// The next frame of characters that share a network, each with its command and style; the weights are read once for all.
export function advance(characters, commands, styles) {
  const [{ network, rules }] = characters;
  characters.forEach(({ state, spare, x }, c) => steer(state, commands[c], rules, x, spare));
  network.predict(characters.map(({ state, x, z }, c) => ({ x, z, phase: state.phase, style: styles[c] })));
  for (const character of characters) {
    const { state, spare, body, z } = character;
    afterNetwork(state, z, rules, spare);
    plant(spare, state, body, rules);
    [character.state, character.spare] = [spare, state];
  }
}

const LONGEST = 0.1; // seconds: a longer pause between two pictures is not made up for

// A character that walks on a ring around the origin, in a style of its own; way: 1 or -1
class Walker {
  constructor(data, network, vectors, { style, radius, angle, way, speed }) {
    const size = vectors.length / data.styles.length, at = [Math.sin(angle), Math.cos(angle)];
    Object.assign(this, { radius, way, speed, style: vectors.slice(size * style, size * (style + 1)) });
    this.character = new Character(data, network);
    this.character.state = stand(this.character.state, at.map((v) => radius * v), [way * at[1], -way * at[0]]);
  }

  // along the ring, and back to it where it has left it
  command() {
    const { history } = this.character.state, [x, z] = history.slice(-4), distance = Math.hypot(x, z) || 1, { way } = this;
    const back = (this.radius - distance) / distance;
    const ahead = unit([(way * z) / distance + back * x, (-way * x) / distance + back * z]);
    return { velocity: ahead.map((v) => this.speed * v), facing: ahead };
  }
}

// Traits of a page without a notebook, as a widget's model has them.
export class Model {
  constructor(traits = {}) {
    Object.assign(this, { traits, listeners: {} });
  }

  get(name) {
    return this.traits[name];
  }

  set(name, value) {
    this.traits[name] = value;
    this.emit(`change:${name}`);
  }

  save_changes() {}

  on(event, listener) {
    (this.listeners[event] ??= new Set()).add(listener);
  }

  off(event, listener) {
    this.listeners[event]?.delete(listener);
  }

  emit(event, ...what) {
    for (const listener of this.listeners[event] ?? []) listener(...what);
  }
}

export class Kernel extends Model {
  constructor(data) {
    super();
    const { styles, labels, vectors, rules, start } = data;
    Object.assign(this, { data, fps: rules.fps, character: new Character(data), vectors: numbers(vectors) });
    this.others = data.others.map((one) => new Walker(data, this.character.network, this.vectors, one));
    this.size = this.vectors.length / styles.length;
    const crowd = data.crowd && { skeleton: data.crowd, tints: data.others.map(({ tint }) => tint) };
    this.traits = { styles, labels, skeleton: data.skeleton, gate: data.gate, crowd, feet: true, arms: true, recording: false, status: "", ...data.traits };
    this.input = { id: 0, move: [0, 0], turn: 0, run: false, heading: null };
    this.facing = Math.atan2(...start.facing);
    this.style = this.target();
    this.frame = this.due = this.last = this.handle = 0;
    [this.recorded, this.passed] = [[], []];
    this.life = [this.style, ...this.others.map(({ style }) => style)].map((_, k) => new Life(data.life.amount, data.life.period, k));
  }

  set(name, value) {
    if (name === "recording") value ? (this.recorded = []) : this.download?.(this.bvh());
    const before = this.natural();
    super.set(name, value);
    if (["names", "weights"].includes(name) && this.traits.speed === before) super.set("speed", this.natural()); // nobody has set another
  }

  // the speed of the blend, m/s
  natural() {
    const { names, weights, styles } = this.traits;
    return names.reduce((sum, name, corner) => sum + weights[corner] * this.data.speeds[styles.indexOf(name)], 0);
  }

  send(message) {
    if (message.kind === "input") this.input = message;
    if (message.kind === "closed") cancelAnimationFrame(this.handle);
  }

  // the style vector of the blend at the triangle's marker
  target() {
    const { names, weights, styles } = this.traits, vector = new Float64Array(this.size);
    names.forEach((name, corner) => {
      const at = this.size * styles.indexOf(name);
      for (let i = 0; i < this.size; i++) vector[i] += weights[corner] * this.vectors[at + i];
    });
    return vector;
  }

  // the user's input as a command in world coordinates
  command() {
    const { move: [right, ahead], turn, run, heading } = this.input, { data, traits } = this;
    const fast = traits.speed * (run ? data.run : 1);
    if (heading) {
      this.facing = Math.atan2(...heading);
      return { velocity: heading.map((v) => fast * v), facing: heading };
    }
    this.facing += (data.turn / this.fps) * turn;
    const s = Math.sin(this.facing), c = Math.cos(this.facing), scale = fast / Math.max(1, Math.hypot(right, ahead));
    return { velocity: [scale * (ahead * s - right * c), scale * (ahead * c + right * s)], facing: [s, c] };
  }

  step() {
    const { style, character, data, traits } = this, target = this.target();
    for (let i = 0; i < style.length; i++) style[i] += data.ease * (target[i] - style[i]);
    const others = this.others.map((other) => other.character);
    const styles = [style, ...this.others.map((other) => other.style)].map((vector, k) => this.life[k].at(this.frame, vector));
    advance([character, ...others], [this.command(), ...this.others.map((other) => other.command())], styles);
    this.frame += 1;
    if (!traits.recording && !data.gate?.roles) return;
    character.pose(traits);
    this.passed.push([character.root.slice(), character.rotations.slice()]);
    if (traits.recording) this.recorded.push(this.passed.at(-1));
  }

  // the newest frame, as view/widgets/controller.py sends it
  show() {
    const { character, character: { state, rules } } = this;
    character.pose(this.traits);
    const past = rules.samples.slice(0, rules.samples.length - rules.position_shares.length);
    const parts = [character.root, character.rotations, ...past.map((i) => state.history.subarray(4 * i, 4 * i + 4)),
                   state.future, state.contacts, state.phase];
    const buffer = Float32Array.from(parts.flatMap((part) => [...part]));
    for (const { character: other } of this.others) other.pose(this.traits);
    if (this.others.length)
      this.emit("msg:custom", { kind: "others" }, [this.others.map(({ character: { root, rotations } }) => [root, rotations])]);
    this.emit("msg:custom", { kind: "frame", frame: this.frame, input: this.input.id, passed: this.passed.splice(0) }, [buffer]);
  }

  // Frames at their own rate, independent of the screen's: for each picture of the screen the frames that are due, rounded.
  run() {
    const tick = (now) => {
      this.handle = requestAnimationFrame(tick);
      this.due += this.fps * Math.min((now - (this.last || now)) / 1000, LONGEST);
      this.last = now;
      const steps = Math.round(this.due);
      this.due -= steps;
      try {
        for (let i = 0; i < steps; i++) this.step();
        if (steps) this.show();
      } catch (error) { // shown in the page
        cancelAnimationFrame(this.handle);
        this.set("status", `stopped: ${error}`);
        throw error;
      }
    };
    this.handle = requestAnimationFrame(tick);
  }

  bvh() {
    return bvh(this.data.bvh, this.recorded, this.fps);
  }
}

// frames [[root, rotations]] as BVH text, angles in degrees about Y, X and Z
export function bvh({ header, joints, centimetre }, frames, fps) {
  const degree = Math.PI / 180, text = (v) => v.toFixed(6);
  const rows = frames.map(([root, q]) => {
    const row = Array.from(root, (v) => v / centimetre);
    for (const j of joints) {
      const [w, x, y, z] = q.subarray(4 * j, 4 * j + 4), sine = Math.min(Math.max(2 * (w * x - y * z), -1), 1);
      const angles = [Math.atan2(2 * (w * y + x * z), 1 - 2 * (x * x + y * y)), Math.asin(sine),
                      Math.atan2(2 * (w * z + x * y), 1 - 2 * (x * x + z * z))];
      row.push(...angles.map((a) => a / degree));
    }
    return row.map(text).join(" ");
  });
  return [`${header}MOTION`, `Frames: ${rows.length}`, `Frame Time: ${(1 / fps).toFixed(8)}`, ...rows, ""].join("\n");
}
