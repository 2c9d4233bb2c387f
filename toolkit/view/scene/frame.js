// What a frame does before and after its network. The functions have the names of those in compiled/frame.py, runtime/steering.py
// and motion/ik.py.
//
// state: float64 arrays named as those of runtime.CharacterState: history [61 * 4], future [6 * 4], drive [1], joints [12 J], phase,
//   velocity [2], facing [2], asked [2], aside [1], rest [1], contacts [2], toes [2 * 3], drift [2 * 3], drop [2], swivel [2]
// rules: runtime/rules.py's Rules, and where a joint's position, forward, up and velocity are in its `width` numbers

export const copy = (state) => Object.fromEntries(Object.entries(state).map(([name, values]) => [name, Float64Array.from(values)]));

// three numbers from a place of an array on
export const three = (values, at) => [values[at], values[at + 1], values[at + 2]];

// a state that stands still, at a place [x, z], with a direction [sin, cos]
export function stand(state, place, facing) {
  const moved = copy(state), [x, z, sin, cos] = state.history.slice(-4), s = facing[0] * cos - facing[1] * sin;
  const c = facing[0] * sin + facing[1] * cos, turned = (dx, dz) => [c * dx + s * dz, c * dz - s * dx];
  for (const window of [moved.history, moved.future])
    for (let i = 0; i < window.length; i += 4) window.set([...place, ...facing], i);
  moved.facing.set(facing);
  for (let i = 0; i < moved.toes.length; i += 3) {
    const [dx, dz] = turned(state.toes[i] - x, state.toes[i + 2] - z);
    moved.toes[i] = place[0] + dx, moved.toes[i + 2] = place[1] + dz;
  }
  return moved;
}

const lerp = (a, b, share) => a + share * (b - a);
const clamp = (v, low, high) => Math.min(Math.max(v, low), high);

export function unit(v) {
  let square = 0;
  for (const x of v) square += x * x; // Math.hypot is slow
  const length = Math.max(Math.sqrt(square), 1e-12);
  return v.map((x) => x / length);
}

// direction (ax, az) turned towards (bx, bz) along the shorter way
function turn(ax, az, bx, bz, share, most = Infinity) {
  const by = share * Math.atan2(az * bx - ax * bz, ax * bx + az * bz), angle = Math.atan2(ax, az) + clamp(by, -most, most);
  return [Math.sin(angle), Math.cos(angle)];
}

// velocity of the root over half a second up to so many frames ago, m/s
function moved(history, ago, rules) {
  const here = history.length - 4 * (1 + ago), there = here - 4 * rules.half_second, scale = rules.fps / rules.half_second;
  return [(history[here] - history[there]) * scale, (history[here + 1] - history[there + 1]) * scale];
}

function speedController(history, drive, velocity, rules) {
  const wanted = Math.hypot(...velocity);
  if (wanted <= rules.moves) return lerp(drive, 1, 0.05);
  const [x, z] = unit(velocity);
  const [lag, before] = [0, 1].map((ago) => {
    const [vx, vz] = moved(history, ago, rules);
    return clamp((wanted - (vx * x + vz * z)) / Math.max(wanted, 0.5), -1, 1);
  });
  const push = rules.proportional * (lag - before) + (rules.integral / rules.fps) * lag;
  return clamp(drive + Math.max(drive, 1) * push, 0, rules.max_drive);
}

// share of walking, which grows with the commanded speed
const moves = (speed, rules) => clamp((speed - rules.moves) / (rules.slow - rules.moves), 0, 1);

// change of the target velocity that opposes the lateral velocity; fills asked and aside of the new state
function directionController(old, velocity, rules, next) {
  const asked = velocity.map((v, i) => lerp(old.asked[i], v, rules.asked)), [x, z] = unit(velocity), now = moved(old.history, 0, rules);
  const lateral = (now[0] - asked[0]) * z - (now[1] - asked[1]) * x, speed = Math.hypot(...velocity);
  next.asked.set(asked);
  next.aside[0] = speed > rules.moves ? clamp(old.aside[0] + rules.sideways_sum * lateral, -1, 1) : rules.forget * old.aside[0];
  const push = moves(speed, rules) * (rules.sideways * lateral + next.aside[0]) * Math.max(old.drive[0], 1);
  return [-push * z, push * x];
}

// share of standing still, for a root with a direction
function standing({ rest, facing }, [sin, cos], { may_stand, aligned }) {
  return rest[0] * clamp((sin * facing[0] + cos * facing[1] - may_stand) / (aligned - may_stand), 0, 1);
}

// Fills x, and of the new state the command's parts and the future bent towards the command {velocity, facing} (section 4.4).
export function steer(old, command, rules, x, next) {
  const { history, future } = old, bent = next.future, here = history.length - 4;
  const change = [0, 1].map((i) => rules.gain * (command.velocity[i] - old.velocity[i]));
  const slower = rules.fastest / Math.max(Math.hypot(...change), rules.fastest);
  const velocity = [0, 1].map((i) => old.velocity[i] + slower * change[i]), speed = Math.hypot(...velocity);
  const facing = Math.hypot(...command.facing) > 1e-6 ? turn(...old.facing, ...command.facing, rules.gain, rules.spin) : old.facing;
  next.velocity.set(velocity);
  next.facing.set(facing);
  const drive = old.drive[0], rest = clamp(old.rest[0] + (speed < rules.moves ? rules.standing : -rules.starting), 0, 1);
  next.drive[0] = speedController(history, drive, velocity, rules);
  next.rest[0] = rest;

  const slow = rules.stand_still * Math.max(1 - Math.min(speed / rules.slow, drive / rules.low), 0);
  const across = directionController(old, velocity, rules, next), now = moved(history, 0, rules);
  const walks = Math.min(Math.hypot(...command.velocity) / Math.max(Math.hypot(...now), rules.slow), 1);
  const slowly = clamp(2 - Math.hypot(...now) / rules.slow, 0, 1); // astray: it does not go where it should
  const along = (now[0] * velocity[0] + now[1] * velocity[1]) / (rules.low * Math.max(speed * speed, 1e-6));
  const astray = moves(speed, rules) * slowly * clamp(1 - along, 0, 1);
  const pull = velocity.map((v, i) => drive * v + slow * (lerp(v, next.asked[i], walks) - now[i]) + across[i]);
  const rootX = history[here], rootZ = history[here + 1], sin = history[here + 2], cos = history[here + 3];
  let px = rootX, pz = rootZ;
  bent.set(history.subarray(here));
  for (let s = 1; s < rules.position_shares.length; s++) {
    const at = 4 * s, share = lerp(rules.position_shares[s], 1, Math.max(rest, astray));
    px += lerp(future[at] - future[at - 4], pull[0] * rules.seconds[s], share);
    pz += lerp(future[at + 1] - future[at - 3], pull[1] * rules.seconds[s], share);
    bent[at] = px, bent[at + 1] = pz;
    bent.set(turn(future[at + 2], future[at + 3], facing[0], facing[1], lerp(rules.direction_shares[s], 1, rest)), at + 2);
  }
  const { samples } = rules, current = samples.length - rules.position_shares.length;
  for (let s = 0; s < samples.length; s++) {
    const [from, k] = s < current ? [history, 4 * samples[s]] : [bent, 4 * (s - current)], at = rules.trajectory_in + 4 * s;
    const dx = from[k] - rootX, dz = from[k + 1] - rootZ, fx = from[k + 2], fz = from[k + 3];
    x[at] = cos * dx - sin * dz, x[at + 1] = sin * dx + cos * dz;
    x[at + 2] = cos * fx - sin * fz, x[at + 3] = sin * fx + cos * fz;
  }
  x.set(old.joints, rules.joints_in);
}

// where the pose has the toes, world, right and left
function toes({ history, joints }, rules) {
  const [x, z, sin, cos] = history.subarray(history.length - 4), [s, c] = unit([sin, cos]);
  return rules.legs.map(([, , joint]) => {
    const [px, py, pz] = three(joints, rules.width * joint + rules.position);
    return [c * px + s * pz + x, py, c * pz - s * px + z];
  });
}

// ik.py's foot_lock
export function footLock(old, next, raised, rules) {
  const [before, predicted] = [old, next].map((state) => toes(state, rules)), [sin, cos] = next.history.slice(-2), left = [cos, -sin];
  const seconds = 1 / rules.fps, fade = Math.exp(-rules.let_go * seconds);
  const most = Math.min(...next.contacts) > rules.both ? rules.settle : 0;
  for (const side of [0, 1]) {
    const there = predicted[side], other = predicted[1 - side], inwards = left.map((v) => (side ? -v : v));
    const offset = there.map((_, i) => old.toes[3 * side + i] - before[side][i]);
    const push = offset.map((v, i) => old.drift[3 * side + i] + rules.let_go * v);
    const contact = next.contacts[side], held = contact > 0.5;
    const lands = contact > old.contacts[side] && there[1] < rules.ground + rules.uneven;
    const share = lands ? Math.min(2 * contact, 1) * Math.min(2 * old.contacts[1 - side], 1) : 0;
    const shares = held ? [1, 1, 1] : [share, 0, share], stays = there.map((v, i) => old.toes[3 * side + i] - v);
    const scale = rules.slack / Math.max(Math.hypot(...stays), rules.slack);
    let now = offset.map((v, i) => lerp(fade * (v + push[i] * seconds), stays[i] * scale, shares[i]));
    const apart = (other[0] - there[0]) * inwards[0] + (other[2] - there[2]) * inwards[1];
    const over = Math.max(now[0] * inwards[0] + now[2] * inwards[1] - Math.max(apart / 4, rules.near), 0);
    const up = rules.ground - there[1] - now[1];
    const far = most || held ? Math.max(-up - rules.uneven - rules.heel * Math.max(raised[side], 0), up - rules.sunk, 0) : 0, limit = most + far * rules.level;
    now = [now[0] - over * inwards[0], now[1] + clamp(up, -limit, limit), now[2] - over * inwards[1]];
    for (const i of [0, 1, 2])
      next.drift[3 * side + i] = shares[i] > 0 ? (now[i] - offset[i]) / seconds
        : fade * (old.drift[3 * side + i] - rules.let_go * push[i] * seconds);
    next.toes.set(there.map((v, i) => v + now[i]), 3 * side);
  }
}

// The new pose: halfway between the prediction and where velocities lead, seen from the new root frame; a leg in contact is
// only led by its velocities.
function pose(was, z, [sin, cos], [right, ahead], contacts, held, rules, joints) {
  const { position, forward, up, velocity, width, joints_out } = rules, shares = new Float64Array(was.length / width).fill(0.5);
  rules.legs.forEach((leg, side) => leg.forEach((j) => (shares[j] *= 1 - Math.min(2 * contacts[side], 1))));
  const limits = new Float64Array(shares.length).fill(rules.jump);
  for (const j of rules.legs.flat()) limits[j] = 1e6;
  const lifts = new Float64Array(shares.length);
  rules.legs.forEach(([, , toe], side) => (lifts[toe] = rules.lift * (1 - Math.min(2 * contacts[side], 1))));
  const write = (at, vx, vy, vz) => (joints[at] = cos * vx + sin * vz, joints[at + 1] = vy, joints[at + 2] = cos * vz - sin * vx);
  const slow = (at, v) => v.map((x, i) => lerp(x, was[at + i], held)); // a start: the share 1 - held of a frame
  for (let j = 0; j < was.length; j += width) {
    const out = joints_out + j, p = out + position, v = out + velocity, at = j + position;
    const [fx, fy, fz] = unit(slow(j + forward, three(z, out + forward)));
    const [ux, uy, uz] = slow(j + up, three(z, out + up)), along = ux * fx + uy * fy + uz * fz;
    const over = unit([ux - along * fx, uy - along * fy, uz - along * fz]);
    const share = shares[j / width];
    const changes = [0, 1, 2].map((i) => share * (z[p + i] - was[at + i] - z[v + i] / rules.fps));
    const most = limits[j / width], slower = most / Math.max(Math.hypot(...changes), most), led = (i) => was[at + i] + z[v + i] / rules.fps + slower * changes[i];
    const swing = lifts[j / width] * Math.min(Math.max(led(1) - rules.ground, 0), rules.high);
    write(at, ...slow(at, [led(0), led(1) + swing, led(2)]));
    write(j + forward, fx, fy, fz);
    write(j + up, over[0], over[1], over[2]);
    write(j + velocity, z[v], z[v + 1], z[v + 2]);
    joints[at] += right, joints[at + 2] += ahead;
  }
}

// Fills the rest of the new state from the network's outputs z (section 4.4).
export function afterNetwork(old, z, rules, next) {
  const { history, future } = next, here = history.length - 4;
  const [rootX, rootZ, sin, cos] = old.history.subarray(here);
  history.set(old.history.subarray(4));
  for (let s = 0; s < rules.position_shares.length; s++) {
    const at = rules.trajectory_out + 4 * s, k = 4 * s, [dx, dz] = unit([z[at + 2], z[at + 3]]);
    const place = [cos * z[at] + sin * z[at + 1] + rootX, cos * z[at + 1] - sin * z[at] + rootZ];
    const direction = [cos * dx + sin * dz, cos * dz - sin * dx];
    if (s === 0) { // a character that is to stand gives up its way first, and its turn once it looks where it should
      const turned = turn(...direction, sin, cos, standing(next, [sin, cos], rules));
      history.set([lerp(place[0], rootX, next.rest[0]), lerp(place[1], rootZ, next.rest[0]), ...turned], here);
      future.set(history.subarray(here));
    } else {
      const mixed = [...place, ...direction].map((v, i) => lerp(future[k + i], v, rules.correction));
      future.set([mixed[0], mixed[1], ...unit(mixed.slice(2))], k);
    }
  }
  const [x, z1, newSin, newCos] = history.subarray(here), dx = rootX - x, dz = rootZ - z1;
  const around = unit([sin * newCos - cos * newSin, cos * newCos + sin * newSin]);
  const stand = standing(next, [sin, cos], rules);
  for (const side of [0, 1]) { // while the character stands, a low foot comes down and then stays there
    const contact = clamp(z[rules.contacts + side], 0, 1), low = old.toes[3 * side + 1] < rules.ground + rules.lifted;
    next.contacts[side] = stand > rules.stands && low ? Math.max(contact, Math.min(old.contacts[side] + rules.landing, 1)) : contact;
  }
  const held = Math.hypot(...next.velocity) > rules.moves ? next.rest[0] : 0;
  const shift = [newCos * dx - newSin * dz, newSin * dx + newCos * dz];
  pose(old.joints, z, around, shift, next.contacts, held, rules, next.joints);
  const still = Math.max(stand * Math.min(...next.contacts), held);
  for (let i = 0; i < next.phase.length; i += 2) { // limb by limb, as networks/phase.py's advance
    const update = [0, 1].map((k) => z[rules.updates + i + k]), total = update.map((v, k) => old.phase[i + k] + v);
    const share = Math.min((rules.pull * Math.hypot(...update)) / Math.max(Math.hypot(...total), 1e-6), 0.5);
    for (const k of [0, 1]) next.phase[i + k] = lerp(lerp(total[k], z[rules.phases + i + k], share), old.phase[i + k], still);
  }
}
