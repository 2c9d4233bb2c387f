// A shot as data, its plan and the character that walks it (shots/shot.py, shots/keys.py; shots/feasibility.py for what is missed).
//
// A shot here has every field of `toolkit.extra.shots.Shot`, with null where there is none:
//   path [{x, z, time, facing}], styles [{time, blend, easing}], speeds [{time, speed, easing}], holds [{seconds, time, distance}],
//   smooth, facing, look_at, feet, arms, seed, duration, name, radius;  a blend is weights by style, or a list of them, one for each layer
// desk: {rules, limits, styles: [names], vectors, size, speeds: [m/s]}, see shots/director.py
import { advance, Character } from "./character.js";
import { between, command, Course, Curve, EASINGS, Heading, keyed, nearest, round } from "./course.js";
import { copy, stand } from "./frame.js";
import { Life } from "./life.js";
import { LIMBS, PARTS, stations } from "./pins.js";

const FAR = 1000, FAST = 20, MANY = 256, LONGEST = 600, SEEDS = 2 ** 31 - 1, EVERY = 30, GOLDEN = (Math.sqrt(5) - 1) / 2;
const SCENE = ["version", "shots", "apart", "walls"];
const FIELDS = {
  Point: ["x", "z", "time", "facing"], StyleKey: ["time", "blend", "easing"], SpeedKey: ["time", "speed", "easing"],
  Hold: ["seconds", "time", "distance"], Wall: ["start", "end"],
  Shot: ["path", "styles", "speeds", "holds", "smooth", "facing", "look_at", "feet", "arms", "seed", "duration", "name", "radius", "pins"],
  Pin: ["at", "to", ...PARTS],
};

function demand(right, text) {
  if (!right) throw new Error(text);
}
const isObject = (value) => value !== null && typeof value === "object" && !Array.isArray(value);

function number(value, what, low, high) {
  demand(typeof value === "number" && value >= low && value <= high, `${what} must be a number from ${low} to ${high}`);
  return value;
}
const optional = (value, read) => (value == null ? null : read(value));

function pair(value, what, axes = "xz") {
  const kind = axes.length === 2 ? "a pair" : `${axes.length} numbers`;
  demand(Array.isArray(value) && value.length === axes.length, `${what} must be ${kind} (${[...axes].join(", ")})`);
  return value.map((v, i) => number(v, `${axes[i]} of ${what}`, -FAR, FAR));
}

function pinOf(given) {
  const made = { at: number(given.at, "at", 0, LONGEST), to: optional(given.to, (v) => number(v, "to", 0, LONGEST)) };
  demand(made.to === null || made.to > made.at, "to must be after at");
  demand(PARTS.some((part) => given[part] != null), `a pin needs one of ${PARTS.join(", ")}`);
  for (const part of [...LIMBS, "look"]) made[part] = optional(given[part], (v) => pair(v, part, "xyz"));
  made.pose = optional(given.pose, (pose) => {
    demand(isObject(pose), "pose must have four numbers by joint");
    const turns = Object.entries(pose).map(([name, q]) => [name, pair(q, `the rotation of ${name}`, "wxyz")]);
    demand(turns.every(([, q]) => Math.abs(Math.hypot(...q) - 1) <= 1e-3), "pose: rotations must be quaternions of length 1");
    return Object.fromEntries(turns);
  });
  return made;
}

function direction(value, what) {
  const [x, z] = pair(value, what);
  demand(Math.hypot(x, z) >= 1e-6, `${what} must not be zero`);
  return [x, z];
}

// the fields of an object, or of a list of the first ones
function fields(value, kind) {
  const known = FIELDS[kind];
  if (Array.isArray(value) && value.length <= known.length) return Object.fromEntries(value.map((v, i) => [known[i], v]));
  demand(isObject(value), `expected the fields of a ${kind}`);
  for (const name of Object.keys(value)) demand(known.includes(name), `unknown field ${JSON.stringify(name).slice(0, 60)}`);
  return value;
}

function entries(values, what, kind, read) {
  demand(Array.isArray(values), `${what} must be a list`);
  demand(values.length <= MANY, `${what}: at most ${MANY} entries, got ${values.length}`);
  return values.map((value, k) => {
    try {
      return read(fields(value, kind));
    } catch (error) {
      throw new Error(`${what}[${k}]: ${error.message}`);
    }
  });
}

const easing = (value = "smooth") => {
  demand(typeof value === "string" && Object.hasOwn(EASINGS, value), `easing must be one of ${Object.keys(EASINGS).join(", ")}`);
  return value;
};

function blend(value, styles) {
  const layers = typeof value === "string" ? [{ [value]: 1 }] : Array.isArray(value) ? value : [value];
  demand(layers.length, "a blend is a style's name or weights of styles");
  for (const layer of layers) {
    demand(isObject(layer) && Object.keys(layer).length, "a blend is a style's name or weights of styles");
    const names = Object.keys(layer);
    for (const name of names) demand(styles.includes(name), `unknown style ${JSON.stringify(name).slice(0, 60)}`);
    const sum = names.reduce((total, name) => total + number(layer[name], `the weight of ${name}`, -FAR, FAR), 0);
    demand(Math.abs(sum - 1) <= 1e-4, `the weights of a blend must sum to 1, got ${Number(sum.toFixed(6))}`);
  }
  return layers.length > 1 ? layers : layers[0];
}

function rising(keys, what) {
  keys.forEach((key, k) => demand(!k || key.time > keys[k - 1].time, `${what}[${k}]: times must increase`));
}

// A shot from what a file holds; an Error of one line that names the field and the entry.
export function shot(value, styles) {
  const given = fields(value, "Shot"), time = (v) => number(v, "time", 0, LONGEST);
  const path = entries(given.path ?? [], "path", "Point", (p) => ({
    x: number(p.x, "x", -FAR, FAR), z: number(p.z, "z", -FAR, FAR), time: optional(p.time, time),
    facing: optional(p.facing, (v) => direction(v, "facing")),
  }));
  const keys = typeof given.styles === "string" ? [[0, given.styles]] : given.styles ?? [];
  const made = {
    path,
    styles: entries(keys, "styles", "StyleKey",
      (k) => ({ time: time(k.time), blend: blend(k.blend, styles), easing: easing(k.easing) })),
    speeds: entries(given.speeds ?? [], "speeds", "SpeedKey",
      (k) => ({ time: time(k.time), speed: number(k.speed, "speed", 0, FAST), easing: easing(k.easing) })),
    holds: entries(given.holds ?? [], "holds", "Hold", (h) => {
      demand((h.time == null) !== (h.distance == null), "a hold needs either a time or a distance");
      return { seconds: number(h.seconds, "seconds", 0, LONGEST), time: optional(h.time, time),
               distance: optional(h.distance, (v) => number(v, "distance", 0, 1e6)) };
    }),
    smooth: given.smooth ?? true, facing: optional(given.facing, (v) => direction(v, "facing")),
    look_at: optional(given.look_at, (v) => pair(v, "look_at")), feet: given.feet ?? true, arms: given.arms ?? true,
    seed: number(given.seed ?? 0, "seed", 0, SEEDS), name: given.name ?? "shot",
    duration: optional(given.duration, (v) => number(v, "duration", 1 / 60, LONGEST)),
    radius: optional(given.radius, (v) => number(v, "radius", 0.05, 5)),
    pins: entries(given.pins ?? [], "pins", "Pin", pinOf),
  };
  demand(path.length > 1, `path: two or more points are needed, got ${path.length}`);
  const ways = path.slice(1).map((p, k) => Math.hypot(p.x - path[k].x, p.z - path[k].z)), length = ways.reduce((sum, way) => sum + way, 0);
  ways.forEach((way, k) => demand(way >= 0.01, `path[${k + 1}]: is less than 1 cm from the point before it`));
  demand(length <= LONGEST * FAST, `path: is ${length.toFixed(0)} m long, a path has at most ${LONGEST * FAST} m`);
  rising(path.slice(1).filter((p) => p.time !== null), "path, points with a time");
  demand(!path[0].time, "path[0]: the first point has the time 0");
  demand(path.slice(1).every((p) => p.time !== 0), "path: only the first point can have the time 0");
  demand(made.styles.length, "styles: one or more keys are needed");
  rising(made.styles, "styles");
  rising(made.speeds, "speeds");
  demand(new Set(made.styles.map((key) => layersOf(key.blend).length).filter((n) => n > 1)).size < 2,
    "styles: all blends by layer need the same number of layers");
  for (const name of ["smooth", "feet", "arms"]) demand(typeof made[name] === "boolean", `${name} must be true or false`);
  demand(!made.facing || !made.look_at, "give either facing or look_at, not both");
  demand(Number.isInteger(made.seed), "seed must be a whole number");
  const named = typeof made.name === "string" && made.name.length <= 100 && !/\p{C}/u.test(made.name);
  demand(named, "name must be a line of up to 100 characters");
  return made;
}

// {shots, more} of a scene, more: {apart, walls} or {}; an Error of one line.
export function parse(scene, styles) {
  demand(isObject(scene) && "version" in scene && "shots" in scene, "expected an object with the fields version and shots");
  for (const name of Object.keys(scene)) demand(SCENE.includes(name), `unknown field ${JSON.stringify(name).slice(0, 60)}`);
  demand(scene.version === 1, "this page reads version 1 of shots");
  demand(Array.isArray(scene.shots) && scene.shots.length, "shots: one or more are needed");
  const walls = entries(scene.walls ?? [], "walls", "Wall", (wall) => ({ start: pair(wall.start, "start"), end: pair(wall.end, "end") }));
  walls.forEach(({ start: [a, b], end: [c, d] }, k) =>
    demand(Math.hypot(a - c, b - d) >= 0.01, `walls[${k}]: start and end are less than 1 cm apart`));
  const apart = optional(scene.apart, (v) => number(v, "apart", 0.1, 5));
  demand(apart !== null || !walls.length, "walls are only avoided by characters who keep apart: give apart, metres");
  const shots = entries(scene.shots, "shots", "Shot", (value) => shot(value, styles));
  return { shots, more: starts(shots, apart === null ? {} : walls.length ? { apart, walls } : { apart }) };
}

// the share of a character in the distance of two who keep apart
export const radiusOf = (shot, { apart }) => shot.radius ?? apart / 2;

// the other fields of a scene; an Error if two characters who keep apart start closer
export function starts(shots, more) {
  if (more.apart !== undefined) shots.forEach((shot, b) => shots.slice(0, b).forEach((one, a) => {
    const [{ x, z }, other] = [shot.path[0], one.path[0]], distance = Math.hypot(x - other.x, z - other.z);
    const least = radiusOf(shot, more) + radiusOf(one, more), pair = `shots[${a}] and shots[${b}] start ${distance.toFixed(2)} m`;
    demand(!(distance < least), `${pair} from each other, closer than the ${least.toFixed(2)} m that they keep`);
  }));
  return more;
}

// the scene of shots, as a file holds it: fields without a value are left out; more: its other fields
export function data(shots, more = {}) {
  const lean = (value) => {
    if (Array.isArray(value)) return value.map(lean);
    if (!isObject(value)) return value;
    return Object.fromEntries(Object.entries(value).filter(([, v]) => v !== null).map(([name, v]) => [name, lean(v)]));
  };
  return { version: 1, shots: lean(shots), ...more };
}

export const layersOf = (blend) => (Array.isArray(blend) ? blend : [blend]);

// natural speed of a blend: of blends by layer, the mean
export function speedOf(blend, { styles, speeds }) {
  const layers = layersOf(blend), each = layers.flatMap((layer) => Object.entries(layer));
  return each.reduce((sum, [name, weight]) => sum + weight * speeds[styles.indexOf(name)], 0) / layers.length;
}

// the blend of style keys at a time; of blends by layer, that of the key before
export function blendAt(keys, time) {
  const [a, b, weight] = between(keys.map((key) => key.time), keys.map((key) => key.easing), time);
  const from = keys[a].blend, to = keys[b].blend;
  if (!weight || Array.isArray(from) || Array.isArray(to)) return from;
  const made = Object.fromEntries(Object.entries(from).map(([name, w]) => [name, (1 - weight) * w]));
  for (const [name, w] of Object.entries(to)) made[name] = (made[name] ?? 0) + weight * w;
  return made;
}

// style vector of a blend
function vectorOf(blend, { styles, vectors, size }) {
  const layers = layersOf(blend), part = size / layers.length, made = new Float64Array(size);
  layers.forEach((layer, l) => {
    for (const [name, weight] of Object.entries(layer)) {
      const at = size * styles.indexOf(name);
      for (let i = l * part; i < (l + 1) * part; i++) made[i] += weight * vectors[at + i];
    }
  });
  return made;
}

const keysOf = (keys, value) => ({ times: keys.map((k) => k.time), easings: keys.map((k) => k.easing), values: keys.map(value) });
const naturalOf = (shot, desk) => keysOf(shot.styles, (key) => Math.min(Math.max(speedOf(key.blend, desk), 0), FAST));

// {course, heading, natural} of a shot
export function plan(shot, desk) {
  const base = planned(shot, desk, shot.path.map((point, k) => ({ name: `path[${k}]`, point, pause: 0 })));
  let now = base;
  for (let k = 0; k < 2 && shot.pins.length; k++) now = planned(shot, desk, stations(shot.pins, shot.path, base, now, desk.pins));
  return now;
}

// a plan through stops {name, point, pause}
function planned(shot, desk, stops) {
  const curve = new Curve(stops.map(({ point: p }) => [p.x, p.z]), shot.smooth, desk.rules), natural = naturalOf(shot, desk), { knots } = curve;
  const speeds = shot.speeds.length ? keysOf(shot.speeds, (key) => key.speed) : natural;
  const timed = stops.flatMap(({ name, point: { time } }, k) => (k && time !== null ? [[name, knots[k], time]] : []));
  const holds = [...shot.holds, ...stops.flatMap(({ pause }, k) => (pause ? [{ time: null, distance: knots[k], seconds: pause }] : []))];
  curve.knots = knots.filter((_, k) => stops[k].name.startsWith("path"));
  const turns = shot.path.map((p) => (p.facing ? Math.atan2(...p.facing) : null));
  return { course: new Course(curve, speeds, timed.map(([, at, time]) => [at, time]), holds, shot.duration),
           heading: new Heading(curve, shot.facing, shot.look_at, turns), natural, timed };
}

// every phase later by an angle
function shifted(phase, angle) {
  const s = Math.sin(angle), c = Math.cos(angle);
  for (let i = 0; angle && i + 1 < phase.length; i += 2) {
    const x = phase[i], y = phase[i + 1];
    phase.set([c * x - s * y, s * x + c * y], i);
  }
}

// Number of frames from the first on that two plans {shot, course, heading} cannot tell apart: their commands and styles are the same.
function shared({ shot, course: a, heading }, { shot: before, course: b, heading: other }) {
  const { FPS, LEAD, BEFORE, SPACING } = a.rules, key = ({ seed, facing, look_at: look }) => JSON.stringify([seed, facing, look]);
  if (key(shot) !== key(before)) return 0;
  const differs = (count, same) => {
    for (let k = 0; k < count; k++) if (!same(k)) return k;
    return Infinity;
  };
  // up to which arc length the curves and their turns are equal, and up to which time the styles
  const [c, d] = [a.curve, b.curve], most = (one, two) => Math.max(one.length, two.length);
  const sample = differs(most(c.at, d.at), (k) => c.x[k] === d.x[k] && c.z[k] === d.z[k] && c.at[k] === d.at[k]);
  const knot = differs(most(c.knots, d.knots), (k) => c.knots[k] === d.knots[k] && heading.offsets[k] === other.offsets[k]);
  const metres = Math.min(sample < Infinity ? c.at[sample - 1] ?? 0 : sample, knot < Infinity ? c.knots[knot - 1] ?? 0 : knot);
  const style = differs(most(shot.styles, before.styles), (k) => JSON.stringify(shot.styles[k]) === JSON.stringify(before.styles[k]));
  const seconds = style < Infinity ? shot.styles[style - 1]?.time ?? -1 : style, ahead = round(LEAD * FPS);
  // a command looks LEAD ahead in time, and BEFORE along the curve (nearest)
  const at = (row, frame) => row[Math.min(frame, row.length - 1)];
  const same = (frame) => at(a.distance, frame) === at(b.distance, frame) && at(a.speed, frame) === at(b.speed, frame);
  return Math.min(a.distance.length, differs(a.distance.length, (frame) => frame / FPS <= seconds && same(frame)
    && same(frame + ahead) && at(a.distance, frame + ahead) + BEFORE + 4 * SPACING < metres));
}

// A character on its way through a shot, asked for at a time in ms. It goes on from where it differs from older takes.
// `frames` has what draws each: {history, joints, toes, drop, swivel, contacts}; `kept` the whole state every EVERY frames.
export class Take {
  constructor(shot, desk, character, since = 0, older = []) {
    Object.assign(this, { shot, ...plan(shot, desk), character, since, frames: [], places: [], kept: [] });
    const { course, heading } = this, place = course.curve.point(0), angle = heading.angle(0, place);
    this.count = course.distance.length - 1, this.clock = 0; // frame of the plan: behind those of the character where it waits
    this.styles = keysOf(shot.styles, (key) => vectorOf(key.blend, desk));
    this.style = new Float64Array(desk.size), this.life = new Life(desk.data.life.amount, desk.data.life.period, shot.seed);
    character.state = stand(character.first, place, [Math.sin(angle), Math.cos(angle)]);
    character.spare = stand(character.first, place, [Math.sin(angle), Math.cos(angle)]);
    for (const { phase } of [character.state, character.spare]) shifted(phase, 2 * Math.PI * ((shot.seed * GOLDEN) % 1));
    for (const old of older) {
      const { kept } = old, same = Math.min(shared(this, old), old.frames.length, this.count);
      const frame = EVERY * Math.min(Math.floor(same / EVERY), kept.length - 1);
      if (frame <= this.frames.length) continue;
      Object.assign(this, { frames: old.frames.slice(0, frame), places: old.places.slice(0, frame), kept: kept.slice(0, frame / EVERY) });
      character.state = copy(kept[frame / EVERY]);
    }
  }

  get place() {
    return [...this.character.state.history.slice(-4, -2)];
  }

  // sets the style of the next frame; returns its command
  ask() {
    const { clock, styles: { times, easings, values } } = this, style = new Float64Array(this.style.length);
    const [a, b, weight] = between(times, easings, clock / this.course.rules.FPS);
    for (let i = 0; i < style.length; i++) style[i] = values[a][i] + weight * (values[b][i] - values[a][i]);
    this.style.set(this.life.at(clock, style));
    return command(this.course, this.heading, clock, this.place);
  }

  // the frame that the character is in is the next one
  note() {
    const { state } = this.character, place = state.history.slice(-4);
    this.frames.push({ history: place, joints: new Float32Array(state.joints), ...Object.fromEntries(["toes", "drop", "swivel", "contacts"].map((part) => [part, state[part].slice()])) });
    this.places.push([place[0], place[1]]);
    this.count = Math.max(this.count, this.frames.length);
  }

  // the next frame, alone; whether there is one
  step() {
    const { character, frames: { length } } = this;
    if (length >= this.count) return false;
    if (length % EVERY === 0) this.kept.push(copy(character.state));
    this.clock = length;
    const asked = this.ask();
    advance([character], [asked], [this.style]);
    this.note();
    if (length + 1 === this.count) this.apart = beside(this);
    return true;
  }
}

// distance from the curve of each place, metres
export function beside({ course: { curve, distance }, places, apart }) {
  return apart ?? places.map(([x, z], k) => {
    const [px, pz] = curve.point(nearest(curve, [x, z], distance[Math.min(k + 1, distance.length - 1)]));
    return Math.hypot(px - x, pz - z);
  });
}

// radius of the curve at an arc length
function radius({ curve }, distance, { REACH }) {
  const at = Math.min(Math.max(distance, REACH), Math.max(curve.length - REACH, REACH));
  const [ax, az] = curve.tangent(at - REACH), [bx, bz] = curve.tangent(at + REACH);
  return (2 * REACH) / Math.max(Math.abs(Math.atan2(ax * bz - az * bx, ax * bx + az * bz)), 1e-3);
}

// the style of the largest share at a time; of a blend by layer, in the first layer
function styleAt({ styles }, now) {
  const [a, b, weight] = between(styles.map((key) => key.time), styles.map((key) => key.easing), now);
  const shares = Object.entries(layersOf(styles[weight > 0.5 ? b : a].blend)[0]);
  return shares.reduce((best, other) => (other[1] > best[1] ? other : best))[0];
}

// What a take misses and why, a line each (Shot.check).
export function missed(take, limits) {
  const { course, natural, timed, places, shot } = take, { curve, distance, speed, rules: { FPS } } = course, lines = [];
  const seconds = (distance.length - 1) / FPS, plain = (v) => String(Number(v.toPrecision(6)));
  const usual = (frame) => Math.max(keyed(natural, frame / FPS), limits.SLOW), times = (frame) => speed[frame] / usual(frame);
  const said = (frame) => `the speed is ${speed[frame].toFixed(2)} m/s, ${times(frame).toFixed(1)} times that of the style`;
  const best = (count, better, first = 0) => {
    let at = first;
    for (let k = first; k < count; k++) if (better(k, at)) at = k;
    return at;
  };
  for (const k of course.late) lines.push(`${timed[k][0]} is too far away to be reached at ${plain(timed[k][2])} s`);
  if (course.end === null || course.end > seconds + 1e-9)
    lines.push(`the end of the path is not reached in ${plain(seconds)} s: ${(curve.length - distance.at(-1)).toFixed(1)} m are left`);
  shot.holds.forEach((hold, k) => {
    if (hold.distance === null || hold.distance <= curve.length) return;
    lines.push(`holds[${k}] is after the end of the path, ${curve.length.toFixed(2)} m long`);
  });
  if (!places.length) return lines;
  const fast = best(places.length + 1, (a, b) => times(a) > times(b), 1);
  if (speed[fast] > limits.FASTER * usual(fast))
    lines.push(`at ${(fast / FPS).toFixed(1)} s ${said(fast)}: slow down or choose a faster style`);
  const apart = beside(take), worst = best(apart.length, (a, b) => apart[a] > apart[b]);
  const mean = apart.reduce((sum, v) => sum + v, 0) / apart.length;
  if (apart[worst] > limits.OFF) {
    const tight = (k) => radius(course, distance[k], limits);
    const turn = best(worst + 2, (a, b) => tight(a) < tight(b), Math.max(worst + 1 - FPS, 1));
    const stands = speed.findIndex((v, k) => k >= Math.max(worst + 1 - FPS, 1) && k <= worst + 1 && v < limits.SLOW && distance[k] > 0 && distance[k] < curve.length);
    const why = stands > 0 ? `it does not stand still in the pause after ${distance[stands].toFixed(1)} m; slow down before it, or pause elsewhere` : speed[turn] ** 2 > limits.EASY * tight(turn)
      ? `the turn after ${distance[turn].toFixed(1)} m, of radius ${tight(turn).toFixed(1)} m, is too tight at ${speed[turn].toFixed(2)} m/s; `
        + "widen it or slow down there"
      : `${styleAt(shot, worst / FPS)} does not keep to it; choose another style there`;
    lines.push(`at ${((worst + 1) / FPS).toFixed(1)} s the character is ${(100 * apart[worst]).toFixed(0)} cm from the path: ${why}`);
  } else if (mean > limits.BESIDE) lines.push(`the character is ${(100 * mean).toFixed(0)} cm from the path on average`);
  const lag = (k) => distance[k + 1] - nearest(curve, places[k], distance[k + 1]);
  const late = places.findIndex((_, k) => Math.abs(lag(k)) > limits.LAG) + 1;
  if (late)
    lines.push(`from ${(late / FPS).toFixed(1)} s on the character is ` + (lag(late - 1) > 0
      ? `behind the plan: ${said(late)}; slow down or leave more time`
      : `ahead of the plan: ${styleAt(shot, late / FPS)} does not stand or walk as slowly; choose another style there`));
  for (const [name, at, time] of timed) {
    if (!name.startsWith("path") || round(time * FPS) > places.length) continue;
    const [wait, metres] = arrival(curve.point(at), time, places, limits, FPS);
    if (!wait && metres <= limits.NEAR) continue;
    const when = wait === Infinity ? "never" : `${Math.abs(wait).toFixed(1)} s ${wait > 0 ? "late" : "early"}`;
    lines.push(`${name} is met ${when}: at ${plain(time)} s the character is ${(100 * metres).toFixed(0)} cm away`);
  }
  return lines;
}

function arrival([x, z], time, places, { SECONDS, NEAR }, FPS) {
  const apart = places.map(([px, pz]) => Math.hypot(px - x, pz - z)), frame = (s) => Math.max(round((time + s) * FPS) - 1, 0);
  const nearby = Math.min(...apart.slice(frame(-SECONDS), frame(SECONDS) + 1));
  if (nearby <= NEAR) return [0, nearby];
  let wait = Infinity;
  for (let k = Math.max(round((time - 2) * FPS), 0); k < Math.min(round((time + 2) * FPS), apart.length); k++)
    if (apart[k] <= NEAR && Math.abs((k + 1) / FPS - time) < Math.abs(wait)) wait = (k + 1) / FPS - time;
  return [wait, nearby];
}
