// Characters of a scene that keep apart and off its walls, on their ways together (Scene of shots/scene.py, shots/apart.py).
//
// Together(takes, {apart, walls}, desk) steps them; rules: the constants of both modules by name. Pairs are [x, z].
import { advance } from "./character.js";
import { nearest, round } from "./course.js";
import { radiusOf } from "./shot.js";

const dot = (a, b) => a[0] * b[0] + a[1] * b[1], minus = (a, b) => [a[0] - b[0], a[1] - b[1]], times = (s, v) => [s * v[0], s * v[1]];
const size = (v) => Math.sqrt(dot(v, v)), limited = (v, most) => times(Math.min(most / Math.max(size(v), 1e-9), 1), v);

// {normal, change}: a half-plane of relative velocities that avoids a place
function halfPlane(to, relative, apart, { AT_ONCE, HORIZON }) {
  const distance = Math.max(size(to), 1e-6), close = distance < apart, within = close ? AT_ONCE : HORIZON;
  const off = minus(relative, times(1 / within, to)), length = Math.max(size(off), 1e-9), [x, z] = to;
  if (close || dot(off, to) <= -apart * length) return { normal: times(1 / length, off), change: apart / within - length };
  const leg = Math.sqrt(Math.max(distance ** 2 - apart ** 2, 0)), side = x * off[1] - z * off[0] >= 0 ? 1 : -1;
  const along = times(1 / distance ** 2, [x * leg - side * z * apart, side * x * apart + z * leg]), normal = [-side * along[1], side * along[0]];
  return { normal, change: -dot(relative, normal) };
}

// the velocity that `a` wants, to the right where a neighbour in front wants to come nearer (_sidestepped of shots/apart.py)
function sidestepped(a, near, places, wanted, { radii, rules: { ASIDE, CLOSE } }) {
  const [x, z] = wanted[a], comes = near.some((b) => {
    const to = minus(places[b], places[a]);
    return size(to) < radii[a] + radii[b] + CLOSE && dot(to, wanted[a]) > 0 && dot(to, wanted[b]) < 0;
  });
  const [c, s] = comes ? [Math.cos(ASIDE), Math.sin(ASIDE)] : [1, 0];
  return [c * x - s * z, s * x + c * z];
}

// the velocity of character `a` in all half-planes [normal, least, soft] that is nearest to the one it wants
function safe(a, places, moving, wanted, scene) {
  const { radii, walls, rules } = scene;
  const { NEIGHBOURS, SIGHT, SWEEPS, SOFT, MARGIN, BRAKE, ROOM } = rules, here = places[a];
  const near = places.map((place, b) => [size(minus(place, here)), b]).filter(([far, b]) => b !== a && far < SIGHT);
  const nearest = near.sort(([one], [other]) => one - other).slice(0, NEIGHBOURS).map(([, b]) => b);
  let free = true;
  const planes = nearest.map((b) => {
    const { normal, change } = halfPlane(minus(places[b], here), minus(moving[a], moving[b]), radii[a] + radii[b], rules);
    return [normal, dot(normal, moving[a]) + change / 2, SOFT];
  });
  for (const [start, end] of walls) {
    const way = minus(end, start), share = Math.min(Math.max(dot(minus(here, start), way) / dot(way, way), 0), 1);
    const to = minus(start, minus(here, times(share, way))), away = Math.max(size(to), 1e-6);
    free &&= away > ROOM;
    planes.push([times(-1 / away, to), (MARGIN - away) / BRAKE, 0]);
  }
  const velocity = free ? sidestepped(a, nearest, places, wanted, scene) : [...wanted[a]], force = planes.map(() => 0);
  for (let sweep = 0; sweep < SWEEPS; sweep++)
    planes.forEach(([normal, least, soft], k) => {
      const more = Math.max((least - dot(normal, velocity) - soft * force[k]) / (1 + soft), -force[k]);
      force[k] += more;
      velocity[0] += more * normal[0], velocity[1] += more * normal[1];
    });
  return velocity;
}

// places near the given ones that keep their distances (parted of shots/apart.py)
function parted(places, radii, walls, { PASSES, SPARE, MARGIN }) {
  const moved = places.map((place) => [...place]), least = (a, b) => radii[a] + radii[b] + SPARE;
  for (let pass = 0; pass < PASSES; pass++) {
    for (const [start, end] of walls) {
      const way = minus(end, start);
      moved.forEach((here, k) => {
        const share = Math.min(Math.max(dot(minus(here, start), way) / dot(way, way), 0), 1);
        const to = minus(minus(start, times(-share, way)), here), away = Math.max(size(to), 1e-6);
        moved[k] = minus(here, times(Math.max(MARGIN - away, 0) / away, to));
      });
    }
    const close = moved.flatMap((there, b) => moved.slice(0, b).flatMap((here, a) =>
      (size(minus(there, here)) < least(a, b) - SPARE / 2 ? [[a, b]] : [])));
    if (!close.length) break;
    for (const [a, b] of close.sort(([a, b], [c, d]) => a - c || b - d)) {
      const to = minus(moved[b], moved[a]), far = Math.max(size(to), 1e-6), push = times(Math.max(least(a, b) - far, 0) / far / 2, to);
      moved[a] = minus(moved[a], push), moved[b] = minus(moved[b], times(-1, push));
    }
  }
  return moved;
}

// {velocity, held}: what a character wants who may have left the path, and whether others hold it up (_aimed of shots/scene.py)
function aimed({ course: { curve, distance, speed, rules: { FPS, LEAD } } }, clock, place, asked, { WAIT, AHEAD }) {
  const here = nearest(curve, place, distance[clock]), held = distance[clock] - here > WAIT;
  if (speed[Math.min(clock + round(LEAD * FPS), speed.length - 1)] === 0) return { velocity: asked, held };
  const to = minus(curve.point(here + AHEAD), place);
  return { velocity: times(Math.max(dot(to, asked), 0) / Math.max(dot(to, to), 1e-12), to), held };
}

export class Together {
  constructor(takes, { walls = [], ...more }, { data: { apart: rules }, rules: { FPS, LONGEST } }) {
    const most = Math.max(...takes.map((take) => take.count));
    Object.assign(this, { takes, walls: walls.map(({ start, end }) => [start, end]), rules, frames: 0 });
    this.radii = takes.map(({ shot }) => radiusOf(shot, more));
    this.most = Math.min(rules.WAITS * most, round(LONGEST * FPS));
    for (const take of takes) Object.assign(take, { count: most, apart: [], together: true }); // who keeps apart leaves the path
  }

  // the next frame of all; whether there is one
  step() {
    const { takes, rules } = this, at = ({ clock, course: { distance } }) => Math.min(clock, distance.length - 1);
    if (this.frames >= this.most || takes.every((take) => take.clock >= take.course.distance.length - 1)) return false;
    const asked = takes.map((take) => take.ask()), places = takes.map((take) => take.place);
    const moving = takes.map(({ character: { state } }) => [...state.velocity]);
    const aims = takes.map((take, k) => aimed(take, at(take), places[k], asked[k].velocity, rules)), held = aims.map((aim) => aim.held);
    const most = takes.map((take) => rules.FASTER * Math.max(take.course.speed[at(take)], rules.SLOWEST));
    const wanted = aims.map(({ velocity }, k) => limited(velocity, most[k]));
    const commands = asked.map(({ facing }, k) => ({ facing, velocity: limited(safe(k, places, moving, wanted, this), most[k]) }));
    takes.forEach((take, k) => (take.clock += held[k] ? 0 : 1));
    advance(takes.map((take) => take.character), commands, takes.map((take) => take.style));
    const now = takes.map(({ character: { state: { history } } }) => [...history.slice(-4, -2)]);
    parted(now, this.radii, this.walls, rules).forEach((place, k) => {
      const { history, future } = takes[k].character.state, shift = minus(place, now[k]), here = history.length - 4;
      for (const i of [0, 1]) {
        history[here + i] += shift[i];
        for (let s = i; s < future.length; s += 4) future[s] += shift[i];
      }
    });
    for (const take of takes) take.note();
    this.frames += 1;
    return true;
  }
}
