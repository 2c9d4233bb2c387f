// A motion as binary glTF (.glb): a node per joint under its name, rotations and the root's translation, and a skinned mesh.
//
// glb({names, parents, offsets}, frames, fps, name, body) → Uint8Array; frames = [[root [3], rotations [J * 4] w x y z]]
// body: points, normals, tones [V * 3], hosts, shares [V * 4], triangles, inverse [J * 12], as body.js has them; or null
const FLOAT = 5126, SHORT = 5123, INT = 5125, SIZES = { SCALAR: 1, VEC3: 3, VEC4: 4, MAT4: 16 };

export function glb({ names, parents, offsets }, frames, fps, name, body = null) {
  const chunks = [], bufferViews = [], accessors = [];
  let size = 0;
  const add = (values, type, more) => {
    const kind = values instanceof Float32Array ? FLOAT : values instanceof Uint16Array ? SHORT : INT;
    const rest = -values.byteLength & 3;
    bufferViews.push({ buffer: 0, byteOffset: size, byteLength: values.byteLength });
    chunks.push(new Uint8Array(values.buffer, values.byteOffset, values.byteLength), new Uint8Array(rest));
    size += values.byteLength + rest;
    accessors.push({ bufferView: bufferViews.length - 1, componentType: kind, count: values.length / SIZES[type], type, ...more });
    return accessors.length - 1;
  };
  const times = Float32Array.from(frames, (_, f) => f / fps), input = add(times, "SCALAR", { min: [0], max: [times.at(-1)] });
  const samplers = [], channels = [];
  const track = (node, path, values, type) => {
    channels.push({ sampler: samplers.length, target: { node, path } });
    samplers.push({ input, output: add(values, type), interpolation: "LINEAR" });
  };
  track(0, "translation", Float32Array.from(frames.flatMap(([root]) => [...root])), "VEC3");
  const nodes = names.map((joint, j) => {
    const turns = new Float32Array(4 * frames.length);
    frames.forEach(([, q], f) => { // x, y, z, w, without jumps of the sign
      const [w, x, y, z] = q.subarray(4 * j, 4 * j + 4), row = [x, y, z, w];
      const sign = f && row.reduce((sum, v, i) => sum + v * turns[4 * (f - 1) + i], 0) < 0 ? -1 : 1;
      turns.set(row.map((v) => sign * v), 4 * f);
    });
    if (turns.some((v, i) => v !== turns[i % 4])) track(j, "rotation", turns, "VEC4");
    return { name: joint, translation: j ? offsets[j] : [...frames[0][0]], rotation: [...turns.subarray(0, 4)] };
  });
  parents.forEach((parent, j) => parent >= 0 && (nodes[parent].children ??= []).push(j));
  const scene = { name, nodes: [0] }, skinned = {};
  if (body) {
    const matrices = new Float32Array(16 * names.length); // by columns
    names.forEach((_, j) => {
      const column = (c) => [0, 4, 8].map((row) => body.inverse[12 * j + row + c]).concat(c === 3 ? 1 : 0);
      matrices.set([0, 1, 2, 3].flatMap(column), 16 * j);
    });
    const { points, tones, shares } = body, axis = (i) => points.filter((_, at) => at % 3 === i);
    const ends = (pick) => [0, 1, 2].map((i) => axis(i).reduce((best, v) => pick(best, v)));
    const attributes = { POSITION: add(points, "VEC3", { min: ends(Math.min), max: ends(Math.max) }),
                         NORMAL: add(units(body.normals), "VEC3"), COLOR_0: add(tones, "VEC3"),
                         JOINTS_0: add(Uint16Array.from(body.hosts), "VEC4"), WEIGHTS_0: add(shares, "VEC4") };
    const indices = add(Uint32Array.from(body.triangles), "SCALAR");
    skinned.meshes = [{ primitives: [{ attributes, indices, material: 0 }] }];
    skinned.materials = [{ pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 0.8 } }];
    skinned.skins = [{ joints: names.map((_, j) => j), skeleton: 0, inverseBindMatrices: add(matrices, "MAT4") }];
    scene.nodes.push(nodes.push({ name: "Mannequin", mesh: 0, skin: 0 }) - 1);
  }
  const text = new TextEncoder().encode(JSON.stringify({
    asset: { version: "2.0", generator: "toolkit" }, scene: 0, scenes: [scene], nodes, ...skinned,
    animations: [{ name, samplers, channels }], buffers: [{ byteLength: size }], bufferViews, accessors,
  }));
  const json = 4 * Math.ceil(text.length / 4), file = new Uint8Array(28 + json + size), view = new DataView(file.buffer);
  [0x46546c67, 2, file.length, json, 0x4e4f534a].forEach((word, i) => view.setUint32(4 * i, word, true)); // "glTF", "JSON"
  file.fill(32, 20, 20 + json).set(text, 20);
  view.setUint32(20 + json, size, true), view.setUint32(24 + json, 0x004e4942, true); // "BIN"
  let at = 28 + json;
  for (const chunk of chunks) file.set(chunk, at), at += chunk.length;
  return file;
}

function units(normals) {
  const made = new Float32Array(normals.length);
  for (let i = 0; i < made.length; i += 3) {
    const row = normals.subarray(i, i + 3), size = Math.hypot(...row) || 1;
    made.set(row.map((v) => v / size), i);
  }
  return made;
}
