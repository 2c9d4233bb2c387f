// A body: one skinned surface over the joints of a skeleton (linear blend skinning; view/render/skin.py).
//
// skeleton = {parents: [J], offsets: [[x, y, z]], metres, parents before children, Y up, mesh}
// mesh = {
//   parents: [K], offsets,                       its own joints; those of the skeleton where `follow` is null
//   inverse: float32 [K * 12]                    inverse world transforms of the joints in the bind pose, 3x4 by rows
//   points: uint16 [V * 3], from `low` [3] over `size` [3] metres;  normals: int8 [V * 3];  triangles: uint16 [T * 3], uint32 of
//   more than 65535 vertices;  joints: uint8 [V * 4], uint16 of 256 joints or more;  weights: uint8 [V * 4] with sum 255
//   colors: uint8 [V * 3];  marks: uint8 [V * 4], none or shares of the left foot, the right foot and the trunk's colour, and the
//   ambient light that is in the colour;  all base64
//   follow: see figure.js
// }
// Vertices are posed here, not on the GPU: this takes 0.3 ms, and a browser that draws in software would take ten times as long.
import * as THREE from "three";
import { decode } from "./numbers.js";

const CONTACT = [0x35, 0xc4, 0x6a].map((v) => (v / 255) ** 2.2), SLOTS = 4, MARKS = 4;
// linear light where no lights are drawn (plain): sun, sky and ground, as in view/render/stage.py
export const SUN = [0.477, 0.467, 0.445], SKY = [0.716, 0.716, 0.716], GROUND = [0.493, 0.468, 0.427];
const GAMMA = Uint8Array.from({ length: 1025 }, (_, i) => 255 * (i / 1024) ** (1 / 2.2));

// quaternions w, x, y, z at places of flat arrays: c[k] = a[i] b[j]
export function multiply(a, i, b, j, c, k) {
  const aw = a[i], ax = a[i + 1], ay = a[i + 2], az = a[i + 3], bw = b[j], bx = b[j + 1], by = b[j + 2], bz = b[j + 3];
  c[k] = aw * bw - ax * bx - ay * by - az * bz;
  c[k + 1] = aw * bx + ax * bw + ay * bz - az * by;
  c[k + 2] = aw * by - ax * bz + ay * bw + az * bx;
  c[k + 3] = aw * bz + ax * by - ay * bx + az * bw;
}

// c[k] = a[i] + the vector turned by the quaternion at q[j]
function place(a, i, q, j, [x, y, z], c, k) {
  const w = q[j], u = q[j + 1], v = q[j + 2], n = q[j + 3];
  const tx = 2 * (v * z - n * y), ty = 2 * (n * x - u * z), tz = 2 * (u * y - v * x);
  c[k] = a[i] + x + w * tx + v * tz - n * ty;
  c[k + 1] = a[i + 1] + y + w * ty + n * tx - u * tz;
  c[k + 2] = a[i + 2] + z + w * tz + u * ty - v * tx;
}

// world rotations and places of joints
export class Tree {
  constructor({ parents, offsets }) {
    Object.assign(this, { parents, offsets });
    this.turned = new Float32Array(4 * parents.length);
    this.places = new Float32Array(3 * parents.length);
  }

  // from local rotations [J * 4]
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

  // transforms from the bind pose, 3x4 by rows, one joint after the other
  transforms(inverse, matrices) {
    const { turned, places } = this, m = new Float32Array(12);
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
  }
}

// the arrays of a mesh
export function unpack(mesh) {
  const { low, size } = mesh, marks = decode(mesh.marks, Uint8Array), normals = decode(mesh.normals, Int8Array);
  const points = Float32Array.from(decode(mesh.points, Uint16Array), (v, i) => low[i % 3] + (size[i % 3] * v) / 65535);
  const tones = Float32Array.from(decode(mesh.colors, Uint8Array), (v) => (v / 255) ** 2.2);
  return { points, tones, marks, inverse: decode(mesh.inverse, Float32Array), normals: Float32Array.from(normals, (v) => v / 127),
           triangles: decode(mesh.triangles, points.length > 3 * 65535 ? Uint32Array : Uint16Array),
           hosts: decode(mesh.joints, mesh.parents.length < 256 ? Uint8Array : Uint16Array),
           shares: Float32Array.from(decode(mesh.weights, Uint8Array), (w) => w / 255) };
}

// how much of a vertex's colour is that of the trunk, with its ambient light, linear
export const trunkOf = ({ marks }, v) => (marks[MARKS * v + 2] / 255) * (marks[MARKS * v + 3] / 255) ** 2.2;

// Fewer triangles, for a shadow: vertices of a cell in the bind pose become one of them.
function coarse(points, triangles, cell = 0.06) {
  const first = new Map(), kept = [];
  const of = (v) => {
    const key = [0, 1, 2].map((i) => Math.round(points[3 * v + i] / cell)).join();
    if (!first.has(key)) first.set(key, v);
    return first.get(key);
  };
  const merged = Uint32Array.from({ length: points.length / 3 }, (_, v) => of(v)), seen = new Set();
  for (let i = 0; i < triangles.length; i += 3) {
    const corners = [...triangles.subarray(i, i + 3)].map((v) => merged[v]), key = [...corners].sort().join();
    if (new Set(corners).size < 3 || seen.has(key)) continue;
    seen.add(key);
    kept.push(...corners);
  }
  return kept;
}

export class Body {
  // light: direction towards the lamp; plain: light is computed here, not by WebGL; tint [3]: added to the trunk, linear
  constructor(skeleton, light, plain, tint) {
    Object.assign(this, { skeleton, plain, light: light.clone().normalize(), touching: {}, scale: 1, ...unpack(skeleton.mesh) });
    this.tree = new Tree(skeleton); // scale: of its path
    this.matrices = new Float32Array(this.inverse.length);
    if (tint) this.tones.forEach((_, i) => (this.tones[i] += tint[i % 3] * trunkOf(this, Math.floor(i / 3))));
    const count = this.points.length, index = new THREE.BufferAttribute(this.triangles, 1);
    const attribute = (array, ...more) => new THREE.BufferAttribute(array, 3, ...more).setUsage(THREE.DynamicDrawUsage);
    this.geometry = new THREE.BufferGeometry().setIndex(index);
    this.position = attribute(new Float32Array(count));
    this.normal = attribute(new Float32Array(count));
    this.shown = this.tones.slice();
    this.color = plain ? attribute(new Uint8Array(count), true) : attribute(this.shown);
    this.geometry.setAttribute("position", this.position).setAttribute("color", this.color);
    if (!plain) this.geometry.setAttribute("normal", this.normal);
    const material = plain ? new THREE.MeshBasicMaterial({ vertexColors: true, fog: false })
      : new THREE.MeshStandardMaterial({ vertexColors: true, roughness: 0.62, metalness: 0.0 });
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.castShadow = this.mesh.receiveShadow = true;
    this.flat = new THREE.BufferGeometry().setIndex(coarse(this.points, this.triangles)).setAttribute("position", this.position);
    this.paint();
  }

  // The body projected onto the floor along the light: a cheap shadow.
  shadow(color) {
    const { x, y, z } = this.light, material = new THREE.MeshBasicMaterial({ color, fog: false, side: THREE.DoubleSide });
    const mesh = new THREE.Mesh(this.flat, material);
    mesh.frustumCulled = mesh.matrixAutoUpdate = false;
    mesh.matrix.set(1, -x / y, 0, 0, 0, 0, 0, 0.003, 0, -z / y, 1, 0, 0, 0, 0, 1);
    return mesh;
  }

  // root [3] metres, rotations [J * 4] local unit quaternions w, x, y, z
  pose(root, rotations) {
    this.tree.pose(root, rotations);
    this.skin(this.tree);
  }

  // vertices and normals: the sum over their joints
  skin(tree) {
    const { points, normals, hosts, shares, matrices } = this, position = this.position.array, normal = this.normal.array;
    tree.transforms(this.inverse, matrices);
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
      const size = 1 / (Math.sqrt(nx * nx + ny * ny + nz * nz) || 1);
      position[at] = x, position[at + 1] = y, position[at + 2] = z;
      normal[at] = nx * size, normal[at + 1] = ny * size, normal[at + 2] = nz * size;
    }
    this.position.needsUpdate = this.normal.needsUpdate = true;
    if (this.plain) this.shade();
  }

  // {left: bool, right: bool}: standing feet have their own colour
  setContacts(contacts) {
    const same = ["left", "right"].every((foot) => !!this.touching[foot] === !!contacts[foot]);
    this.touching = { ...contacts };
    if (!same) this.paint();
  }

  // colours of all vertices
  paint() {
    const { tones, shown, marks, touching: { left, right } } = this;
    shown.set(tones);
    for (let m = 0, i = 0; m < marks.length; m += MARKS, i += 3) {
      const share = (left ? marks[m] : 0) + (right ? marks[m + 1] : 0), light = (marks[m + 3] / 255) ** 2.2;
      if (share) for (let k = 0; k < 3; k++) shown[i + k] += (share / 255) * (light * CONTACT[k] - shown[i + k]);
    }
    if (this.plain) this.shade();
    this.color.needsUpdate = true;
  }

  // light on all vertices: matt, with light from sky, floor and one lamp
  shade() {
    const { shown } = this, color = this.color.array, normal = this.normal.array, { x, y, z } = this.light;
    for (let i = 0; i < color.length; i += 3) {
      const up = 0.5 + 0.5 * normal[i + 1], lamp = Math.max(normal[i] * x + normal[i + 1] * y + normal[i + 2] * z, 0);
      for (let k = 0; k < 3; k++)
        color[i + k] = GAMMA[Math.min(1024 * shown[i + k] * (GROUND[k] + up * (SKY[k] - GROUND[k]) + lamp * SUN[k]), 1024) | 0];
    }
    this.color.needsUpdate = true;
  }

  dispose() {
    this.geometry.dispose();
    this.flat.dispose();
  }
}
