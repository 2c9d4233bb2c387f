// Body, floor, light and camera. Scene(element, skeleton) draws one mannequin; setPose moves it.
//
// skeleton = {
//   parents: [J], offsets: [[x, y, z]],         metres, parents before children, Y up
//   shapes: [{joint, place: [12 numbers: a 3x4 matrix by rows], length, radii: [r0, r1], color, foot}],
// }
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const SKY = 0xf3f1ec, FLOOR = "#eae6de", GRID = "#d8d3c8", CONTACT = new THREE.Color("#35c46a");
const SHADE = 0xcdc8be;

// does this browser draw on the processor?
function drawsInSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = info ? String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
let software; // found out when the first scene is made

// Rounded cone: the hull of a sphere r0 at the origin and r1 at +Y * length. Turned about Y, then placed in a joint's frame.
function coneGeometry({ length, radii: [r0, r1], place }, [around, along]) {
  const tilt = Math.asin((r0 - r1) / length), profile = [];
  for (const [from, to, r, y] of [[-Math.PI / 2, tilt, r0, 0], [tilt, Math.PI / 2, r1, length]])
    for (let i = 0; i <= along; i++) {
      const a = from + ((to - from) * i) / along;
      profile.push([r * Math.cos(a), y + r * Math.sin(a), Math.cos(a), Math.sin(a)]);
    }
  const position = [], normal = [], index = [];
  profile.forEach(([x, y, nx, ny], i) => {
    for (let k = 0; k < around; k++) {
      const c = Math.cos((2 * Math.PI * k) / around), s = Math.sin((2 * Math.PI * k) / around);
      position.push(x * c, y, x * s);
      normal.push(nx * c, ny, nx * s);
      if (i + 1 < profile.length) {
        const a = i * around + k, b = i * around + ((k + 1) % around);
        index.push(a, a + around, b, b, a + around, b + around);
      }
    }
  });
  const matrix = new THREE.Matrix4().set(...place, 0, 0, 0, 1);
  const toNormal = new THREE.Matrix3().getNormalMatrix(matrix), v = new THREE.Vector3();
  for (let i = 0; i < position.length; i += 3) {
    v.fromArray(position, i).applyMatrix4(matrix).toArray(position, i);
    v.fromArray(normal, i).applyMatrix3(toNormal).normalize().toArray(normal, i);
  }
  return { position, normal, index };
}

// All shapes as one skinned mesh, each vertex bound to one joint and stored in that joint's frame (so inverses are identity).
function mannequin(skeleton, joints, detail) {
  const position = [], normal = [], color = [], skinIndex = [], skinWeight = [], index = [], feet = [];
  for (const shape of skeleton.shapes) {
    const part = coneGeometry(shape, detail), first = position.length / 3, count = part.position.length / 3;
    const tone = new THREE.Color(shape.color);
    position.push(...part.position);
    normal.push(...part.normal);
    index.push(...part.index.map((i) => i + first));
    for (let i = 0; i < count; i++) {
      color.push(tone.r, tone.g, tone.b);
      skinIndex.push(shape.joint, 0, 0, 0);
      skinWeight.push(1, 0, 0, 0);
    }
    if (shape.foot) feet.push({ foot: shape.foot, first, count, tone });
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex(index);
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(position, 3));
  geometry.setAttribute("normal", new THREE.Float32BufferAttribute(normal, 3));
  geometry.setAttribute("color", new THREE.Float32BufferAttribute(color, 3));
  geometry.setAttribute("skinIndex", new THREE.Uint16BufferAttribute(skinIndex, 4));
  geometry.setAttribute("skinWeight", new THREE.Float32BufferAttribute(skinWeight, 4));
  const material = new THREE.MeshStandardMaterial({ vertexColors: true, roughness: 0.62, metalness: 0.0 });
  const mesh = new THREE.SkinnedMesh(geometry, material);
  mesh.bind(new THREE.Skeleton(joints, joints.map(() => new THREE.Matrix4())), new THREE.Matrix4());
  mesh.bindMode = THREE.DetachedBindMode;
  mesh.frustumCulled = false;
  mesh.castShadow = mesh.receiveShadow = true;
  return { mesh, feet };
}

// A coarse body pressed flat onto the floor along the light: a shadow that costs next to nothing.
function pressed(skeleton, body, { x, y, z }) {
  const { mesh: coarse } = mannequin(skeleton, body.skeleton.bones, [6, 1]);
  const mesh = new THREE.SkinnedMesh(coarse.geometry, new THREE.MeshBasicMaterial({ color: SHADE, fog: false }));
  mesh.bind(body.skeleton, new THREE.Matrix4());
  mesh.bindMode = THREE.DetachedBindMode;
  mesh.frustumCulled = mesh.matrixAutoUpdate = mesh.visible = false;
  mesh.matrix.set(1, -x / y, 0, 0, 0, 0, 0, 0.003, 0, -z / y, 1, 0, 0, 0, 0, 1);
  return mesh;
}

function floorTexture(anisotropy) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 256;
  const g = canvas.getContext("2d");
  g.fillStyle = FLOOR;
  g.fillRect(0, 0, 256, 256);
  g.strokeStyle = GRID;
  g.lineWidth = 5;
  g.strokeRect(0, 0, 256, 256);
  g.lineWidth = 1.5;
  g.beginPath();
  g.moveTo(128, 0), g.lineTo(128, 256), g.moveTo(0, 128), g.lineTo(256, 128);
  g.stroke();
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.repeat.set(60, 60); // one tile per metre
  texture.anisotropy = anisotropy;
  return texture;
}

// A band every metre, in a plane's own frame: much cheaper in software than lines or a texture.
function grid(size, width = 0.03) {
  const position = [], index = [];
  for (let i = -size / 2; i <= size / 2; i++)
    for (const [x, y, u, v] of [[i, 0, width, size], [0, i, size, width]]) {
      const n = position.length / 3;
      for (const [a, b] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) position.push(x + (a * u) / 2, y + (b * v) / 2, 0.002);
      index.push(n, n + 1, n + 2, n, n + 2, n + 3);
    }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(position, 3));
  geometry.setIndex(index);
  return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ color: GRID }));
}

// A flat band on the floor along points [n * 3]; drawn up to a frame with setDrawRange.
function ribbon(points, width, height, color, opacity) {
  const n = points.length / 3, position = new Float32Array(n * 6), index = [];
  let side = [width / 2, 0];
  for (let i = 0; i < n; i++) {
    const a = 3 * Math.max(i - 1, 0), b = 3 * Math.min(i + 1, n - 1);
    const dx = points[b] - points[a], dz = points[b + 2] - points[a + 2], d = Math.hypot(dx, dz);
    if (d > 1e-4) side = [(dz / d) * (width / 2), (-dx / d) * (width / 2)];
    position.set([points[3 * i] + side[0], height, points[3 * i + 2] + side[1],
                  points[3 * i] - side[0], height, points[3 * i + 2] - side[1]], 6 * i);
    if (i) index.push(2 * i - 2, 2 * i, 2 * i - 1, 2 * i - 1, 2 * i, 2 * i + 1);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
  geometry.setIndex(index);
  const material = new THREE.MeshBasicMaterial({ color, opacity, transparent: true, side: THREE.DoubleSide, depthWrite: false });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

export class Scene {
  constructor(element, skeleton, { facing = 0, distance = 3.6, height = 0.95 } = {}) {
    this.element = element;
    this.skeleton = skeleton;
    software ??= drawsInSoftware();
    this.renderer = new THREE.WebGLRenderer({ antialias: !software, powerPreference: "high-performance" });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.canvas = this.renderer.domElement;
    element.append(this.canvas);

    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(SKY);
    this.scene.fog = new THREE.Fog(SKY, 7, 19);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0xd8d3cb, 2.25));
    this.light = new THREE.Vector3(2.7 * Math.sin(facing - 0.15), 5.2, 2.7 * Math.cos(facing - 0.15));
    this.sun = new THREE.DirectionalLight(0xfffaf2, 1.5);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.radius = 3;
    this.sun.shadow.bias = -0.0004;
    this.sun.shadow.normalBias = 0.03;
    Object.assign(this.sun.shadow.camera, { left: -1.8, right: 1.8, top: 1.8, bottom: -1.8, near: 1, far: 12 });
    this.scene.add(this.sun, this.sun.target);

    const look = software ? { color: FLOOR } : { map: floorTexture(this.renderer.capabilities.getMaxAnisotropy()) };
    this.floor = new THREE.Mesh(new THREE.PlaneGeometry(60, 60), new THREE.MeshBasicMaterial(look));
    this.floor.rotation.x = -Math.PI / 2;
    if (software) this.floor.add(grid(40)); // there, a textured floor takes longer than all the rest
    this.shade = new THREE.Mesh(new THREE.PlaneGeometry(6, 6), new THREE.ShadowMaterial({ opacity: 0.22, depthWrite: false }));
    this.shade.position.z = 0.001;
    this.shade.receiveShadow = true;
    this.floor.add(this.shade);
    this.scene.add(this.floor);

    this.joints = skeleton.parents.map(() => new THREE.Bone());
    skeleton.parents.forEach((p, j) => {
      (p < 0 ? this.scene : this.joints[p]).add(this.joints[j]);
      this.joints[j].position.fromArray(skeleton.offsets[j]);
    });
    const { mesh, feet } = mannequin(skeleton, this.joints, software ? [10, 2] : [24, 6]);
    this.body = mesh;
    this.feet = feet;
    this.touching = {};
    this.flat = pressed(skeleton, mesh, this.light);
    this.scene.add(mesh, this.flat);

    this.camera = new THREE.PerspectiveCamera(36, 1, 0.1, 60);
    this.controls = new OrbitControls(this.camera, this.canvas);
    Object.assign(this.controls, { enablePan: false, minDistance: 1.2, maxDistance: 12, maxPolarAngle: 1.55,
                                   enableDamping: true, dampingFactor: 0.15 });
    this.facing = facing;
    this.controls.target.set(0, height, 0);
    const turn = facing - 0.9;
    this.camera.position.set(Math.sin(turn) * distance, height + 0.55, Math.cos(turn) * distance);
    this.quality = 0;
    this.setQuality(software ? 2 : 0);
    this.observer = new ResizeObserver(() => { this.resize(); this.render(); });
    this.observer.observe(element);
  }

  // root [3] metres, rotations [J * 4] local unit quaternions w, x, y, z
  setPose(root, rotations) {
    this.joints[0].position.set(root[0], root[1], root[2]);
    for (let j = 0; j < this.joints.length; j++)
      this.joints[j].quaternion.set(rotations[4 * j + 1], rotations[4 * j + 2], rotations[4 * j + 3], rotations[4 * j]);
  }

  // {left: bool, right: bool}: feet that stand are coloured
  setContacts(contacts) {
    const attribute = this.body.geometry.attributes.color;
    for (const { foot, first, count, tone } of this.feet) {
      if (!!this.touching[foot] === !!contacts[foot]) continue;
      const c = contacts[foot] ? CONTACT : tone;
      for (let i = first; i < first + count; i++) attribute.setXYZ(i, c.r, c.g, c.b);
      attribute.needsUpdate = true;
    }
    this.touching = { ...contacts };
  }

  // the path on the floor, points [F * 3]; null removes it
  setTrail(points) {
    for (const mesh of this.trail ?? []) {
      this.scene.remove(mesh);
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    this.trail = points && [ribbon(points, 0.018, 0.004, "#8d8678", 0.35), ribbon(points, 0.03, 0.006, "#7b68c4", 0.9)];
    if (this.trail) this.scene.add(...this.trail);
  }

  // the walked part of the path, up to a frame
  showTrail(frame, visible = true) {
    if (!this.trail) return;
    for (const mesh of this.trail) mesh.visible = visible;
    this.trail[1].geometry.setDrawRange(0, 6 * Math.max(0, Math.floor(frame)));
  }

  // camera, light and floor go along with a point on the floor; jump: at once
  follow(x, z, { smooth = 0.12, jump = false, camera = true } = {}) {
    const target = this.controls.target, k = jump ? 1 : smooth;
    if (camera) {
      const dx = (x - target.x) * k, dz = (z - target.z) * k;
      target.x += dx, target.z += dz;
      this.camera.position.x += dx, this.camera.position.z += dz;
    }
    this.floor.position.set(Math.round(target.x), 0, Math.round(target.z));
    this.sun.target.position.set(x, 0.6, z);
    this.sun.position.copy(this.light).add(this.sun.target.position);
  }

  // same viewpoint as another scene, relative to where each body faces at first
  lookLike(other) {
    this.camera.position.copy(other.camera.position).sub(other.controls.target)
      .applyAxisAngle(this.camera.up, this.facing - other.facing).add(this.controls.target);
  }

  // 0 finest, 1 no fine pixels, 2 plain light and a pressed shadow, 3 coarse pixels: for machines that draw in software
  setQuality(level) {
    if (level >= 2 && this.quality < 2) {
      this.renderer.shadowMap.enabled = this.sun.castShadow = this.shade.visible = false;
      this.body.material = new THREE.MeshLambertMaterial({ vertexColors: true });
      this.flat.visible = true;
    }
    this.quality = level;
    this.resize();
  }

  resize() {
    const { clientWidth: w, clientHeight: h } = this.element;
    if (!w || !h) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, this.quality ? 1 : 2) * (this.quality > 2 ? 0.6 : 1));
    this.renderer.setSize(w, h, true);
    this.camera.aspect = w / h;
    this.camera.fov = w < h ? Math.min(36 * (h / w) ** 0.7, 60) : 36;
    this.camera.updateProjectionMatrix();
  }

  render() {
    this.controls.update();
    this.renderer.render(this.scene, this.camera);
  }

  dispose() {
    this.observer.disconnect();
    this.controls.dispose();
    this.setTrail(null);
    this.body.geometry.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.canvas.remove();
  }
}
