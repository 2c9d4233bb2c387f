// Hands, feet, the look and the pose of a walking character, pinned at times (shots/pins.py and reaching.py, whose functions these are).
//
// rules: the constants of both, and FPS; body: see pose.js; figure: {spine, neck: [joint], arms: [[shoulder, elbow, hand]], facing, names},
// right before left. A pin: {at, to, right_hand, left_hand, right_foot, left_foot, look, pose}, null where there is none.
import { round } from "./course.js";
import { unit } from "./frame.js";
import { across, between, cross, dot, kinematics, minus, multiply, plus, rotate, twoBone } from "./pose.js";

const SIDES = ["right", "left"], HANDS = SIDES.map((side) => `${side}_hand`), FEET = SIDES.map((side) => `${side}_foot`);
export const LIMBS = [...HANDS, ...FEET], PARTS = [...LIMBS, "look", "pose"], DOWN = [0, -1, 0];
const times = (v, share) => v.map((x) => x * share), long = (v) => Math.hypot(...v), clamp = (v, a, b) => Math.min(Math.max(v, a), b);
const smoother = (u) => u * u * u * (u * (6 * u - 15) + 10), level = ([x, , z]) => [x, 0, z];
export const endOf = (pin) => pin.to ?? pin.at;

// [[pin, weight]] of a part at a time, and the weight of all
function weights(pins, part, now, { BLEND }) {
  const found = [];
  let end = -Infinity, free = 1;
  for (const pin of pins.filter((one) => one[part] != null).sort((a, b) => a.at - b.at)) {
    const begin = Math.max(pin.at - BLEND, end), into = (now - begin) / Math.max(pin.at - begin, 1e-6);
    const w = smoother(clamp(Math.min(into, (endOf(pin) + BLEND - now) / BLEND), 0, 1));
    found.push([pin, w]), (end = endOf(pin)), (free *= 1 - w);
  }
  return [found, 1 - free];
}

const facing = ({ course: { curve }, heading }, distance) => {
  const angle = heading.angle(distance, curve.point(distance));
  return [Math.sin(angle), Math.cos(angle)];
};

// the stops of a path, {name, point, pause}, and those that pins need
export function stations(pins, path, base, now, r) {
  const { curve } = base.course, knots = Object.fromEntries(now.timed.map(([name, distance]) => [name, distance])), added = [];
  let low = 0;
  for (const [k, pin] of [...pins.entries()].sort(([, a], [, b]) => a.at - b.at)) {
    const limbs = LIMBS.filter((limb) => pin[limb] != null), name = `pins[${k}]`;
    if (!limbs.length) continue;
    const mean = (of) => limbs.reduce((sum, limb) => sum + of(limb), 0) / limbs.length;
    const goal = [0, 2].map((i) => mean((limb) => pin[limb][i])), side = mean((limb) => (limb.startsWith("left") ? 1 : -1));
    const foot = !limbs.some((limb) => HANDS.includes(limb)), [ahead, aside] = foot ? [r.STEP, r.BESIDE * side] : [r.AHEAD, r.ASIDE * side];
    const far = (d) => Math.hypot(...curve.point(d).map((v, i) => v - goal[i]));
    let distance = curve.at.filter((d) => d >= low).reduce((best, d) => (best === null || far(d) < far(best) ? d : best), null) ?? low;
    const out = far(distance) > r.DETOUR;
    distance = Math.max(distance - ahead, low);
    if (out || distance < r.LEAST) continue;
    low = distance + r.LEAST;
    let [x, z] = curve.point(distance), [s, c] = facing(base, distance);
    const left = (goal[0] - x) * c - (goal[1] - z) * s, before = (goal[0] - x) * s + (goal[1] - z) * c;
    const off = Math.hypot(before, left - r.SHOULDER * side);
    if (foot || side * left < r.ACROSS || off < r.CLOSE || off > r.NEAR) {
      if (name in knots) [s, c] = facing(now, knots[name]);
      (x = goal[0] - ahead * s - aside * c), (z = goal[1] - ahead * c + aside * s);
    }
    const taken = [...path, ...added.map(([, { point }]) => point)];
    while (taken.some((p) => Math.hypot(p.x - x, p.z - z) < r.LEAST)) (x += r.LEAST * s), (z += r.LEAST * c);
    const spare = foot ? r.BLEND + r.SETTLE : 0, pause = endOf(pin) - pin.at + 2 * spare;
    added.push([distance, { name, point: { x, z, time: Math.max(pin.at - spare, 1 / r.FPS) }, pause: pause > r.PASSED ? pause : 0 }]);
  }
  return path.flatMap((point, i) => [{ name: `path[${i}]`, point, pause: 0 },
    ...added.filter(([d]) => curve.knots[i] <= d && d < (curve.knots[i + 1] ?? Infinity)).map(([, stop]) => stop)]);
}

function limited(v, most) {
  const size = long(v), over = size / most - 0.9;
  return over > 0 ? times(v, (most * (1 - 0.1 * Math.exp(-10 * over))) / size) : v;
}
const turn = (v) => {
  const size = long(v), half = Math.sin(size / 2) / Math.max(size, 1e-9);
  return [Math.cos(size / 2), ...times(v, half)];
};
const arc = (a, b) => {
  const axis = cross(a, b), size = long(axis);
  return times(axis, Math.atan2(size, dot(a, b)) / Math.max(size, 1e-9));
};
function swung(from, to, aside, w) {
  const a = unit(from), b = unit(to), middle = unit(plus(plus(a, b), aside, 1 / 3));
  const [c, d] = [[a, middle], [middle, b]].map(([start, goal]) => rotate(turn(times(arc(start, goal), w)), start));
  return rotate(turn(times(arc(c, d), w)), c);
}
function looked(ahead, way, { LOOK, BEHIND }) {
  const whole = arc(ahead, way), fade = clamp((Math.PI - long(whole)) / BEHIND, 0, 1);
  return times(limited(whole, LOOK), fade * fade * (3 - 2 * fade));
}
function slerp(a, b, t) {
  const d = a.reduce((sum, v, i) => sum + v * b[i], 0), other = d < 0 ? times(b, -1) : b, near = Math.abs(d) > 1 - 1e-7;
  const angle = Math.acos(near ? 0 : Math.abs(d)), [p, q] = near ? [1 - t, t] : [Math.sin((1 - t) * angle), Math.sin(t * angle)].map((v) => v / Math.sin(angle));
  return unit(a.map((v, i) => p * v + q * other[i]));
}

// by how much a limb is too short for a place, or too long, and how far it is
function lacks(way, [a, b, c], { REACH, FOLD, SMOOTH }) {
  const far = Math.max(long(way), 1e-6), full = long(minus(b, a)) + long(minus(c, b));
  const soft = (over) => (over > SMOOTH ? over : Math.max(over + SMOOTH, 0) ** 2 / (4 * SMOOTH));
  return [soft(far - REACH * full) - soft(FOLD * full - far), far];
}

function leaned(p, goals, body, { spine, arms }, r) {
  let bend = [0, 0, 0], move = [0, 0, 0], sink = 0;
  const bones = spine.slice(1).map((j, k) => minus(p[j], p[spine[k]])), deep = (v) => limited([v, 0, 0], r.SINK)[0];
  const shifted = () => plus(move, DOWN, sink + dot(move, move));
  for (let round = 0; round < r.ROUNDS; round++) SIDES.forEach((_, side) => {
    const foot = goals[FEET[side]], leg = body.legs[side].slice(0, 3).map((j) => p[j]);
    sink = deep(sink + foot.weight * Math.max(lacks(minus(minus(foot.goal, leg[0]), shifted()), leg, r)[0], 0));
    const { goal, weight } = goals[HANDS[side]], arm = arms[side].map((j) => p[j]), hips = plus(p[spine[0]], shifted());
    const chest = bones.reduce((at, bone, k) => plus(at, rotate(turn(times(bend, (k + 1) / spine.length)), bone)), hips);
    const shoulder = plus(chest, rotate(turn(bend), minus(arm[0], p[spine.at(-1)]))), way = minus(goal, shoulder);
    const [size, far] = lacks(way, arm, r), lack = times(way, (weight * size) / far), lever = minus(shoulder, hips);
    bend = limited(plus(bend, cross(lever, lack), 0.7 / dot(lever, lever)), r.LEAN);
    move = limited(plus(move, level(lack), 1 / 4), r.SHIFT);
    sink = deep(sink + (clamp((-way[1] - r.LOW) / (r.LOWEST - r.LOW), 0, 1) * weight * Math.max(size, 0)) / 2);
  });
  return [bend, shifted()];
}

// the pose mixed with those of pins: world rotations, place of the root
function posed(found, turned, root, body, { facing: axis, names }) {
  const inverse = ([w, ...v]) => [w, ...times(v, -1)], local = turned.map((q, j) => (j ? multiply(inverse(turned[body.parents[j]]), q) : q));
  const [x, , z] = rotate(turned[0], axis), angle = Math.atan2(x, z) / 2, heading = [Math.cos(angle), 0, Math.sin(angle), 0];
  let mixed = local, height = root[1];
  const chained = (rows) => rows.reduce((all, q, j) => [...all, j ? multiply(all[body.parents[j]], q) : q], []);
  for (const [pin, w] of found) {
    const goal = local.map((q, j) => pin.pose[names[j]] ?? q), places = [[0, 0, 0]];
    places.length = goal.length, kinematics(body, chained(goal), places);
    goal[0] = multiply(heading, goal[0]), (mixed = mixed.map((q, j) => slerp(q, goal[j], w)));
    height -= w * (Math.min(...places.map((place) => place[1])) + height);
  }
  return [chained(mixed), [root[0], height, root[2]]];
}

// Changes world rotations and the root's place of a frame, counted from 1, so that pins are met; `plant` puts the toes [right, left].
export function pinned(turned, places, frame, { shot: { pins }, course }, body, figure, r, plant) {
  const now = frame / r.FPS, { curve, distance } = course;
  const there = (time) => curve.point(distance[Math.min(round(time * r.FPS), distance.length - 1)]);
  const near = pins.filter((pin) => LIMBS.every((limb) => pin[limb] == null || [pin.at, endOf(pin)].every((time) =>
    Math.hypot(there(time)[0] - pin[limb][0], there(time)[1] - pin[limb][2]) <= r.FAR)));
  const parts = Object.fromEntries(PARTS.map((part) => [part, weights(near, part, now, r)]));
  if (PARTS.every((part) => !parts[part][1])) return;
  const { spine, neck, arms } = figure, steps = [...turned];
  kinematics(body, turned, places);
  const before = [...places], hips = body.legs.map(([hip]) => hip), put = (rows) => rows.forEach((q, j) => (turned[j] = q));
  const [mixed, root] = posed(parts.pose[0], turned, places[0], body, figure);
  put(mixed), (places[0] = root), kinematics(body, turned, places);
  const left = unit(minus(places[hips[1]], places[hips[0]])), back = cross(DOWN, left), goals = {};

  for (const [i, limb] of LIMBS.entries()) {
    const hand = i < 2, found = parts[limb][0].map(([pin, w]) => {
      const held = clamp(now, pin.at, endOf(pin)), share = smoother(Math.min(Math.abs(now - held) / r.CARRY, 1)), [a, b] = [there(now), there(held)];
      return [plus(pin[limb], [a[0] - b[0], 0, a[1] - b[1]], share), w];
    });
    let goal = places[hand ? arms[i][2] : body.legs[i - 2][2]];
    for (const [to, w] of found) {
      const flat = hand ? w : w * w;
      goal = plus(goal, minus(to, goal).map((v, axis) => v * (axis === 1 ? w : flat)));
      if (!hand) goal = plus(goal, DOWN, -4 * r.LIFT * w * (1 - w));
    }
    goals[limb] = { goal, weight: parts[limb][1], found };
  }

  // the trunk leans and the hips move by what arms lack, and over the foot that stands
  let [bend, shift] = leaned(places, goals, body, figure, r);
  FEET.forEach((limb, side) => (shift = plus(shift, level(minus(places[body.legs[1 - side][2]], places[0])), 0.5 * goals[limb].weight)));
  const shares = Object.fromEntries(spine.map((j, k) => [j, (k + 1) / spine.length])), under = (j, top) => j === top || (j > 0 && under(body.parents[j], top));
  for (let j = 0; j < turned.length; j++) {
    if (hips.some((hip) => under(j, hip))) turned[j] = steps[j];
    else turned[j] = multiply(turn(times(bend, (shares[j] ??= shares[body.parents[j]]))), turned[j]);
  }
  (places[0] = plus(places[0], shift)), kinematics(body, turned, places);

  // the head, the arms, the feet
  const head = neck.at(-1), ahead = rotate(turned[head], figure.facing);
  let aim = [0, 0, 0];
  for (const [pin, w] of parts.look[0]) aim = plus(aim, minus(looked(ahead, minus(pin.look, places[head]), r), aim), w);
  neck.slice(1).forEach((j, k) => {
    const q = turn(times(aim, (k + 1) / (neck.length - 1)));
    turned.forEach((_, i) => { if (i === j || (j === head && under(i, j))) turned[i] = multiply(q, turned[i]); });
  });
  HANDS.forEach((limb, side) => {
    if (!goals[limb].weight) return;
    const [a, b, c] = arms[side].map((j) => places[j]), out = times(left, side ? 1 : -1);
    let upper = minus(b, a), lower = minus(c, b);
    for (const [to, w] of goals[limb].found) {
      const pole = plus(plus(cross(left, unit(minus(to, a))), out, 0.4), plus(DOWN, back), 0.3), [elbow, hand] = twoBone(a, b, c, to, null, { soft: r.SOFT }, pole);
      upper = swung(upper, minus(elbow, a), minus(out, back), w), lower = swung(lower, minus(hand, elbow), minus(out, back), w);
    }
    const aims = [between(minus(b, a), upper), between(minus(c, b), lower)];
    turned.forEach((_, j) => { if (under(j, arms[side][0])) turned[j] = multiply(aims[Number(under(j, arms[side][1]))], turned[j]); });
  });
  plant(FEET.map((limb, side) => plus(before[body.legs[side][3]], minus(goals[limb].goal, before[body.legs[side][2]]))));
}

// the pins that poses miss and why, a line each; joints(frame): places of all joints
export function missedPins({ shot: { pins }, frames }, joints, body, { arms }, r) {
  return pins.flatMap((pin, k) => {
    const first = Math.max(round(pin.at * r.FPS) - 1, 0), last = round(endOf(pin) * r.FPS) - 1;
    if (last < first || last >= frames.length) return [`pins[${k}] is at ${Number(endOf(pin).toPrecision(6))} s, after the end of the motion`];
    return LIMBS.flatMap((limb, i) => {
      if (pin[limb] == null) return [];
      const chain = i < 2 ? arms[i] : body.legs[i - 2], start = i < 2 ? "shoulder" : "hip", goal = pin[limb];
      let off = 0;
      for (let f = first; f <= last; f++) off = Math.max(off, long(minus(joints(f)[chain[2]], goal)));
      if (off <= r.MISSED) return [];
      const top = joints(first)[chain[0]], side = Math.hypot(goal[0] - top[0], goal[2] - top[2]);
      return [`pins[${k}]: the ${limb.replace("_", " ")} is ${(100 * off).toFixed(0)} cm from its place, which is ${goal[1].toFixed(2)} m high and `
        + `${side.toFixed(2)} m beside the ${start} of the character at ${Number(pin.at.toPrecision(6))} s: it is out of reach`];
    });
  });
}
