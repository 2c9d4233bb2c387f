// The shots of a director, one per character: changes with undo, and the motion of each, computed in slices of time.
//
// Desk(data, scene, changed): data of shots/director.py's pack; scene as a file holds it. `changed(what)` is called after a change of
//   the shots ("shots"), of the undo list ("kept"), and whenever more frames are there ("frames").
// filled(motion) takes what the kernel rendered, of a model that does not run in a page: data has no network then.
// `findings` are the defects of the motion (findings.js); null until all of it is looked at.
import { Together } from "./apart.js";
import { Tree } from "./body.js";
import { Character } from "./character.js";
import { defects } from "./findings.js";
import { Network } from "./network.js";
import { numbers } from "./numbers.js";
import { missedPins, pinned } from "./pins.js";
import { kinematics } from "./pose.js";
import { beside, data as sceneOf, parse, plan, shot as checked, starts, Take } from "./shot.js";

const SLICE = 25, BATCH = 4, DEEP = 200; // ms of computing at once; frames between looks at the clock; steps that can be undone

// A shot whose motion the kernel renders: until it is there, that of an older take, on the new plan.
class Rendered {
  constructor(shot, desk, since, { frames, places } = { frames: [], places: [] }) {
    Object.assign(this, { shot, ...plan(shot, desk), since, frames, places, apart: [] });
    this.count = this.course.distance.length - 1;
  }

  // rows of director.py's frames
  fill(rows, joints) {
    const width = 9 + 4 * joints, count = this.count = rows.length / width;
    this.frames = Array.from({ length: count }, (_, f) => {
      const part = (from, to) => rows.subarray(f * width + from, f * width + to);
      return { history: part(0, 4), contacts: part(4, 6), root: part(6, 9), rotations: part(9, width) };
    });
    this.places = this.frames.map(({ history: [x, z] }) => [x, z]);
    this.apart = beside({ ...this, apart: null });
  }

  step() {
    return false;
  }
}

export class Desk {
  constructor(data, scene, changed) {
    const { course: rules, limits, styles, speeds } = data, vectors = numbers(data.vectors);
    Object.assign(this, { data, rules, limits, styles, speeds, vectors, size: vectors.length / styles.length, changed });
    Object.assign(this, { ...parse(scene, styles), takes: [], making: [], past: [], future: [], held: null, stats: { ms: [] } });
    this.pins = { ...data.pins, FPS: rules.FPS };
    this.network = data.network ? new Network(data.network) : null;
    this.drawn = this.network && new Character(data, this.network);
    this.channel = new MessageChannel();
    this.channel.port1.onmessage = () => this.work();
    this.selected = 0;
    this.renew([], null);
  }

  get shot() {
    return this.shots[this.selected];
  }

  get scene() {
    return sceneOf(this.shots, this.more);
  }

  // Replaces the shots. `edit` gets a copy of them and may change it; an Error of one line if the result is not valid.
  change(edit) {
    const draft = JSON.parse(JSON.stringify(this.shots)), made = (edit(draft) ?? draft).map((shot) => checked(shot, this.styles));
    this.replace({ shots: made, more: starts(made, this.more) });
  }

  // Replaces everything by what a file holds; an Error of one line if it is not valid.
  open(scene) {
    this.replace(parse(scene, this.styles), []);
  }

  replace(made, old = this.shots) {
    const before = JSON.stringify(this.scene);
    if (JSON.stringify(sceneOf(made.shots, made.more)) === before) return;
    this.put(made, old);
    if (this.held === null) this.keep(before);
  }

  // the changes from begin to end are one step of undo
  begin() {
    this.held ??= JSON.stringify(this.scene);
  }

  end() {
    const { held } = this;
    this.held = null;
    if (held !== null && held !== JSON.stringify(this.scene)) this.keep(held);
  }

  keep(before) {
    this.past.push(before);
    if (this.past.length > DEEP) this.past.shift();
    this.future = [];
    this.changed("kept");
  }

  undo(from = this.past, to = this.future) {
    if (!from.length) return;
    to.push(JSON.stringify(this.scene));
    this.put(parse(JSON.parse(from.pop()), this.styles));
    this.changed("kept");
  }

  redo() {
    this.undo(this.future, this.past);
  }

  put({ shots, more }, old = this.shots) {
    const before = JSON.stringify(this.more);
    Object.assign(this, { shots, more, selected: Math.min(this.selected, shots.length - 1) });
    this.renew(old, before);
    this.changed("shots");
  }

  // new takes of the shots that are not the same as before; of those who keep apart, all or none
  renew(old, before) {
    const text = (shot) => JSON.stringify({ ...shot, name: "" }), known = old.map(text), texts = this.shots.map(text);
    const now = performance.now(), takes = [], making = [], { more } = this, around = JSON.stringify(more);
    const same = around === before && (more.apart === undefined || texts.join() === known.join());
    texts.forEach((own, k) => {
      const at = !same ? -1 : known[k] === own ? k : known.indexOf(own);
      takes[k] = old.length ? this.takes[at < 0 ? k : at] : undefined; // opened: nothing is left of other shots
      const older = more.apart === undefined ? [takes[k], old.length && this.making[k]].filter((take) => take && !take.together) : [];
      making[k] = at >= 0 ? this.making[at] : !this.network ? new Rendered(this.shots[k], this, now, takes[k])
        : new Take(this.shots[k], this, new Character(this.data, this.network), now, older);
      if (at < 0) this.stats.since = making[k].frames.length; // the first frame that is computed again
    });
    Object.assign(this, { takes, making, findings: null, judging: null });
    if (more.apart === undefined || !this.network) this.together = null;
    else if (!same) this.together = new Together([...making], more, this);
    this.due();
  }

  due() {
    const busy = this.making.some(Boolean);
    if (this.waits || (busy ? !this.network : this.findings)) return;
    this.waits = true;
    this.channel.port2.postMessage(null);
  }

  // frames of the selected character first; of all together where they keep apart
  work() {
    this.waits = false;
    const until = performance.now() + SLICE, { together, making } = this;
    const groups = together ? [[together, [...making.keys()]]] : [this.selected, ...making.keys()].map((k) => [making[k], [k]]);
    for (const [one, members] of groups) {
      if (!members.some((k) => this.making[k])) continue;
      let more = true;
      while (more && performance.now() < until) for (let i = 0; more && i < (together ? 1 : BATCH); i++) more = one.step();
      if (more) break;
      this.stats.ms.push(performance.now() - this.making[members[0]].since);
      for (const k of members) [this.takes[k], this.making[k]] = [this.making[k], null];
    }
    if (!making.some(Boolean)) this.judge(until);
    this.changed("frames");
    this.due();
  }

  // The motion as the kernel rendered it, {scene, takes}, or why it cannot, {scene, problem}: an Error. Of another scene, nothing.
  filled({ scene, takes, problem }) {
    if (this.network || !scene || JSON.stringify(parse(scene, this.styles)) !== JSON.stringify({ shots: this.shots, more: this.more })) return;
    if (problem) throw new Error(problem);
    this.takes = this.shots.map((shot, k) => this.making[k] ?? this.takes[k]);
    this.takes.forEach((take, k) => take.fill(numbers(takes[k]), this.data.joints.length));
    Object.assign(this, { making: this.takes.map(() => null), findings: null, judging: null });
    this.changed("frames");
    this.due();
  }

  // looks for defects in the whole motion, until a time
  judge(until) {
    const { data: { gate, skeleton }, takes, rules: { FPS }, more } = this;
    this.judging ??= defects(takes.map((take, k) => ({ count: take.frames.length, pose: (f) => this.pose(k, f) })), skeleton, FPS, gate, more.apart);
    while (performance.now() < until) {
      const { done, value } = this.judging.next();
      if (!done) continue;
      this.findings = value;
      break;
    }
  }

  // the share of the motion that is there
  get share() {
    const rows = this.shots.map((_, k) => this.making[k] ?? this.takes[k]), sum = (name) => rows.reduce((total, take) => total + name(take), 0);
    return sum((take) => take.frames.length) / Math.max(sum((take) => take.count), 1);
  }

  // the newest take of a character that has a frame; before the first is ready, none
  take(k, frame = 0) {
    const { making: { [k]: making }, takes: { [k]: take } } = this;
    return making && (making.frames.length > frame || !take) ? making : take;
  }

  // root and rotations [J * 4] of a frame; the last one after the end; null while there is none
  pose(k, frame) {
    const take = this.take(k, frame), found = take?.frames[Math.min(Math.max(frame, 0), take.frames.length - 1)], { drawn } = this;
    if (!found || !drawn) return found ?? null;
    drawn.state = found;
    const { data: { figure, body }, pins: r } = this, number = take.frames.indexOf(found) + 1;
    const pin = (turned, places, plant) => (this.drawnAt = [turned, places], pinned(turned, places, number, take, body, figure, r, plant));
    drawn.pose(take.shot, pin);
    return { root: drawn.root, rotations: drawn.rotations, contacts: found.contacts };
  }

  // the pins of a character that are missed, a line each
  missedPins(k) {
    const { data: { body, figure } } = this;
    return missedPins(this.take(k), (frame) => this.joints(k, frame), body, figure, this.pins);
  }

  // places of all joints in a frame
  joints(k, frame) {
    const { drawn, data: { skeleton } } = this, found = this.pose(k, frame);
    if (!drawn) {
      const tree = new Tree(skeleton);
      if (found) tree.pose(found.root, found.rotations);
      return skeleton.parents.map((_, j) => [...tree.places.subarray(3 * j, 3 * j + 3)]);
    }
    kinematics(this.data.body, ...this.drawnAt);
    return this.drawnAt[1];
  }

  // all frames of a character, [[root, rotations]]; it is computed to its end
  motion(k) {
    const take = this.making[k] ?? this.takes[k];
    if (!this.network && this.making[k]) throw new Error("the kernel has not rendered it yet");
    while ((this.together ?? take).step());
    return take.frames.map((_, f) => {
      const { root, rotations } = this.pose(k, f);
      return [root.slice(), rotations.slice()];
    });
  }

  dispose() {
    this.making = [];
    this.channel.port1.close();
  }
}
