// The mannequin: rounded cones whose vertices follow two joints where limbs bend (linear blend skinning).
//
// skeleton = {
//   parents: [J], offsets: [[x, y, z]],         metres, parents before children, Y up
//   shapes: [{joint, place, length, radii: [r0, r1], color, foot, bends: [{joint, place, at, width}]}],
// }
// place: 12 numbers, a 3x4 matrix by rows, from the shape's own frame (first sphere at the origin, second at +Y * length) to the
// joint's. Vertices follow a bend's joint by half at y = at, and wholly at y = at + width.
//
// Vertices are posed here, not on the GPU: this takes 0.3 ms, and a browser that draws in software would take ten times as long.
import * as THREE from "three";

const CONTACT = "#35c46a", RINGS = 4;
// linear light where no lights are drawn (plain): sun, sky and ground, as in view/renderers.py
const SUN = [0.477, 0.467, 0.445], SKY = [0.716, 0.716, 0.716], GROUND = [0.493, 0.468, 0.427];
const GAMMA = Uint8Array.from({ length: 1025 }, (_, i) => 255 * (i / 1024) ** (1 / 2.2));

// Rings of a rounded cone, each [radius, y, normal's radius, normal's y]; more rings where it bends.
function profile({ length, radii: [r0, r1], bends }, caps) {
  const tilt = Math.asin((r0 - r1) / length), c = Math.cos(tilt), s = Math.sin(tilt), rings = [];
  const cap = (from, to, r, y) => {
    for (let i = 0; i <= caps; i++) {
      const a = from + ((to - from) * i) / caps;
      rings.push([r * Math.cos(a), y + r * Math.sin(a), Math.cos(a), Math.sin(a)]);
    }
  };
  cap(-Math.PI / 2, tilt, r0, 0);
  for (let i = 1; bends.length && i <= RINGS; i++) { // denser at the ends
    const t = 0.5 - 0.5 * Math.cos((Math.PI * i) / (RINGS + 1));
    rings.push([(r0 + t * (r1 - r0)) * c, r0 * s + t * (length + (r1 - r0) * s), c, s]);
  }
  cap(tilt, Math.PI / 2, r1, length);
  return rings;
}

// 3x4 matrices by rows, at places i, j, k of flat arrays: c[k] = a[i] b[j]
function multiply(a, i, b, j, c, k) {
  for (let row = 0; row < 12; row += 4)
    for (let column = 0; column < 4; column++)
      c[k + row + column] = a[i + row] * b[j + column] + a[i + row + 1] * b[j + 4 + column] + a[i + row + 2] * b[j + 8 + column]
        + (column === 3 ? a[i + row + 3] : 0);
}

export class Body {
  // detail: [vertices around, rings in a cap]; light: direction towards the lamp; plain: light is computed here, not by WebGL
  constructor(skeleton, detail, light, plain) {
    const [around, caps] = detail, index = [], coarse = [];
    Object.assign(this, { skeleton, plain, light: light.clone().normalize(), touching: {}, scale: 1 }); // scale of its path
    this.world = new Float32Array(12 * skeleton.parents.length);
    this.local = new Float32Array(12);
    let vertices = 0;
    this.parts = skeleton.shapes.map((shape) => {
      const rings = profile(shape, caps), first = vertices, count = rings.length * around;
      const hosts = [{ joint: shape.joint, place: shape.place }, ...shape.bends];
      const thin = Math.hypot(shape.place[2], shape.place[6], shape.place[10]); // normals are transformed by the inverse transpose
      const points = new Float32Array(4 * hosts.length * count), normals = new Float32Array(3 * hosts.length * count);
      rings.forEach(([x, y, nx, ny], i) => {
        const given = shape.bends.map(({ at, width }) => {
          const t = Math.min(Math.max(0.5 + (0.5 * (y - at)) / width, 0), 1);
          return t * t * (3 - 2 * t);
        });
        const shares = [1 - given.reduce((sum, w) => sum + w, 0), ...given];
        for (let k = 0; k < around; k++) {
          const c = Math.cos((2 * Math.PI * k) / around), s = Math.sin((2 * Math.PI * k) / around), v = i * around + k;
          shares.forEach((w, h) => {
            points.set([w * x * c, w * y, w * x * s, w], 4 * (hosts.length * v + h));
            normals.set([w * nx * c, w * ny, (w * nx * s) / thin ** 2], 3 * (hosts.length * v + h));
          });
          if (i + 1 === rings.length) continue;
          const a = first + v, b = first + i * around + ((k + 1) % around);
          index.push(a, a + around, b, b, a + around, b + around);
        }
      });
      for (let i = 0; i + 1 < rings.length; i = next(i)) // every other vertex of some rings, for the shadow
        for (let k = 0; k < around; k += 2) {
          const a = first + i * around + k, b = first + i * around + ((k + 2) % around), up = (next(i) - i) * around;
          coarse.push(a, a + up, b, b, a + up, b + up);
        }
      function next(i) {
        return i === 0 ? caps : i < rings.length - 1 - caps ? rings.length - 1 - caps : rings.length - 1;
      }
      vertices += count;
      const places = hosts.map(({ place }) => Float32Array.from(place)), joints = hosts.map(({ joint }) => joint);
      const tones = [shape.color, CONTACT].map((color) => new THREE.Color(color).toArray().map((v) => (plain ? v ** 2.2 : v)));
      return { foot: shape.foot, first, count, joints, places, points, normals, tones, matrices: places.map(() => new Float32Array(12)) };
    });
    const attribute = (array, ...more) => new THREE.BufferAttribute(array, 3, ...more).setUsage(THREE.DynamicDrawUsage);
    this.geometry = new THREE.BufferGeometry().setIndex(index);
    this.position = attribute(new Float32Array(3 * vertices));
    this.normal = attribute(new Float32Array(3 * vertices));
    this.color = plain ? attribute(new Uint8Array(3 * vertices), true) : attribute(new Float32Array(3 * vertices));
    this.geometry.setAttribute("position", this.position).setAttribute("color", this.color);
    if (!plain) this.geometry.setAttribute("normal", this.normal);
    const material = plain ? new THREE.MeshBasicMaterial({ vertexColors: true, fog: false })
      : new THREE.MeshStandardMaterial({ vertexColors: true, roughness: 0.62, metalness: 0.0 });
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.castShadow = this.mesh.receiveShadow = true;
    this.flat = new THREE.BufferGeometry().setIndex(coarse).setAttribute("position", this.position);
    this.paint();
  }

  // A coarse body projected onto the floor along the light: a cheap shadow.
  shadow(color) {
    const { x, y, z } = this.light, mesh = new THREE.Mesh(this.flat, new THREE.MeshBasicMaterial({ color, fog: false }));
    mesh.frustumCulled = mesh.matrixAutoUpdate = false;
    mesh.matrix.set(1, -x / y, 0, 0, 0, 0, 0, 0.003, 0, -z / y, 1, 0, 0, 0, 0, 1);
    return mesh;
  }

  // root [3] metres, rotations [J * 4] local unit quaternions w, x, y, z
  pose(root, rotations) {
    const { parents, offsets } = this.skeleton, m = this.local;
    for (let j = 0; j < parents.length; j++) {
      const w = rotations[4 * j], x = rotations[4 * j + 1], y = rotations[4 * j + 2], z = rotations[4 * j + 3];
      const [px, py, pz] = parents[j] < 0 ? root : offsets[j];
      m[0] = 1 - 2 * (y * y + z * z), m[1] = 2 * (x * y - w * z), m[2] = 2 * (x * z + w * y), m[3] = px;
      m[4] = 2 * (x * y + w * z), m[5] = 1 - 2 * (x * x + z * z), m[6] = 2 * (y * z - w * x), m[7] = py;
      m[8] = 2 * (x * z - w * y), m[9] = 2 * (y * z + w * x), m[10] = 1 - 2 * (x * x + y * y), m[11] = pz;
      if (parents[j] < 0) this.world.set(m, 12 * j);
      else multiply(this.world, 12 * parents[j], m, 0, this.world, 12 * j);
    }
    for (const part of this.parts) this.bend(part);
    this.position.needsUpdate = this.normal.needsUpdate = true;
    if (this.plain) this.paint();
  }

  // vertices and normals of a part: the sum over its joints
  bend({ first, count, joints, places, points, normals, matrices }) {
    const position = this.position.array, normal = this.normal.array, n = joints.length;
    for (let h = 0; h < n; h++) multiply(this.world, 12 * joints[h], places[h], 0, matrices[h], 0);
    for (let v = 0, p = 0, q = 0, at = 3 * first; v < count; v++, at += 3) {
      let x = 0, y = 0, z = 0, nx = 0, ny = 0, nz = 0;
      for (let h = 0; h < n; h++, p += 4, q += 3) {
        const m = matrices[h], w = points[p + 3];
        if (w === 0) continue;
        const a = points[p], b = points[p + 1], c = points[p + 2], d = normals[q], e = normals[q + 1], f = normals[q + 2];
        x += m[0] * a + m[1] * b + m[2] * c + m[3] * w;
        y += m[4] * a + m[5] * b + m[6] * c + m[7] * w;
        z += m[8] * a + m[9] * b + m[10] * c + m[11] * w;
        nx += m[0] * d + m[1] * e + m[2] * f;
        ny += m[4] * d + m[5] * e + m[6] * f;
        nz += m[8] * d + m[9] * e + m[10] * f;
      }
      const size = 1 / (Math.sqrt(nx * nx + ny * ny + nz * nz) || 1);
      position[at] = x, position[at + 1] = y, position[at + 2] = z;
      normal[at] = nx * size, normal[at + 1] = ny * size, normal[at + 2] = nz * size;
    }
  }

  // {left: bool, right: bool}: standing feet have their own colour
  setContacts(contacts) {
    const same = ["left", "right"].every((foot) => !!this.touching[foot] === !!contacts[foot]);
    this.touching = { ...contacts };
    if (!same && !this.plain) this.paint(); // with plain, every pose is painted
  }

  // colours of all vertices; with plain also their light: matt, with light from sky, floor and one lamp
  paint() {
    for (const { foot, first, count, tones } of this.parts) {
      const tone = tones[Number(!!this.touching[foot])], end = 3 * (first + count);
      if (this.plain) this.shade(3 * first, end, tone);
      else for (let i = 3 * first; i < end; i += 3) this.color.array.set(tone, i);
    }
    this.color.needsUpdate = true;
  }

  // light on the vertices whose numbers are at `from` up to `end`; tones are one colour or one for each, in linear light
  shade(from, end, tones) {
    const color = this.color.array, normal = this.normal.array, { x, y, z } = this.light, step = tones.length > 3 ? 3 : 0;
    for (let i = from, at = 0; i < end; i += 3, at += step) {
      const up = 0.5 + 0.5 * normal[i + 1], lamp = Math.max(normal[i] * x + normal[i + 1] * y + normal[i + 2] * z, 0);
      for (let k = 0; k < 3; k++)
        color[i + k] = GAMMA[Math.min(1024 * tones[at + k] * (GROUND[k] + up * (SKY[k] - GROUND[k]) + lamp * SUN[k]), 1024) | 0];
    }
  }

  dispose() {
    this.geometry.dispose();
    this.flat.dispose();
  }
}
