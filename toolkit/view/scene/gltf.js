// A motion as binary glTF (.glb): a node per joint under its name, rotations and the root's translation at 60 Hz.
//
// glb({names, parents, offsets}, frames [[root [3], rotations [J * 4] w x y z]], fps, name) → Uint8Array
const FLOAT = 5126;

export function glb({ names, parents, offsets }, frames, fps, name) {
  const chunks = [], views = [], accessors = [];
  let size = 0;
  const add = (values, type, bounds) => {
    views.push({ buffer: 0, byteOffset: size, byteLength: values.byteLength });
    chunks.push(new Uint8Array(values.buffer, values.byteOffset, values.byteLength));
    size += values.byteLength;
    const count = values.length / { SCALAR: 1, VEC3: 3, VEC4: 4, MAT4: 16 }[type];
    accessors.push({ bufferView: views.length - 1, componentType: FLOAT, count, type, ...bounds });
    return accessors.length - 1;
  };
  const times = Float32Array.from(frames, (_, f) => f / fps);
  const input = add(times, "SCALAR", { min: [0], max: [times.at(-1)] }), samplers = [], channels = [];
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
  const text = new TextEncoder().encode(JSON.stringify({
    asset: { version: "2.0", generator: "toolkit" }, scene: 0, scenes: [{ name, nodes: [0] }], nodes,
    animations: [{ name, samplers, channels }], buffers: [{ byteLength: size }], bufferViews: views, accessors,
  }));
  const json = 4 * Math.ceil(text.length / 4), file = new Uint8Array(28 + json + size), view = new DataView(file.buffer);
  [0x46546c67, 2, file.length, json, 0x4e4f534a].forEach((word, i) => view.setUint32(4 * i, word, true)); // "glTF", "JSON"
  file.fill(32, 20, 20 + json).set(text, 20);
  view.setUint32(20 + json, size, true), view.setUint32(24 + json, 0x004e4942, true); // "BIN"
  let at = 28 + json;
  for (const chunk of chunks) file.set(chunk, at), at += chunk.length;
  return file;
}
