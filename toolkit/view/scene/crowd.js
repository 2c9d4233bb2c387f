// Many bodies of one skeleton, each with its pose and the colour of its trunk, drawn at once (instanced).
//
// Vertices are posed and lit on the GPU: matrices of the joints are in a texture, a row for each body. The light is that of
// body.js where no lights are drawn. A browser that draws in software is many times faster with a Body for each.
import * as THREE from "three";
import { Body, GROUND, SKY, SUN, trunkOf, Tree, unpack } from "./body.js";

const vector = (values) => `vec3(${values.map((v) => v.toFixed(4)).join(", ")})`;
const POSE = `
uniform highp sampler2D poses;
uniform vec3 lamp;
in vec4 hosts, shares;
vec4 row(int i, int number) {
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 4; k++)
    if (shares[k] > 0.0) sum += shares[k] * texelFetch(poses, ivec2(3 * int(hosts[k]) + number, i), 0);
  return sum;
}
`;
const BODY = `${POSE}
in vec3 tone, trunk, tint;
out vec3 lit;
void main() {
  vec4 a = row(gl_InstanceID, 0), b = row(gl_InstanceID, 1), c = row(gl_InstanceID, 2), at = vec4(position, 1.0);
  vec3 n = normalize(vec3(dot(a.xyz, normal), dot(b.xyz, normal), dot(c.xyz, normal)));
  vec3 light = ${vector(GROUND)} + (0.5 + 0.5 * n.y) * (${vector(SKY)} - ${vector(GROUND)}) + max(dot(n, lamp), 0.0) * ${vector(SUN)};
  lit = pow(min((tone + trunk * tint) * light, 1.0), vec3(1.0 / 2.2));
  gl_Position = projectionMatrix * viewMatrix * vec4(dot(a, at), dot(b, at), dot(c, at), 1.0);
}`;
const FLAT = `${POSE}
void main() {
  vec4 at = vec4(position, 1.0);
  vec3 p = vec3(dot(row(gl_InstanceID, 0), at), dot(row(gl_InstanceID, 1), at), dot(row(gl_InstanceID, 2), at));
  p -= p.y / lamp.y * lamp;
  gl_Position = projectionMatrix * viewMatrix * vec4(p.x, 0.003, p.z, 1.0);
}`;
const LIT = "in vec3 lit; out vec4 color; void main() { color = vec4(lit, 1.0); }";
const SHADE = "uniform vec3 shade; out vec4 color; void main() { color = vec4(shade, 1.0); }";

export class Crowd {
  // tints: for each body what is added to the trunk's colour, in linear light; light: direction towards the lamp
  constructor(skeleton, tints, light, shade) {
    const mesh = unpack(skeleton.mesh), { points, normals, tones, triangles, hosts, shares, inverse } = mesh, count = tints.length;
    Object.assign(this, { inverse, tree: new Tree(skeleton), size: inverse.length });
    this.poses = new THREE.DataTexture(new Float32Array(this.size * count), this.size / 4, count, THREE.RGBAFormat, THREE.FloatType);
    const trunk = Float32Array.from(points, (_, i) => trunkOf(mesh, Math.floor(i / 3))), tint = Float32Array.from(tints.flat());
    this.geometry = new THREE.InstancedBufferGeometry().setIndex(new THREE.BufferAttribute(triangles, 1));
    this.geometry.instanceCount = count;
    const set = (name, array, width) => this.geometry.setAttribute(name, new THREE.BufferAttribute(array, width));
    set("position", points, 3), set("normal", normals, 3), set("tone", tones, 3), set("trunk", trunk, 3), set("shares", shares, 4);
    set("hosts", Float32Array.from(hosts), 4);
    this.geometry.setAttribute("tint", new THREE.InstancedBufferAttribute(tint, 3));
    const uniforms = { poses: { value: this.poses }, lamp: { value: light.clone().normalize() },
                       shade: { value: new THREE.Vector3(...[1, 3, 5].map((i) => parseInt(shade.slice(i, i + 2), 16) / 255)) } };
    this.meshes = [[BODY, LIT, THREE.FrontSide], [FLAT, SHADE, THREE.DoubleSide]].map(([vertexShader, fragmentShader, side]) => {
      const material = new THREE.ShaderMaterial({ vertexShader, fragmentShader, side, uniforms, glslVersion: THREE.GLSL3 });
      const mesh = new THREE.Mesh(this.geometry, material);
      mesh.frustumCulled = false;
      return mesh;
    });
  }

  // poses: [[root, rotations]] of all bodies, as Body.pose takes them
  pose(poses) {
    poses.forEach(([root, rotations], i) => {
      this.tree.pose(root, rotations);
      this.tree.transforms(this.inverse, this.poses.image.data.subarray(this.size * i, this.size * (i + 1)));
    });
    this.poses.needsUpdate = true;
  }

  dispose() {
    this.geometry.dispose();
    this.poses.dispose();
    for (const { material } of this.meshes) material.dispose();
  }
}

// The same with a Body for each, which is lit on the processor.
export class Bodies {
  constructor(skeleton, tints, light, shade) {
    this.bodies = tints.map((tint) => new Body(skeleton, light, true, tint));
    this.meshes = this.bodies.flatMap((body) => [body.mesh, body.shadow(shade)]);
  }

  pose(poses) {
    poses.forEach((pose, i) => this.bodies[i].pose(...pose));
  }

  dispose() {
    for (const body of this.bodies) body.dispose();
  }
}
