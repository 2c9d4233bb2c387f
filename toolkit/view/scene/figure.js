// A character of the user's own: a skinned mesh over its own joints, in place of the mannequin (body.js), whose methods it has.
//
// skeleton.mesh = {
//   parents: [K], offsets: [[x, y, z]],          the mesh's own joints, metres, parents before children
//   inverse: float32 [K * 12]                    inverse world transforms of the joints in the pose of the points, 3x4 by rows
//   points, normals: float32 [V * 3], triangles: uint32 [T * 3], joints: uint16 [V * 4], weights: uint8 [V * 4] with sum 255,
//   colors: uint8 [V * 3]; all base64
//   follow: null where poses are those of these joints; otherwise the joints follow those of the skeleton:
//     {rules: [[joint, a, b, share, ...turn of a, ...turn of b, ...turn of the joint]], rest: [[w, x, y, z]], scale, lift,
//      hips: [[left, right] of the skeleton, [left, right] of the mesh]}
// }
// A rule: the joint's world rotation is slerp(that of a * its turn, that of b * its turn, share) * the joint's turn
// (motion/retargeting.py). The other joints keep their rest rotation. Vertices are posed here, not on the GPU, as in body.js.
import * as THREE from "three";
import { Body } from "./body.js";
import { decode } from "./numbers.js";

const SLOTS = 4;

// quaternions w, x, y, z at places of flat arrays
function multiply(a, i, b, j, c, k) {
  const aw = a[i], ax = a[i + 1], ay = a[i + 2], az = a[i + 3], bw = b[j], bx = b[j + 1], by = b[j + 2], bz = b[j + 3];
  c[k] = aw * bw - ax * bx - ay * by - az * bz;
  c[k + 1] = aw * bx + ax * bw + ay * bz - az * by;
  c[k + 2] = aw * by - ax * bz + ay * bw + az * bx;
  c[k + 3] = aw * bz + ax * by - ay * bx + az * bw;
}

// c[k] = a[i] + the vector v turned by the quaternion at q[j]
function place(a, i, q, j, [x, y, z], c, k) {
  const w = q[j], u = q[j + 1], v = q[j + 2], n = q[j + 3];
  const tx = 2 * (v * z - n * y), ty = 2 * (n * x - u * z), tz = 2 * (u * y - v * x);
  c[k] = a[i] + x + w * tx + v * tz - n * ty;
  c[k + 1] = a[i + 1] + y + w * ty + n * tx - u * tz;
  c[k + 2] = a[i + 2] + z + w * tz + u * ty - v * tx;
}

// world rotations and places of joints from local rotations
class Tree {
  constructor({ parents, offsets }) {
    Object.assign(this, { parents, offsets });
    this.turned = new Float32Array(4 * parents.length);
    this.places = new Float32Array(3 * parents.length);
  }

  pose(root, rotations) {
    this.parents.forEach((parent, j) => {
      if (parent < 0) this.turned.set(rotations.subarray(4 * j, 4 * j + 4), 4 * j);
      else multiply(this.turned, 4 * parent, rotations, 4 * j, this.turned, 4 * j);
    });
    this.put(root);
  }

  put(root) {
    this.parents.forEach((parent, j) => {
      if (parent < 0) this.places.set(root, 3 * j);
      else place(this.places, 3 * parent, this.turned, 4 * parent, this.offsets[j], this.places, 3 * j);
    });
  }

  middle([left, right]) {
    return [0, 1, 2].map((i) => (this.places[3 * left + i] + this.places[3 * right + i]) / 2);
  }
}

export class Figure extends Body {
  constructor(skeleton, light, plain) {
    super({ ...skeleton, shapes: [] }, [3, 1], light, plain);
    const { mesh } = skeleton, index = decode(mesh.triangles, Uint32Array), tones = decode(mesh.colors, Uint8Array);
    Object.assign(this, { follow: mesh.follow, source: new Tree(skeleton), tree: new Tree(mesh),
                          points: decode(mesh.points, Float32Array), normals: decode(mesh.normals, Float32Array),
                          inverse: decode(mesh.inverse, Float32Array), hosts: decode(mesh.joints, Uint16Array),
                          shares: Float32Array.from(decode(mesh.weights, Uint8Array), (w) => w / 255) });
    this.scale = mesh.follow?.scale ?? 1;
    this.rest = mesh.follow && Float32Array.from(mesh.follow.rest.flat());
    this.matrices = new Float32Array(12 * mesh.parents.length);
    this.tones = Float32Array.from(tones, (v) => (v / 255) ** 2.2);
    const count = this.points.length, attribute = (array, ...more) =>
      new THREE.BufferAttribute(array, 3, ...more).setUsage(THREE.DynamicDrawUsage);
    this.position = attribute(new Float32Array(count));
    this.normal = attribute(new Float32Array(count));
    this.color = plain ? attribute(new Uint8Array(count), true) : attribute(this.tones);
    this.geometry.setIndex(new THREE.BufferAttribute(index, 1));
    this.geometry.setAttribute("position", this.position).setAttribute("color", this.color);
    if (!plain) this.geometry.setAttribute("normal", this.normal);
    this.mesh.material.side = THREE.DoubleSide;
    this.flat.setIndex(new THREE.BufferAttribute(index, 1)).setAttribute("position", this.position);
    this.paint();
  }

  pose(root, rotations) {
    this.source.pose(root, rotations);
    if (this.follow) this.lead();
    const { turned, places } = this.follow ? this.tree : this.source, { inverse, matrices } = this, m = new Float32Array(12);
    for (let j = 0; j < places.length / 3; j++) {
      const w = turned[4 * j], x = turned[4 * j + 1], y = turned[4 * j + 2], z = turned[4 * j + 3];
      m[0] = 1 - 2 * (y * y + z * z), m[1] = 2 * (x * y - w * z), m[2] = 2 * (x * z + w * y), m[3] = places[3 * j];
      m[4] = 2 * (x * y + w * z), m[5] = 1 - 2 * (x * x + z * z), m[6] = 2 * (y * z - w * x), m[7] = places[3 * j + 1];
      m[8] = 2 * (x * z - w * y), m[9] = 2 * (y * z + w * x), m[10] = 1 - 2 * (x * x + y * y), m[11] = places[3 * j + 2];
      for (let row = 0; row < 12; row += 4)
        for (let column = 0; column < 4; column++)
          matrices[12 * j + row + column] = m[row] * inverse[12 * j + column] + m[row + 1] * inverse[12 * j + 4 + column]
            + m[row + 2] * inverse[12 * j + 8 + column] + (column === 3 ? m[row + 3] : 0);
    }
    this.skin();
    this.position.needsUpdate = this.normal.needsUpdate = true;
    if (this.plain) this.paint();
  }

  // the mesh's joints after those of the skeleton
  lead() {
    const { rules, scale, lift, hips } = this.follow, { tree, source, rest } = this, a = new Float32Array(8), led = new Set();
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
    const from = tree.middle(hips[1]), to = source.middle(hips[0]);
    tree.put(to.map((v, i) => scale * v + (i === 1 ? lift : 0) - from[i]));
  }

  skin() {
    const { points, normals, hosts, shares, matrices } = this, position = this.position.array, normal = this.normal.array;
    for (let v = 0, at = 0; at < points.length; v += SLOTS, at += 3) {
      const a = points[at], b = points[at + 1], c = points[at + 2], d = normals[at], e = normals[at + 1], f = normals[at + 2];
      let x = 0, y = 0, z = 0, nx = 0, ny = 0, nz = 0;
      for (let k = v; k < v + SLOTS; k++) {
        const w = shares[k], m = 12 * hosts[k];
        if (w === 0) continue;
        x += w * (matrices[m] * a + matrices[m + 1] * b + matrices[m + 2] * c + matrices[m + 3]);
        y += w * (matrices[m + 4] * a + matrices[m + 5] * b + matrices[m + 6] * c + matrices[m + 7]);
        z += w * (matrices[m + 8] * a + matrices[m + 9] * b + matrices[m + 10] * c + matrices[m + 11]);
        nx += w * (matrices[m] * d + matrices[m + 1] * e + matrices[m + 2] * f);
        ny += w * (matrices[m + 4] * d + matrices[m + 5] * e + matrices[m + 6] * f);
        nz += w * (matrices[m + 8] * d + matrices[m + 9] * e + matrices[m + 10] * f);
      }
      const size = 1 / (Math.hypot(nx, ny, nz) || 1);
      position[at] = x, position[at + 1] = y, position[at + 2] = z;
      normal[at] = nx * size, normal[at + 1] = ny * size, normal[at + 2] = nz * size;
    }
  }

  // feet of a character keep their colour
  setContacts() {}

  paint() {
    if (this.plain && this.tones) this.shade(0, this.tones.length, this.tones);
    this.color.needsUpdate = true;
  }
}
