// What is broken in a motion of the page: the functions of toolkit/evaluation/findings.py, on a level floor.
//
// gate: the constants of that module by name, its limits, units, others and least, roles {role: joint} and chest, of view/pages/live_page.py's
// pack. A finding: {kind, joint, start, end, value, limit, unit, excess, characters}.
import { Tree } from "./body.js";
import { round } from "./course.js";
import { cross } from "./pose.js";

const LIVE = { WATCHED: 600, SHOWN: 240, AGAIN: 120 }; // frames that are looked at, whose defects are shown, and between two looks
const SIDES = ["left", "right"];
const minus = (a, b) => a.map((v, i) => v - b[i]), dot = (a, b) => a.reduce((sum, v, i) => sum + v * b[i], 0), size = (a) => Math.hypot(...a);
const plus = (a, b, share = 1) => a.map((v, i) => v + share * b[i]), flat = ([x, , z]) => [x, z];
const half = (seconds, fps) => Math.max(1, round((seconds * fps) / 2));
const sum = (values) => values.reduce((total, v) => total + v, 0), least = (values) => values.reduce((a, b) => Math.min(a, b), Infinity);

function quantile(values, share) {
  const row = [...values].sort((a, b) => a - b), at = share * (row.length - 1), k = Math.floor(at);
  return row.length ? row[k] + (at - k) * ((row[k + 1] ?? row[k]) - row[k]) : NaN;
}

// values of windows at the windows' middles, NaN at the ends
function placed(values, frames) {
  const first = Math.floor((frames - values.length) / 2);
  return Array.from({ length: frames }, (_, f) => values[f - first] ?? NaN);
}

// velocity over so many seconds, centred; at the ends null
const moved = (path, fps, seconds) => {
  const k = half(seconds, fps);
  return path.map((_, f) => (f < k || f + k >= path.length ? null : minus(path[f + k], path[f - k]).map((v) => (v * fps) / (2 * k))));
};
const speed = (path, fps, seconds) => moved(path, fps, seconds).map((v) => (v ? size(v) : NaN));

function throughout(holds, seconds, fps) {
  const k = half(seconds, fps);
  return holds.map((_, f) => f >= k && f + k < holds.length && holds.slice(f - k, f + k + 1).every(Boolean));
}

const only = (values, frames) => values.map((v, f) => (frames[f] ? v : NaN));
const points = (a, b, { POINTS }) => Array.from({ length: POINTS - 1 }, (_, i) => plus(a, minus(b, a), (i + 1) / (POINTS - 1)));
const distance = (a, b) => Math.sqrt(least(a.map((p) => least(b.map((q) => (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 + (p[2] - q[2]) ** 2)))));

function differences(path, times, k = 1) {
  let rows = path;
  for (let i = 0; i < times; i++) rows = rows.slice(k).map((p, f) => minus(p, rows[f]));
  return rows;
}

function* feet(at, fps, gate) {
  const { LOW, FLAT, TOUCH, STANCE, BEHIND, STROLL, STILL, SLOW, REST, ALIKE, LIFTED } = gate;
  const { hips, left_toe: left, right_toe: right } = at;
  const floor = quantile(left.map((p, f) => Math.min(p[1], right[f][1])), 0.05), frames = hips.length;
  const body = moved(hips.map(flat), fps, TOUCH), travel = body.map((v) => (v ? size(v) : NaN)), lowest = [], strides = [];
  for (const side of SIDES) {
    const toe = at[`${side}_toe`], ankle = at[`${side}_foot`], low = toe.map((p) => p[1] - floor < LOW), heights = ankle.map((p) => p[1]);
    const stands = low.some(Boolean) ? quantile(heights.filter((_, f) => low[f]), 0.25) : least(heights);
    const whole = low.map((is, f) => is && heights[f] - stands < FLAT), velocity = moved(toe, fps, TOUCH);
    const behind = whole.map((is, f) => is && velocity[f]
      && dot(flat(velocity[f]), body[f]) / Math.max(travel[f], 0.05) < BEHIND * Math.max(travel[f], STROLL));
    const heel = speed(ankle, fps, TOUCH), slides = velocity.map((v, f) => (v ? Math.min(size(v), heel[f]) : NaN));
    for (const [kind, held] of [["slide", STANCE], ["short slide", TOUCH]]) yield [kind, `${side}_toe`, only(slides, throughout(behind, held, fps))];
    const still = whole.map((is, f) => is && velocity[f] && size(velocity[f]) < STILL);
    yield ["pivot", `${side}_foot`, only(speed(ankle.map(flat), fps, TOUCH), throughout(still, TOUCH, fps))];
    lowest.push(quantile(toe.filter((_, f) => velocity[f] && size(velocity[f]) < SLOW).map((p) => p[1]), 0.05));
    strides.push(velocity.map((v, f) => (v ? size(minus(flat(v), body[f])) : NaN)));
  }
  const window = 2 * Math.max(1, round((REST * fps) / 2)) + 1;
  const mean = (row, f) => sum(row.slice(f, f + window)) / window, most = strides[0].map((v, f) => Math.max(v, strides[1][f]));
  yield ["drift", "hips", placed(Array.from({ length: Math.max(frames - window + 1, 0) }, (_, f) => {
    const way = mean(travel, f);
    return mean(most, f) < ALIKE * way ? way : NaN;
  }), frames)];
  const uneven = Math.abs(lowest[0] - lowest[1]);
  yield ["floor", `${SIDES[Number(lowest[0] > lowest[1])]}_toe`, hips.map(() => (uneven < LIFTED ? uneven : NaN))];
}

function* pops(at, fps, { STEP }) {
  const k = Math.max(1, round(STEP * fps)), window = Math.max(3, round(0.2 * fps)), frames = at.hips.length;
  for (const [role, path] of Object.entries(at)) {
    if (/(hip|shoulder)$/.test(role)) continue;
    yield ["pop", role, placed(differences(path, 3, k).map((v) => size(v) * (fps / k) ** 3), frames)];
    const fourth = differences(path, 4).map((v) => size(v) / 16), steady = [];
    for (let f = 0; f + window <= fourth.length; f++) {
      const row = fourth.slice(f, f + window).sort((a, b) => a - b);
      steady.push(row[(window - 1) >> 1] * (Math.min(fps, 60) / 30) ** 2);
    }
    yield ["shake", role, placed(steady, frames)];
  }
  for (const side of SIDES) for (const [root, middle, end] of [["hip", "knee", "foot"], ["shoulder", "elbow", "hand"]]) {
    const flexion = at[`${side}_${middle}`].map((joint, f) => {
      const above = minus(joint, at[`${side}_${root}`][f]), below = minus(at[`${side}_${end}`][f], joint);
      return (Math.atan2(size(cross(above, below)), dot(above, below)) * 180) / Math.PI;
    });
    const turn = flexion.slice(2 * k).map((v, f) => Math.abs(v - 2 * flexion[f + k] + flexion[f]) * (fps / k) ** 2);
    yield ["bend", `${side}_${middle}`, placed(turn, frames)];
    yield ["fold", `${side}_${middle}`, flexion];
  }
}

// points of the trunk and the limbs in a frame
function shape(at, f, gate) {
  const of = (a, b) => points(at[a][f], at[b][f], gate), middle = times(plus(at.left_shoulder[f], at.right_shoulder[f]), 0.5);
  const bones = [["elbow", "hand"], ["hip", "knee"], ["knee", "foot"]];
  return { trunk: [...of("hips", "chest"), ...points(at.chest[f], middle, gate)],
           limbs: Object.fromEntries(SIDES.flatMap((side) => bones.map(([a, b]) => [`${side}_${b}`, of(`${side}_${a}`, `${side}_${b}`)]))) };
}
const times = (v, s) => v.map((x) => s * x);

// distances within a body in a frame: [kind, joints, metres]
function bodies(at, f, { trunk, limbs }) {
  const found = [], across = unit(minus(at.left_hip[f], at.right_hip[f])), ahead = cross(across, [0, 1, 0]);
  for (const side of SIDES) {
    const arm = limbs[`${side}_hand`];
    found.push(["body", `${side}_hand and trunk`, distance(arm, trunk)]);
    found.push(["body", `${side}_hand and thigh`, Math.min(distance(arm, limbs.left_knee), distance(arm, limbs.right_knee))]);
  }
  found.push(["body", "shins", distance(limbs.left_foot, limbs.right_foot)]);
  for (const side of SIDES) {
    const hip = at[`${side}_hip`][f], leg = unit(minus(at[`${side}_foot`][f], hip)), off = minus(at[`${side}_knee`][f], hip);
    found.push(["knee", `${side}_knee`, -dot(plus(off, leg, -dot(off, leg)), ahead)]);
  }
  return found;
}
const unit = (v) => times(v, 1 / Math.max(size(v), 1e-12));

// moments beyond the limit of each frame; those that are near each other are one
function moments(kind, joint, values, limits, fps, gate, characters) {
  const smallest = gate.least.includes(kind), worse = values.map((v, f) => (smallest ? limits[f] - v : v - limits[f])), found = [];
  worse.forEach((by, f) => {
    if (!(by > 0)) return;
    const last = found[found.length - 1];
    if (last && f - last[last.length - 1] <= gate.JOIN * fps) last.push(f);
    else found.push([f]);
  });
  return found.map((some) => {
    const worst = some.reduce((a, b) => (worse[b] > worse[a] ? b : a)), value = values[worst], limit = limits[worst];
    return { kind, joint, start: some[0] / fps, end: (some[some.length - 1] + 1) / fps, value, limit, unit: gate.units[kind], characters,
             excess: smallest ? limit / Math.max(value, 1e-6) : value / limit };
  });
}

function between(a, b, one, other, fps, gate, apart) {
  const frames = Math.min(one.at.hips.length, other.at.hips.length), limits = (v) => Array(frames).fill(v), who = `of ${a} and ${b}`;
  const gap = one.at.hips.slice(0, frames).map((p, f) => size(minus(flat(p), flat(other.at.hips[f])))), all = ({ shape }, f) => Object.values(shape[f].limbs).flat();
  const found = apart === undefined ? [] : moments("apart", `hips ${who}`, gap, limits(apart), fps, gate, [a, b]);
  const part = { trunk: (body, f) => body.shape[f].trunk, limb: all };
  const pairs = [["trunk", "trunk", one, other], ["limb", "trunk", one, other], ["limb", "trunk", other, one], ["limb", "limb", one, other]];
  for (const [kind, their, mine, theirs] of pairs) {
    const near = gap.map((far, f) => (far > 2 ? NaN : distance(part[kind](mine, f), part[their](theirs, f)))); // metres: nobody's arms are so long
    found.push(...moments("body", `${kind} and ${their} ${who}`, near, limits(gate.others[`${kind} ${their}`]), fps, gate, [a, b]));
  }
  return found;
}

// Watches a motion as it comes: what is found in its last seconds, a few milliseconds of work at a time. Earlier frames show the floor.
export function watch(skeleton, gate) {
  let rows = [], fresh = 0, next = null, judging = null, seen = 0;
  const { WATCHED, SHOWN, AGAIN } = LIVE;
  return {
    // a frame by its number; after a gap all begins again
    take(number, root, rotations) {
      if (number !== next) [rows, fresh, judging] = [[], 0, null];
      next = number + 1;
      rows.push({ root, rotations });
      if (rows.length > WATCHED) rows.shift();
      fresh += 1;
    },
    // the findings once a look has ended, their times from now on backwards; else null
    look(until, fps) {
      if (!judging && fresh >= AGAIN) {
        const now = [...rows];
        [fresh, seen, judging] = [0, now.length, defects([{ count: now.length, pose: (f) => now[f] }], skeleton, fps, gate)];
      }
      while (judging && performance.now() < until) {
        const { done, value } = judging.next();
        if (!done) continue;
        judging = null;
        const now = seen / fps, near = value.filter(({ end }) => (now - end) * fps < SHOWN);
        return near.map((one) => ({ ...one, start: one.start - now, end: one.end - now }));
      }
      return null;
    },
  };
}

// Looks for defects a frame or a step after the other, so that a page can go on: for (const _ of ...). Returns the findings, in order.
export function* defects(motions, skeleton, fps, gate, apart) {
  const tree = new Tree(skeleton), roles = { ...gate.roles, chest: gate.chest }, found = [], shown = [];
  for (const [number, motion] of motions.entries()) {
    const at = Object.fromEntries(Object.keys(roles).map((role) => [role, []])), shapes = [], inside = [];
    for (let f = 0; f < motion.count; f++, yield) {
      const { root, rotations } = motion.pose(f);
      tree.pose(root, rotations);
      for (const [role, j] of Object.entries(roles)) at[role].push([...tree.places.subarray(3 * j, 3 * j + 3)]);
      shapes.push(shape(at, f, gate));
      inside.push(bodies(at, f, shapes[f]));
    }
    if (!motion.count) continue;
    const body = { at, shape: shapes }, pace = speed(at.hips.map(flat), fps, 0.5), { chest, ...joints } = at;
    shown.push([number, body]);
    const columns = inside[0].map(([kind, joint], k) => [kind, joint, inside.map((row) => row[k][2])]);
    for (const measured of [feet(joints, fps, gate), pops(joints, fps, gate), columns])
      for (const [kind, joint, values] of measured) {
        const [walking, running] = gate.limits[kind][joint.replace(/^(left|right)_/, "")];
        found.push(...moments(kind, joint, values, pace.map((v) => (v > gate.RUNNING ? running : walking)), fps, gate, [number]));
        yield;
      }
  }
  for (const [k, [b, other]] of shown.entries()) for (const [a, one] of shown.slice(0, k)) {
    found.push(...between(a, b, one, other, fps, gate, apart));
    yield;
  }
  return found.sort((one, other) => one.start - other.start);
}

const digits = (v) => (v >= 100 ? String(Math.round(v)) : String(Number(v.toPrecision(3))));

// a finding in a line; names: of the characters, if there are several
export const told = ({ kind, joint, start, end, value, limit, unit, characters: [who, other] }, gate, names = []) =>
  `${kind}: ${names.length > 1 && other === undefined ? `${names[who]}, ` : ""}${joint.replaceAll("_", " ")}, ${start.toFixed(2)} to ${end.toFixed(2)} s, ${digits(value)} ${gate.least.includes(kind) ? "<" : ">"} ${digits(limit)} ${unit}`;

// kinds and joints alone
export function brief(found) {
  const joints = new Map();
  for (const { kind, joint } of found) joints.set(kind, (joints.get(kind) ?? new Set()).add(joint.replaceAll("_", " ")));
  return [...joints].map(([kind, where]) => `${kind}: ${[...where].join(", ")}`).join("; ");
}

// all of them in a line: how many of each kind, and the worst one
export function summary(found, gate, names) {
  if (!found.length) return "No defects found.";
  const counts = new Map();
  for (const { kind } of found) counts.set(kind, (counts.get(kind) ?? 0) + 1);
  const listed = [...counts].sort(([, a], [, b]) => b - a).map(([kind, count]) => `${count} × ${kind}`).join(", ");
  return `Defects: ${listed}; the worst: ${told(found.reduce((a, b) => (b.excess > a.excess ? b : a)), gate, names)}`;
}
