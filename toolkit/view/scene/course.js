// The rules of a shot: its curve, its timing and the feedback that keeps a character on both (shots/following.py, whose functions
// and classes these are; shots/feasibility.py).
//
// rules: the constants of following.py and feasibility.py by name. Metres, seconds, pairs [x, z] on the floor; a table has one row
// per frame. Points and directions are pairs, as in Python. Infinity stands for Python's None in "never" and "no limit".
export const EASINGS = {
  linear: (t) => t,
  smooth: (t) => t * t * (3 - 2 * t),
  smoother: (t) => t * t * t * (t * (6 * t - 15) + 10),
  in: (t) => t * t,
  out: (t) => t * (2 - t),
  jump: (t) => Number(t >= 1),
};

// Python's round: half to even
export function round(value) {
  const whole = Math.floor(value), rest = value - whole;
  return rest < 0.5 || (rest === 0.5 && whole % 2 === 0) ? whole : whole + 1;
}

const clamp = (v, low, high) => Math.min(Math.max(v, low), high);
const far = (x, z) => Math.sqrt(x * x + z * z);
const pairs = (list) => list.slice(1).map((b, k) => [list[k], b]);
const wrapped = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));

// the number of entries of a rising list that are not above a value
export function bisectRight(list, value) {
  let low = 0, high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (value < list[middle]) high = middle;
    else low = middle + 1;
  }
  return low;
}

// two keys and the weight of the second at a time
export function between(times, easings, now) {
  const key = bisectRight(times, now) - 1, here = Math.max(key, 0);
  if (key < 0 || key === times.length - 1) return [here, here, 0];
  return [key, key + 1, EASINGS[easings[key]]((now - times[key]) / (times[key + 1] - times[key]))];
}

// the value of keys {times, values, easings} at a time
export function keyed({ times, values, easings }, now) {
  const [a, b, weight] = between(times, easings, now);
  return values[a] + weight * (values[b] - values[a]);
}

export class Curve {
  constructor(points, smooth, rules) {
    const both = [0, 1], ways = pairs(points), chords = ways.map(([a, b]) => far(b[0] - a[0], b[1] - a[1]));
    const slopes = ways.map(([a, b], k) => both.map((i) => (b[i] - a[i]) / chords[k])), tangents = [slopes[0]];
    for (let k = 1; k < chords.length; k++) {
      const before = chords[k - 1], after = chords[k];
      tangents.push(both.map((i) => (slopes[k - 1][i] * after + slopes[k][i] * before) / (before + after)));
    }
    tangents.push(slopes.at(-1));
    if (chords.length > 1) {
      const last = chords.length;
      tangents[0] = both.map((i) => 2 * slopes[0][i] - tangents[1][i]);
      tangents[last] = both.map((i) => 2 * slopes.at(-1)[i] - tangents[last - 1][i]);
    }
    Object.assign(this, { rules, x: [points[0][0]], z: [points[0][1]], at: [0], knots: [0] });
    chords.forEach((chord, k) => {
      const steps = Math.ceil(chord / rules.SPACING - 1e-9);
      for (let step = 1; step <= steps; step++) {
        const t = step / steps, u = 1 - t;
        const [x, z] = both.map((i) => {
          const a = points[k][i], b = points[k + 1][i];
          if (!smooth) return u * a + t * b;
          return u * u * (1 + 2 * t) * a + t * t * (1 + 2 * u) * b
            + u * t * (u * (tangents[k][i] * chord) - t * (tangents[k + 1][i] * chord));
        });
        this.at.push(this.at.at(-1) + far(x - this.x.at(-1), z - this.z.at(-1)));
        this.x.push(x), this.z.push(z);
      }
      this.knots.push(this.at.at(-1));
    });
    this.length = this.at.at(-1);
  }

  point(distance) {
    const { x, z, at } = this;
    if (distance >= this.length) return [x.at(-1), z.at(-1)];
    const k = Math.max(bisectRight(at, distance), 1), share = Math.max(distance - at[k - 1], 0) / (at[k] - at[k - 1]);
    return [x[k - 1] + share * (x[k] - x[k - 1]), z[k - 1] + share * (z[k] - z[k - 1])];
  }

  tangent(distance) {
    const here = clamp(distance, 0, this.length), { SPACING } = this.rules;
    const [ax, az] = this.point(Math.max(here - SPACING, 0)), [bx, bz] = this.point(here + SPACING);
    const size = Math.max(far(bx - ax, bz - az), 1e-12);
    return [(bx - ax) / size, (bz - az) / size];
  }
}

// speeds: {times, values, easings};  arrivals: [[distance, time]];  holds: [{time, distance, seconds}];  duration: seconds or null
export class Course {
  constructor(curve, speeds, arrivals, holds, duration) {
    const { rules } = curve, { FPS, FASTEST, LONGEST, SETTLE } = rules;
    const order = (rows) => rows.sort(([a, b], [c, d]) => a - c || b - d);
    Object.assign(this, { curve, rules, speeds, distance: [0], speed: [0], stop: 0, until: 0, late: [] });
    this.pauses = order(holds.filter((hold) => hold.time != null).map((hold) => [hold.time, hold.seconds]));
    this.stops = order(holds.filter((hold) => hold.distance != null)
      .map((hold) => [Math.min(hold.distance, curve.length), hold.seconds]));
    this.stops.push([curve.length, Infinity]);
    arrivals.forEach(([distance, time], k) => {
      let slow = 0, fast = FASTEST;
      if (this.walk(distance, fast, time).reached) {
        for (let i = 0; i < 30; i++) {
          const middle = (slow + fast) / 2;
          if (this.walk(distance, middle, time).reached) fast = middle;
          else slow = middle;
        }
      } else this.late.push(k);
      this.keep(this.walk(distance, fast, LONGEST));
    });
    this.keep(this.walk(curve.length, 1, duration ?? LONGEST));
    const { distance, speed } = this, last = distance.at(-1);
    this.end = last >= curve.length - 1e-9 ? (distance.length - 1) / FPS : null;
    const seconds = duration ?? (this.end === null ? LONGEST : Math.min(this.end + SETTLE, LONGEST)), count = round(seconds * FPS) + 1;
    while (distance.length < count) distance.push(last), speed.push(0);
    distance.length = speed.length = count;
  }

  keep({ distances, speeds, stop, until }) {
    for (let k = 0; k < distances.length; k++) this.distance.push(distances[k]), this.speed.push(speeds[k]);
    Object.assign(this, { stop, until });
  }

  walk(goal, scale, latest) {
    const { FPS, ACCELERATION } = this.rules, first = this.distance.length, distances = [], speeds = [];
    let at = this.distance.at(-1), speed = this.speed.at(-1), { stop, until } = this;
    while (at < goal - 1e-9) {
      const now = (first + distances.length) / FPS, [limit, ends] = this.stops[stop];
      if (now > latest + 1e-9) return { distances, speeds, stop, until, reached: false };
      speed = Math.max(Math.min(speed + ACCELERATION / FPS, scale * this.natural(now)), speed - (2 * ACCELERATION) / FPS, 0);
      speed = Math.min(speed, Math.sqrt(2 * ACCELERATION * Math.max(limit - at, 0)));
      for (const [time, seconds] of this.pauses)
        if (now < time + seconds) speed = Math.min(speed, ACCELERATION * Math.max(time - now, 0));
      if (now < until) speed = 0;
      at = Math.min(at + speed / FPS, limit);
      if (at >= limit - 1e-9 && now >= until && stop < this.stops.length - 1) until = now + ends, stop += 1;
      distances.push(at), speeds.push(speed);
    }
    return { distances, speeds, stop, until, reached: true };
  }

  natural(now) {
    return keyed(this.speeds, now);
  }
}

export function nearest(curve, place, distance) {
  const { BEHIND, BEFORE } = curve.rules, { at, x, z } = curve;
  const first = Math.max(bisectRight(at, distance - BEHIND) - 1, 0), last = Math.min(bisectRight(at, distance + BEFORE), at.length - 1);
  let best = distance, least = Infinity;
  for (let k = first; k < last; k++) {
    const size = at[k + 1] - at[k], ux = (x[k + 1] - x[k]) / size, uz = (z[k + 1] - z[k]) / size;
    const along = clamp((place[0] - x[k]) * ux + (place[1] - z[k]) * uz, 0, size);
    const apart = far(x[k] + along * ux - place[0], z[k] + along * uz - place[1]);
    if (apart < least) best = at[k] + along, least = apart;
  }
  return best;
}

// direction, look: pairs or null;  turns: the angles of the curve's points, or null
export class Heading {
  constructor(curve, direction, look, turns) {
    Object.assign(this, { curve, direction, look, easings: turns.map(() => "linear") });
    const rule = (at) => this.rule(at, curve.point(at));
    this.offsets = turns.map((angle, k) => (angle === null ? 0 : wrapped(angle - rule(curve.knots[k]))));
  }

  rule(distance, place) {
    if (this.look) return Math.atan2(this.look[0] - place[0], this.look[1] - place[1]);
    return Math.atan2(...(this.direction ?? this.curve.tangent(distance)));
  }

  angle(distance, place) {
    const [a, b, weight] = between(this.curve.knots, this.easings, distance);
    return this.rule(distance, place) + this.offsets[a] + weight * (this.offsets[b] - this.offsets[a]);
  }
}

// {velocity, facing} of a character at a place, so that it keeps to a course
export function command(course, heading, frame, place) {
  const { curve, rules } = course, last = course.distance.length - 1, planned = course.distance[Math.min(frame, last)];
  const ahead = Math.min(frame + round(rules.LEAD * rules.FPS), last), here = nearest(curve, place, planned);
  const lead = here + course.distance[ahead] - planned, angle = heading.angle(lead, place), speed = course.speed[ahead];
  const [x, z] = curve.point(here), [tx, tz] = curve.tangent(lead);
  const behind = planned - here, acrossX = x - place[0], acrossZ = z - place[1];
  const vx = rules.ALONG * behind * tx + rules.ACROSS * acrossX, vz = rules.ALONG * behind * tz + rules.ACROSS * acrossZ;
  const [most, largest] = speed === 0 ? [rules.STANDING, rules.GENTLE] : [1, rules.LARGEST];
  let share = Math.min(most, largest / Math.max(far(vx, vz), 1e-12));
  if (speed === 0) share *= Math.max(1 - rules.NEAR / Math.max(Math.sqrt(behind ** 2 + acrossX ** 2 + acrossZ ** 2), 1e-12), 0);
  return { velocity: [speed * tx + share * vx, speed * tz + share * vz], facing: [Math.sin(angle), Math.cos(angle)] };
}
