// Changes of a whole shot: its mirror image, its way back, a part of it, two in a row. Each gives a new shot, with fields as in
// shot.js. course: the plan of the shot (course.js).
import { keyed } from "./course.js";
import { LIMBS } from "./pins.js";
import { blendAt, speedOf } from "./shot.js";

const BACK = { in: "out", out: "in" }, CHANGE = 1, SHORT = 0.01; // easings read backwards; seconds; metres
const rounded = (v) => Math.round(v * 1000) / 1000, moved = (time, by) => time && rounded(Math.max(time + by, 0));
const endOf = ({ end, distance, rules: { FPS } }) => end ?? (distance.length - 1) / FPS;
const AT = {
  styles: (keys, time) => ({ blend: blendAt(keys, time) }),
  speeds: (keys, time) => ({ speed: keyed({ times: keys.map((k) => k.time), easings: keys.map((k) => k.easing), values: keys.map((k) => k.speed) }, time) }),
};

// applies a map of places (x, z) and one of directions to all that a shot has on the floor
function placed(shot, place, turn) {
  const at = (p) => p && place(p).map(rounded), to = (p) => p && turn(p).map((v) => Math.round(v * 1e6) / 1e6);
  const high = (p) => p && (([x, z]) => [x, p[1], z])(at([p[0], p[2]]));
  const path = shot.path.map((p) => (([x, z]) => ({ ...p, x, z, facing: to(p.facing) }))(at([p.x, p.z])));
  const pins = shot.pins.map((pin) => ({ ...pin, ...Object.fromEntries([...LIMBS, "look"].map((part) => [part, high(pin[part])])) }));
  return { ...shot, path, pins, facing: to(shot.facing), look_at: at(shot.look_at) };
}

// left and right of the first way change places
export function mirrored(shot) {
  if (shot.pins.some((pin) => pin.pose)) throw new Error("a shot with a pinned pose cannot be mirrored");
  const [{ x: ox, z: oz }, b] = shot.path, size = Math.hypot(b.x - ox, b.z - oz), ux = (b.x - ox) / size, uz = (b.z - oz) / size;
  const turn = ([x, z]) => [2 * (ux * x + uz * z) * ux - x, 2 * (ux * x + uz * z) * uz - z];
  const made = placed(shot, ([x, z]) => turn([x - ox, z - oz]).map((v, i) => v + [ox, oz][i]), turn);
  const other = (part) => (part.startsWith("left") ? part.replace("left", "right") : part.replace("right", "left"));
  return { ...made, pins: made.pins.map((pin) => ({ ...pin, ...Object.fromEntries(LIMBS.map((part) => [other(part), pin[part]])) })) };
}

// the keys between two times, which count from the first one
function partOf(keys, list, from, to) {
  if (!keys.length) return [];
  const before = keys.findLast((key) => key.time <= from) ?? keys[0], made = [{ ...before, ...AT[list](keys, from), time: from }];
  made.push(...keys.filter((key) => key.time > from && key.time < to));
  if (keys.at(-1).time >= to) made.push({ ...keys.at(-1), ...AT[list](keys, to), time: to });
  return made.map((key) => ({ ...key, time: moved(key.time, -from) }));
}

// the part between two times
export function trimmed(shot, course, from, to = Infinity) {
  const { curve, distance, rules: { FPS } } = course, frame = (time) => Math.min(Math.round(time * FPS), distance.length - 1);
  const first = distance[frame(from)], last = distance[frame(to)];
  if (last - first < SHORT) throw new Error("nothing is walked in this part");
  const cut = (at) => (([x, z]) => ({ x: rounded(x), z: rounded(z), time: null, facing: null }))(curve.point(at));
  const near = (k, at) => Math.abs(curve.knots[k] - at) < SHORT, end = shot.path.length - 1;
  const inner = shot.path.filter((_, k) => curve.knots[k] > first + SHORT && curve.knots[k] < last - SHORT);
  const path = [near(0, first) ? shot.path[0] : cut(first), ...inner, near(end, last) ? shot.path[end] : cut(last)];
  const lies = ({ time, distance: at }) => (time === null ? at >= first && at < last : time >= from && time < to);
  return {
    ...shot, path: path.map((p, k) => ({ ...p, time: k ? moved(p.time, -from) : null })),
    styles: partOf(shot.styles, "styles", from, to), speeds: partOf(shot.speeds, "speeds", from, to),
    holds: shot.holds.filter(lies).map((hold) => ({ ...hold, time: moved(hold.time, -from), distance: moved(hold.distance, -first) })),
    pins: shot.pins.filter(({ at }) => at >= from && at < to).map((pin) => ({ ...pin, at: moved(pin.at, -from), to: moved(pin.to && Math.min(pin.to, to), -from) })),
    duration: shot.duration && moved(Math.min(shot.duration, to), -from),
  };
}

// the same path from its end to its start, with all times counted from the end
export function reversed(shot, course) {
  const end = rounded(endOf(course)), { length } = course.curve, back = (time) => time && rounded(Math.max(end - time, 0));
  const keys = (list) => partOf(shot[list], list, 0, end).map((key, k, all) =>
    ({ ...key, time: rounded(end - key.time), easing: k ? BACK[all[k - 1].easing] ?? all[k - 1].easing : key.easing })).reverse();
  const arrives = shot.path.at(-1).time === null ? null : end; // where it started, if it had a time for its end
  const path = shot.path.map((p, k) => ({ ...p, time: k === shot.path.length - 1 ? null : k ? back(p.time) : arrives })).reverse();
  const holds = shot.holds.map((hold) =>
    ({ ...hold, time: hold.time === null ? null : rounded(Math.max(end - hold.time - hold.seconds, 0)), distance: hold.distance === null ? null : rounded(Math.max(length - hold.distance, 0)) }));
  const pins = shot.pins.filter(({ at }) => at < end).map((pin) =>
    (pin.to === null ? { ...pin, at: rounded(end - pin.at) } : { ...pin, at: rounded(Math.max(end - pin.to, 0)), to: rounded(end - pin.at) }));
  return { ...shot, path, holds, pins, styles: keys("styles"), speeds: keys("speeds") };
}

// a shot, and after it another one, turned and moved to where and in which direction the first one ends
export function joined(shot, course, next, after, desk) {
  const { curve } = course, end = rounded(endOf(course)), [tx, tz] = curve.tangent(curve.length), [sx, sz] = after.curve.tangent(0);
  const cos = sx * tx + sz * tz, sin = sz * tx - sx * tz, { x: ox, z: oz } = next.path[0], { x, z } = shot.path.at(-1);
  const turn = ([a, b]) => [cos * a + sin * b, cos * b - sin * a];
  const then = placed(next, ([a, b]) => turn([a - ox, b - oz]).map((v, i) => v + [x, z][i]), turn);
  const later = (keys) => keys.map((key) => ({ ...key, time: rounded(key.time + end) }));
  const chain = (list, a, b) => {
    const old = partOf(a, list, 0, end).filter((key) => key.time < end), hold = end - CHANGE;
    if (hold > old.at(-1).time) old.push({ ...a.at(-1), ...AT[list](a, hold), time: rounded(hold) });
    return [...old, ...later(partOf(b, list, 0, Infinity))];
  };
  const speeds = ({ speeds: own, styles }) => (own.length ? own : styles.map((key) => ({ time: key.time, speed: speedOf(key.blend, desk), easing: key.easing })));
  return {
    ...shot, path: [...shot.path, ...then.path.slice(1).map((p) => ({ ...p, time: p.time && rounded(p.time + end) }))],
    styles: chain("styles", shot.styles, next.styles), speeds: shot.speeds.length + next.speeds.length ? chain("speeds", speeds(shot), speeds(next)) : [],
    holds: [...shot.holds, ...next.holds.map((hold) => ({ ...hold, time: hold.time === null ? null : rounded(hold.time + end), distance: hold.distance === null ? null : rounded(hold.distance + curve.length) }))],
    pins: [...shot.pins, ...then.pins.map((pin) => ({ ...pin, at: rounded(pin.at + end), to: pin.to && rounded(pin.to + end) }))], duration: null,
  };
}
