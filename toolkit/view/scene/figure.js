// A character of the user's own: a skinned mesh over its own joints, in place of the mannequin.
//
// skeleton.mesh is that of body.js, with
//   follow: null where poses are those of its joints; otherwise the joints follow those of the skeleton:
//     {rules: [[joint, a, b, share, ...turn of a, ...turn of b, ...turn of the joint]], rest: [[w, x, y, z]], scale, lift,
//      hips: [[left, right] of the skeleton, [left, right] of the mesh]}
// A rule: the joint's world rotation is slerp(that of a * its turn, that of b * its turn, share) * the joint's turn
// (characters/retargeting.py). The other joints keep their rest rotation.
import * as THREE from "three";
import { Body, multiply, Tree } from "./body.js";

const middle = ({ places }, [left, right]) => [0, 1, 2].map((i) => (places[3 * left + i] + places[3 * right + i]) / 2);

export class Figure extends Body {
  constructor(skeleton, light, plain) {
    super(skeleton, light, plain);
    const { mesh } = skeleton, { follow } = mesh;
    this.mesh.material.side = THREE.DoubleSide;
    Object.assign(this, { follow, scale: follow?.scale ?? 1, own: new Tree(mesh) });
    this.rest = follow && Float32Array.from(follow.rest.flat());
  }

  pose(root, rotations) {
    this.tree.pose(root, rotations);
    if (this.follow) this.lead();
    this.skin(this.follow ? this.own : this.tree);
  }

  // the mesh's joints after those of the skeleton
  lead() {
    const { rules, scale, lift, hips } = this.follow, { own: tree, tree: source, rest } = this, a = new Float32Array(8);
    const rule = new Map(rules.map((row) => [row[0], row]));
    tree.parents.forEach((parent, j) => {
      const row = rule.get(j);
      if (!row) {
        if (parent < 0) tree.turned.set(rest.subarray(4 * j, 4 * j + 4), 4 * j);
        else multiply(tree.turned, 4 * parent, rest, 4 * j, tree.turned, 4 * j);
        return;
      }
      multiply(source.turned, 4 * row[1], row, 4, a, 0);
      multiply(source.turned, 4 * row[2], row, 8, a, 4);
      const dot = a[0] * a[4] + a[1] * a[5] + a[2] * a[6] + a[3] * a[7], share = row[3];
      const angle = Math.acos(Math.min(Math.abs(dot), 1)), sine = Math.sin(angle), sign = dot < 0 ? -1 : 1;
      const [p, q] = sine < 1e-4 ? [1 - share, share] : [Math.sin((1 - share) * angle) / sine, Math.sin(share * angle) / sine];
      const mixed = [0, 1, 2, 3].map((i) => p * a[i] + sign * q * a[4 + i]), norm = Math.hypot(...mixed);
      multiply(mixed.map((v) => v / norm), 0, row, 12, tree.turned, 4 * j);
    });
    tree.put([0, 0, 0]);
    const from = middle(tree, hips[1]), to = middle(source, hips[0]);
    tree.put(to.map((v, i) => scale * v + (i === 1 ? lift : 0) - from[i]));
  }
}
