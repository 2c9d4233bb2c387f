// Times of a page's network and frame, and of the processor's limits; for experiments/speed/page.py, in Node or a browser.
//
// measure(load, data, counts, rounds) → {floor: {bytes, sums: a second}, rows: [{kind, count, network, frame: ms}], pose: ms}
// load(name): a module of the scene; data: of view/live_page.py

// Node's clock is the processor time of this program, which other programs do not lengthen; a browser has none.
function now() {
  if (!globalThis.process) return performance.now();
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e3;
}

// shortest time of so many rounds, ms; a round repeats the work for 4 ms, since clocks are coarse
function best(work, rounds) {
  let least = Infinity;
  for (let i = 0; i < rounds; i++) {
    const start = now();
    let took = 0;
    for (let n = 1; ; n++) {
      work();
      if ((took = now() - start) < 4) continue;
      least = Math.min(least, took / n);
      break;
    }
  }
  return least;
}

// Bytes a second that a plain SIMD loop reads, and multiply-adds in doubles of one that stays in registers.
function floor(simd, bytes, rounds) {
  const { added, advance, assemble, bodyOf, constant, get, I32, kernel, load, plus, put, store, until, V128 } = simd, chains = 8;
  const fused = kernel()?.fused;
  const sums = Array.from({ length: chains }, (_, i) => 3 + i), steps = 1 << 20;
  const all = sums.slice(1).reduce((total, i) => plus(total, get(i)), get(sums[0]));
  const read = bodyOf([[1, I32], [chains, V128]], [
    until(0, get(1), sums.map((i) => put(i, plus(get(i), load(get(0), 16 * (i - 3))))), advance(0, constant(16 * chains))),
    store(constant(0), 0, all)]);
  const multiply = bodyOf([[1, I32], [chains + 1, V128]], [
    until(0, get(1), sums.map((i) => put(i, added(get(i), get(i), get(3 + chains), fused))), advance(0, constant(1))),
    store(constant(0), 0, all)]);
  const memory = new WebAssembly.Memory({ initial: Math.ceil((bytes + 256) / 65536) });
  new Float64Array(memory.buffer).fill(1); // memory that was never written is a single page
  const module = new WebAssembly.Module(assemble({ read: [2, read], multiply: [2, multiply] }));
  const { read: reading, multiply: multiplying } = new WebAssembly.Instance(module, { page: { memory } }).exports;
  return { bytes: (1e3 * bytes) / best(() => reading(128, 128 + bytes), rounds),
           sums: (1e3 * 2 * chains * steps) / best(() => multiplying(0, steps), rounds) };
}

export async function measure(load, data, counts, rounds) {
  const { Character, advance } = await load("character"), { Network } = await load("network"), { numbers } = await load("numbers");
  const vectors = numbers(data.vectors), size = vectors.length / data.styles.length, rows = [];
  let weights, pose;
  for (const kind of ["JavaScript", "WebAssembly SIMD"]) {
    const network = new Network(data.network, { plain: kind === "JavaScript" });
    weights = network.experts.reduce((sum, layer) => sum + layer.weights.length, 0);
    for (const count of counts) {
      const crowd = Array.from({ length: count }, () => new Character(data, network));
      const styles = crowd.map((_, c) => vectors.slice(size * (c % data.styles.length)).subarray(0, size));
      const commands = crowd.map((_, c) => ({ velocity: [Math.sin(c), Math.cos(c)], facing: [Math.sin(c), Math.cos(c)] }));
      for (let i = 0; i < 30; i++) advance(crowd, commands, styles); // compiled, and walking
      const inputs = crowd.map(({ x, z, state: { phase } }, c) => ({ x, z: z.slice(), phase, style: styles[c] }));
      rows.push({ kind, count, frame: best(() => advance(crowd, commands, styles), rounds),
                  network: best(() => network.predict(inputs), rounds) });
      pose = best(() => crowd.forEach((one) => one.pose()), rounds) / count;
    }
  }
  return { weights, rows, pose, floor: floor(await load("simd"), 4 * weights, rounds) };
}
