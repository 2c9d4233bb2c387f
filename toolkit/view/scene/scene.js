// Body, floor, light and camera. Scene(element, skeleton) draws one mannequin (see body.js); setPose moves it.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Body } from "./body.js";
import { Bodies, Crowd } from "./crowd.js";
import { Figure } from "./figure.js";

const SKY = "#f3f1ec", FLOOR = "#eae6de", GRID = "#d8d3c8", SHADE = "#cdc8be", PLAIN = { back: "#efece6", line: "#cbc5b9" };

// whether this browser draws on the processor
function drawsInSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = info ? String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
let software; // known once the first scene is made

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

// The floor where the processor draws: bands every metre that fade into a background of the floor's colour. A floor that fills
// the picture would take longer than everything else.
function plainFloor(reach = 13, width = 0.03) {
  const position = [], color = [], index = [], line = new THREE.Color(PLAIN.line), back = new THREE.Color(PLAIN.back);
  for (let i = 1 - reach; i < reach; i++)
    for (let j = -reach; j < reach; j += 2)
      for (const [x, y, u, v] of [[i, j + 1, width, 2], [j + 1, i, 2, width]]) {
        if (Math.hypot(x, y) > reach) continue;
        const n = position.length / 3;
        index.push(n, n + 1, n + 2, n, n + 2, n + 3);
        for (const [a, b] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
          const corner = [x + (a * u) / 2, y + (b * v) / 2, 0], far = Math.min(Math.hypot(...corner) / reach, 1);
          position.push(...corner);
          line.clone().lerp(back, far ** 0.7).toArray(color, color.length);
        }
      }
  const geometry = new THREE.BufferGeometry().setIndex(index);
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(position, 3));
  geometry.setAttribute("color", new THREE.Float32BufferAttribute(color, 3));
  return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ vertexColors: true, fog: false }));
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
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("webgl2", { alpha: false, antialias: !software, powerPreference: "high-performance" });
    this.renderer = new THREE.WebGLRenderer({ canvas, context });
    if (software) { // colours reach the screen unchanged
      THREE.ColorManagement.enabled = false;
      this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    }
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.canvas = this.renderer.domElement;
    element.append(this.canvas);

    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(software ? PLAIN.back : SKY);
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

    const map = software ? null : floorTexture(this.renderer.capabilities.getMaxAnisotropy());
    this.floor = software ? plainFloor() : new THREE.Mesh(new THREE.PlaneGeometry(60, 60), new THREE.MeshBasicMaterial({ map }));
    this.floor.rotation.x = -Math.PI / 2;
    this.shade = new THREE.Mesh(new THREE.PlaneGeometry(6, 6), new THREE.ShadowMaterial({ opacity: 0.22, depthWrite: false }));
    this.shade.position.z = 0.001;
    this.shade.receiveShadow = true;
    this.floor.add(this.shade);
    this.scene.add(this.floor);

    this.bodies = [];
    this.body = this.add();

    this.camera = new THREE.PerspectiveCamera(36, 1, 0.1, 60);
    this.controls = new OrbitControls(this.camera, this.canvas);
    Object.assign(this.controls, { enablePan: false, minDistance: 1.2, maxDistance: 12, maxPolarAngle: 1.55,
                                   enableDamping: true, dampingFactor: 0.15 });
    this.facing = facing;
    this.controls.target.set(0, height, 0);
    const turn = facing - 0.9;
    this.camera.position.set(Math.sin(turn) * distance, height + 0.55, Math.cos(turn) * distance);
    this.still = false;
    this.setQuality(software ? 2 : 0);
    this.observer = new ResizeObserver(() => { this.resize(); this.render(this); });
    this.observer.observe(element);
  }

  // One more body like the first; a ghost is pale and has no shadow. `show` hides it again.
  add({ ghost = false } = {}) {
    const { skeleton } = this;
    const body = new (skeleton.mesh.own ? Figure : Body)(skeleton, this.light, software);
    this.bodies.push(body);
    this.scene.add(body.mesh);
    if (ghost) {
      Object.assign(body.mesh.material, { transparent: true, opacity: 0.35 });
      body.mesh.castShadow = false;
      const depth = new THREE.Mesh(body.mesh.geometry, new THREE.MeshBasicMaterial({ colorWrite: false, transparent: true }));
      depth.frustumCulled = false; // only the nearest surface of a ghost is seen
      [depth.renderOrder, body.mesh.renderOrder] = [1, 2];
      body.mesh.add(depth);
    } else this.scene.add((body.projected = body.shadow(SHADE)));
    this.show(body, true);
    return body;
  }

  show(body, on) {
    body.mesh.visible = on;
    if (body.projected) body.projected.visible = on && this.quality >= 2;
  }

  setPose(root, rotations) {
    this.body.pose(root, rotations);
  }

  setContacts(contacts) {
    this.body.setContacts(contacts);
  }

  // more bodies, of one skeleton, in colours of their own
  addCrowd(skeleton, tints) {
    this.crowd = new (software ? Bodies : Crowd)(skeleton, tints, this.light, SHADE);
    this.scene.add(...this.crowd.meshes);
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

  // small balls at places [x, y, z]
  setMarks(places) {
    const marks = (this.marks ??= []);
    while (marks.length < places.length) {
      marks.push(new THREE.Mesh(new THREE.SphereGeometry(0.035, 12, 8), new THREE.MeshBasicMaterial({ color: "#d03a2b" })));
      this.scene.add(marks.at(-1));
    }
    marks.forEach((mark, k) => {
      mark.visible = k < places.length;
      if (mark.visible) mark.position.set(...places[k]);
    });
  }

  // the walked part of the path, up to a frame
  showTrail(frame, visible = true) {
    if (!this.trail) return;
    for (const mesh of this.trail) mesh.visible = visible;
    this.trail[1].geometry.setDrawRange(0, 6 * Math.max(0, Math.floor(frame)));
  }

  // camera, light and floor follow a point on the floor; jump: at once
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

  // the viewpoint of another scene, relative to where each body faces at first
  lookLike(other) {
    this.camera.position.copy(other.camera.position).sub(other.controls.target)
      .applyAxisAngle(this.camera.up, this.facing - other.facing).add(this.controls.target);
  }

  // 0 finest, 1 no fine pixels, 2 a projected shadow, 3 coarse pixels: for slow machines
  setQuality(level) {
    this.renderer.shadowMap.enabled = this.sun.castShadow = this.shade.visible = level < 2;
    this.quality = level;
    for (const body of this.bodies) this.show(body, body.mesh.visible);
    this.resize();
  }

  resize() {
    const { clientWidth: w, clientHeight: h } = this.element;
    if (!w || !h) return;
    const coarse = this.quality > 2 && !this.still ? 0.6 : 1, fine = this.still && this.quality ? 2 : 1;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, this.quality ? 1 : 2) * coarse * fine);
    this.renderer.setSize(w, h, true);
    this.camera.aspect = w / h;
    this.camera.fov = w < h ? Math.min(36 * (h / w) ** 0.7, 60) : 36;
    this.camera.updateProjectionMatrix();
  }

  // still: a picture that stays, drawn with smooth edges
  render({ still = false } = {}) {
    if (still !== this.still) {
      this.still = still;
      this.resize();
    }
    this.controls.update();
    this.renderer.render(this.scene, this.camera);
  }

  dispose() {
    this.observer.disconnect();
    this.controls.dispose();
    this.setTrail(null);
    for (const body of this.bodies) body.dispose();
    this.crowd?.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.canvas.remove();
  }
}
