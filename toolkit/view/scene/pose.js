// From a character's state to a pose that can be drawn, feet planted and arms turned (ik.py; compiled/ik.py, whose functions these are).
//
// body: runtime/rules.py's Body: parents [J'], offsets [J'][3], features [J'], own [J'], ends, legs [2][4], arms [A][2]
import { footLock, three, unit } from "./frame.js";

export const plus = (a, b, share = 1) => [a[0] + share * b[0], a[1] + share * b[1], a[2] + share * b[2]];
export const minus = (a, b) => plus(a, b, -1);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

// a unit vector at right angles to a unit vector: across the axis that is farthest from it
export function across(a) {
  const [x, y, z] = a.map(Math.abs), axis = x <= y && x <= z ? 0 : y <= z ? 1 : 2;
  return unit(cross(a, [0, 1, 2].map((i) => Number(i === axis))));
}

export const multiply = (a, b) => [
  a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
  a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
  a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
  a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
];

export function rotate([w, ...u], v) {
  const t = cross(u, v).map((x) => 2 * x);
  return plus(plus(v, t, w), cross(u, t));
}

// the shortest rotation from the direction of a to that of b
export function between(a, b) {
  const from = unit(a), to = unit(b), w = 1 + dot(from, to);
  return w < 1e-6 ? [0, ...across(from)] : unit([w, ...cross(from, to)]);
}

function fromForwardUp(forward, up) {
  const c = unit(forward), a = unit(cross(up, c)), b = cross(c, a);
  const diagonal = [1 + a[0] + b[1] + c[2], 1 + a[0] - b[1] - c[2], 1 - a[0] + b[1] - c[2], 1 - a[0] - b[1] + c[2]];
  const x = b[2] - c[1], y = c[0] - a[2], z = a[1] - b[0], xy = b[0] + a[1], xz = c[0] + a[2], yz = c[1] + b[2];
  const best = diagonal.indexOf(Math.max(...diagonal));
  const q = unit([[diagonal[0], x, y, z], [x, diagonal[1], xy, xz], [y, xy, diagonal[2], yz], [z, xz, yz, diagonal[3]]][best]);
  return q[0] < 0 ? q.map((v) => -v) : q;
}

// knee and ankle of a leg whose ankle should be at the target, soft near full stretch; soft, straight: see rules.py's Body
export function twoBone(a, b, c, target, left, { soft, straight }, pole = null) {
  const reach = minus(target, a), upper = Math.hypot(...minus(b, a)), lower = Math.hypot(...minus(c, b));
  const wanted = Math.hypot(...reach), full = upper + lower, margin = Math.max(soft * full, 1e-9);
  const line = unit(wanted > 1e-9 ? reach : plus(minus(c, a), [1, 1, 1], 1e-9)), over = wanted - (full - margin);
  const distance = Math.max(over > 0 ? full - margin * Math.exp(-over / margin) : wanted, Math.abs(upper - lower) + 1e-6 * full);
  const side = unit(pole ?? rotate(between(minus(c, a), line), minus(b, a)));
  let off = plus(side, line, -dot(side, line));
  if (left) { // a knee that bends backwards is mirrored to the front; that of a straight leg goes there
    const front = cross(line, unit(left));
    off = plus(off, front, -2 * Math.min(dot(off, front), 0));
    off = plus(off, front, Math.max(straight - Math.hypot(...off), 0));
  }
  const out = Math.hypot(...off) > 1e-5 ? unit(off) : across(line);
  const along = (upper ** 2 - lower ** 2 + distance ** 2) / (2 * distance);
  const height = Math.sqrt(Math.max(upper ** 2 - along ** 2, 0));
  return [plus(plus(a, line, along), out, height), plus(a, line, distance)];
}

// places of all points but the root, of world rotations
export function kinematics(body, turned, places) {
  for (let j = 1; j < places.length; j++) {
    const parent = body.parents[j];
    places[j] = plus(places[parent], rotate(turned[parent], body.offsets[j]));
  }
}

function turnArms(body, turned, places, wanted) {
  kinematics(body, turned, places);
  for (const [joint, child] of body.arms) {
    const bone = rotate(turned[joint], body.offsets[child]), aim = between(bone, minus(wanted(child), places[joint]));
    turned[joint] = multiply(aim, turned[joint]);
    places[child] = plus(places[joint], rotate(aim, bone));
  }
}

function plantFeet(body, turned, places, toes) {
  kinematics(body, turned, places);
  const left = minus(...[1, 0].map((side) => places[body.legs[side][0]]));
  body.legs.forEach(([hip, knee, foot, toe], side) => {
    const [a, b, c] = [hip, knee, foot].map((joint) => places[joint]);
    const [middle, end] = twoBone(a, b, c, plus(minus(three(toes, 3 * side), places[toe]), c), left, body);
    turned[hip] = multiply(between(minus(b, a), minus(middle, a)), turned[hip]);
    turned[knee] = multiply(between(minus(c, b), minus(end, middle)), turned[knee]);
  });
}

// How far the hips sink, and how fast (ik.py's sink), for what the legs lack.
function sink([before, speed], lack, { fps, let_go, fall }) {
  const need = Math.min(lack, before + fall / fps);
  const fade = Math.exp(-let_go / fps), push = speed + let_go * (before - need), above = fade * (before - need + push / fps);
  return above > 0 ? [need + above, fade * (speed - let_go * push / fps)] : [need, (need - before) * fps];
}

// world rotation of a predicted foot
function footOf({ history, joints }, side, rules) {
  const [s, c] = unit(history.slice(-2)), at = rules.width * rules.legs[side][1];
  const world = ([x, y, z]) => [c * x + s * z, y, c * z - s * x];
  return fromForwardUp(...["forward", "up"].map((channel) => world(three(joints, at + rules[channel]))));
}

// angle about the vertical that keeps a foot as it was (ik.py's hold_feet)
function holdFoot(before, next, side, { let_go, fps, swivel }, [[w0, ...v], foot]) {
  const [w, , y] = multiply(foot, [w0, ...v.map((x) => -x)]), old = before.swivel[side], free = Math.exp(-let_go / fps) * old;
  const held = old - 2 * Math.atan2(w > 0 ? y : -y, Math.abs(w)), share = Math.min(2 * next.contacts[side], 1);
  return free + share * (Math.min(Math.max(held, -swivel), swivel) - free);
}

const yaw = (angle) => [Math.cos(angle / 2), 0, Math.sin(angle / 2), 0];

// ik.py's uncross: an ankle in the air passes beside the other
function uncross(legs, left, contacts, rules) {
  const [x, , z] = unit([left[0], 0, left[2]]), [dx, , dz] = minus(legs[1].target, legs[0].target);
  const aside = dx * x + dz * z, along = Math.abs(dz * x - dx * z);
  legs.forEach((leg, side) => {
    const need = rules.aside * leg.length - rules.crossing * Math.max(along - rules.passed * leg.length, 0);
    const push = (side ? 1 : -1) * Math.min(Math.max(need - aside, 0), rules.push) * (1 - Math.min(2 * contacts[side], 1));
    leg.target = plus(leg.target, [x, 0, z], push);
  });
}

// Foot lock and foot IK (runtime/frame.py's planted): sets toes, drift, drop and swivel, and knees, feet and toes of the pose.
export function plant(next, before, body, rules) {
  const { history, joints, toes, contacts, drop, swivel } = next;
  footLock(before, next, body.legs.map(([, , ankle, toe], side) => {
    const feet = [before, next].map((state) => footOf(state, side, rules)), sole = toe === ankle ? [0, 0, 0] : body.offsets[toe]; // without toes, the foot has both roles
    swivel[side] = holdFoot(before, next, side, rules, feet);
    return rotate(feet[1], sole)[1] - sole[1];
  }), rules);
  const read = (joint, channel) => three(joints, rules.width * joint + rules[channel]);
  const [x, z, sin, cos] = history.subarray(history.length - 4), [s, c] = unit([sin, cos]), places = [read(0, "position")];
  for (const j of body.chains) {
    const above = body.parents[j], joint = body.features[above];
    places[j] = plus(places[above], rotate(fromForwardUp(read(joint, "forward"), read(joint, "up")), body.offsets[j]));
  }
  let need = 0;
  const legs = body.legs.map(([hip, knee, foot, toe], side) => {
    const [tx, ty, tz] = three(toes, 3 * side), [a, b, ankle] = [hip, knee, foot].map((joint) => places[joint]);
    const sole = rotate(yaw(swivel[side]), minus(places[toe], ankle));
    const length = Math.hypot(...minus(b, a)) + Math.hypot(...minus(ankle, b));
    return { a, b, ankle, sole, length, target: minus([c * (tx - x) - s * (tz - z), ty, c * (tz - z) + s * (tx - x)], sole) };
  });
  const left = minus(legs[1].a, legs[0].a);
  uncross(legs, left, contacts, rules);
  legs.forEach(({ a, length: full, target }, side) => {
    const [dx, dy, dz] = minus(a, target);
    const lack = dy - Math.sqrt(Math.max(((1 - rules.soft) * full) ** 2 - dx * dx - dz * dz, (full / 2) ** 2));
    const room = rules.room * full, gentle = lack > room ? lack : Math.max(lack + room, 0) ** 2 / (4 * room);
    need = Math.max(need, Math.min(gentle, rules.deepest * full) * Math.min(2 * contacts[side], 1));
  });
  drop.set(sink(before.drop, need, rules));
  legs.forEach(({ a, b, ankle, sole, target }, side) => { // the drawn leg is never quite straight in the air, and its toe is where it gets
    const [, knee, foot, toe] = body.legs[side], held = Math.min(2 * contacts[side], 1), lower = (v) => [v[0], v[1] - drop[0], v[2]];
    let goal = target;
    if (held < 1) {
      [, goal] = twoBone(lower(a), lower(b), lower(ankle), target, left, { straight: body.straight, soft: rules.swing + held * (rules.soft - rules.swing) });
      const [gx, gy, gz] = plus(goal, sole);
      toes.set([c * gx + s * gz + x, gy, c * gz - s * gx + z], 3 * side);
    }
    const [middle, end] = twoBone(a, b, ankle, goal, left, body);
    [[knee, middle], [foot, end], [toe, plus(end, sole)]].forEach(([point, place]) =>
      joints.set(place, rules.width * body.own[point] + rules.position));
  });
}

// Fills local rotations [J' * 4] and the root's position [3]; feet, arms: whether their IK acts; pin: see pins.js.
export function pose({ history, joints, toes, drop, swivel }, body, rules, { feet, arms }, rotations, root, pin = null) {
  const [x, z, sin, cos] = history.subarray(history.length - 4), [s, c] = unit([sin, cos]);
  const world = (joint, channel) => {
    const at = rules.width * joint + rules[channel];
    return [c * joints[at] + s * joints[at + 2], joints[at + 1], c * joints[at + 2] - s * joints[at]];
  };
  const ends = () => { for (const j of body.ends) turned[j] = turned[body.parents[j]]; };
  const turned = body.features.map((joint) => fromForwardUp(world(joint, "forward"), world(joint, "up")));
  if (feet) // feet and toes
    body.legs.forEach((leg, side) => new Set(leg.slice(2)).forEach((j) => (turned[j] = multiply(yaw(swivel[side]), turned[j]))));
  const places = body.parents.map(() => plus([x, 0, z], world(0, "position")));
  if (arms) {
    turnArms(body, turned, places, (point) => plus([x, 0, z], world(body.own[point], "position")));
    ends();
  }
  if (feet) {
    places[0][1] -= drop[0];
    plantFeet(body, turned, places, toes);
    ends();
  }
  pin?.(turned, places, (goals) => {
    plantFeet(body, turned, places, goals.flat());
    ends();
  });
  root.set(places[0]);
  rotations.set(turned[0]);
  for (let j = 1; j < turned.length; j++) {
    const [w, ...v] = turned[body.parents[j]];
    rotations.set(multiply([w, ...v.map((value) => -value)], turned[j]), 4 * j);
  }
}
