// The shots of a director, one per character: changes with undo, and the motion of each, computed in slices of time.
//
// Desk(data, scene, changed): data of view/director.py's pack; scene as a file holds it. `changed(what)` is called after a change of
//   the shots ("shots"), of the undo list ("kept"), and whenever more frames are there ("frames").
import { Character } from "./character.js";
import { Network } from "./network.js";
import { numbers } from "./numbers.js";
import { data as sceneOf, parse, shot as checked, Take } from "./shot.js";

const othersOf = ({ version, shots, ...more }) => more; // fields of a scene that are kept for its file
const SLICE = 25, BATCH = 4, DEEP = 200; // ms of computing at once; frames between looks at the clock; steps that can be undone

export class Desk {
  constructor(data, scene, changed) {
    const { course: rules, limits, styles, speeds } = data, vectors = numbers(data.vectors);
    Object.assign(this, { data, rules, limits, styles, speeds, vectors, size: vectors.length / styles.length, changed });
    Object.assign(this, { shots: parse(scene, styles), takes: [], making: [], past: [], future: [], held: null, stats: { ms: [] } });
    this.more = othersOf(scene);
    this.network = new Network(data.network);
    this.drawn = new Character(data, this.network);
    this.channel = new MessageChannel();
    this.channel.port1.onmessage = () => this.work();
    this.selected = 0;
    this.renew([]);
  }

  get shot() {
    return this.shots[this.selected];
  }

  get scene() {
    return sceneOf(this.shots, this.more);
  }

  // Replaces the shots. `edit` gets a copy of them and may change it; an Error of one line if the result is not valid.
  change(edit) {
    const before = JSON.stringify(this.scene), draft = JSON.parse(JSON.stringify(this.shots)), old = this.shots;
    const made = (edit(draft) ?? draft).map((shot) => checked(shot, this.styles)), after = JSON.stringify(sceneOf(made, this.more));
    if (after === before) return;
    this.put(made, old);
    if (this.held === null) this.keep(before);
  }

  // Replaces everything by what a file holds; an Error of one line if it is not valid.
  open(scene) {
    const shots = parse(scene, this.styles);
    this.more = othersOf(scene);
    this.change(() => shots);
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
    this.put(parse(JSON.parse(from.pop()), this.styles), this.shots);
    this.changed("kept");
  }

  redo() {
    this.undo(this.future, this.past);
  }

  put(made, old) {
    this.shots = made;
    this.selected = Math.min(this.selected, made.length - 1);
    this.renew(old);
    this.changed("shots");
  }

  // new takes of the shots that are not the same as before
  renew(old) {
    const text = (shot) => JSON.stringify({ ...shot, name: "" }), known = old.map(text);
    const now = performance.now(), takes = [], making = [];
    this.shots.forEach((shot, k) => {
      const at = known[k] === text(shot) ? k : known.indexOf(text(shot));
      takes[k] = this.takes[at < 0 ? k : at];
      const older = [this.takes[k], this.making[k]].filter(Boolean);
      making[k] = at < 0 ? new Take(shot, this, new Character(this.data, this.network), now, older) : this.making[at];
      if (at < 0) this.stats.since = making[k].frames.length; // the first frame that is computed again
    });
    Object.assign(this, { takes, making });
    this.due();
  }

  due() {
    if (this.waits || !this.making.some(Boolean)) return;
    this.waits = true;
    this.channel.port2.postMessage(null);
  }

  // frames of the selected character first
  work() {
    this.waits = false;
    const until = performance.now() + SLICE, order = [this.selected, ...this.making.keys()];
    for (const k of order) {
      const take = this.making[k];
      let more = !!take;
      while (more && performance.now() < until) for (let i = 0; more && i < BATCH; i++) more = take.step();
      if (more) break;
      if (!take) continue;
      [this.takes[k], this.making[k]] = [take, null];
      this.stats.ms.push(performance.now() - take.since);
    }
    this.changed("frames");
    this.due();
  }

  // the newest take of a character that has a frame; before the first is ready, none
  take(k, frame = 0) {
    const { making: { [k]: making }, takes: { [k]: take } } = this;
    return making && (making.frames.length > frame || !take) ? making : take;
  }

  // root and rotations [J * 4] of a frame; the last one after the end; null while there is none
  pose(k, frame) {
    const take = this.take(k, frame), found = take?.frames[Math.min(Math.max(frame, 0), take.frames.length - 1)], { drawn } = this;
    if (!found) return null;
    drawn.state = found;
    drawn.pose(take.shot);
    return { root: drawn.root, rotations: drawn.rotations, contacts: found.contacts };
  }

  // all frames of a character, [[root, rotations]]; it is computed to its end
  motion(k) {
    const take = this.making[k] ?? this.takes[k];
    while (take.step());
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
