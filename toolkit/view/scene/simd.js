// The product of the experts as WebAssembly with SIMD, in doubles, assembled here when a page opens.
//
// A layer is y = Σ αₖ Wₖ x. Weights w are float32, panels × experts × rows × 8 outputs; the rows are a multiple of 4. The sums of a
// tile, outputs × columns, stay in registers over the rows of one expert, and are added to y times the expert's gate.
//   many(y, w, x, gates, rows, experts, panels, tiles): 4 outputs, 4 characters; x is tiles × rows × 4, gates tiles × experts × 4
//   one(y, w, x, gates, rows, experts, panels): 8 outputs, every second row of one character; x is rows, gates experts
// y is characters × panels × 8. The first four arguments are addresses in bytes. So weights are read once for all characters.
export const I32 = 0x7f, V128 = 0x7b;
const COLUMNS = 4, DOUBLE = 8, OUTPUTS = 8, LANES = 2;
const EACH = Array.from({ length: COLUMNS }, (_, c) => c);

function leb(n) { // unsigned
  const bytes = [];
  for (; n > 127; n >>>= 7) bytes.push((n & 127) | 128);
  return [...bytes, n];
}
const sized = (content) => ((content = content.flat(Infinity)), [leb(content.length), content]);
const list = (items) => [leb(items.length), items];
const name = (text) => list([...text].map((c) => c.charCodeAt(0)));

// instructions of WebAssembly, as nested lists of bytes
export const get = (i) => [0x20, leb(i)];
export const put = (i, value) => [value, 0x21, leb(i)];
export const constant = (n) => [0x41, n < 64 ? n : [(n & 127) | 128, n >> 7]]; // 0 up to 8191
const add = (a, b) => [a, b, 0x6a], times = (a, b) => [a, b, 0x6c];
export const advance = (i, by) => put(i, add(get(i), by));
export const until = (i, end, ...body) => [0x03, 0x40, body, get(i), end, 0x49, 0x0d, 0, 0x0b]; // do … while i < end
const vector = (op) => [0xfd, leb(op)];
const zero = [vector(12), Array(16).fill(0)];
export const load = (address, offset) => [address, vector(0), 0, leb(offset)];
const splat = (address, offset) => [address, vector(10), 0, leb(offset)]; // one double in both lanes
const singles = (address, offset) => [address, vector(93), 0, leb(offset), vector(95)]; // two float32 as doubles
export const store = (address, offset, value) => [address, value, vector(11), 0, leb(offset)];
export const plus = (a, b) => [a, b, vector(240)], product = (a, b) => [a, b, vector(242)];
export const added = (total, a, b, fused) => (fused ? [a, b, total, vector(263)] : plus(total, product(a, b))); // total + a b
export const bodyOf = (locals, code) => sized([list(locals), code, 0x0b]); // of a function; locals = [[count, type]]

function compute(many, fused) {
  // Locals. Counters: panel, expert, tile. Addresses: expertAt of the weights of an expert in a panel, row and end of what half()
  // reads of them, at of the inputs, gate and out of the gates and sums of a tile. stride: bytes of y of a character. Vectors: value,
  // input, sum.
  const [y, w, x, gates, rows, experts, panels] = Array.from({ length: 7 }, (_, i) => i), first = many ? 8 : 7;
  const [panel, expert, tile, expertAt, row, end, at, gate, out, stride] = Array.from({ length: 10 }, (_, i) => first + i);
  const pairs = many ? [0, 1] : [0, 1, 2, 3], columns = 2 * COLUMNS / pairs.length; // of lanes, and of sums
  const value = first + 10, input = value + 1, sum = (v, c) => input + COLUMNS + columns * v + c;
  const multiply = (v, c, weight) => put(sum(v, c % columns), added(get(sum(v, c % columns)), get(input + c), weight, fused));
  const one = [ // four rows
    EACH.map((c) => pairs.map((v) => multiply(v, c, singles(get(row), 4 * (OUTPUTS * c + LANES * v))))),
    advance(row, constant(4 * OUTPUTS * COLUMNS)),
  ];
  const all = [ // one row
    pairs.map((v) => [put(value, singles(get(row), 4 * LANES * v)), EACH.map((c) => multiply(v, c, get(value)))]),
    advance(row, constant(4 * OUTPUTS)),
  ];
  const blend = (v, half, c, total) => { // y += gate * total
    const offset = DOUBLE * LANES * (v + 2 * half);
    return store(get(out), offset, plus(load(get(out), offset), product(splat(get(gate), DOUBLE * c), total)));
  };
  const half = (number) => [ // four of the panel's eight outputs, or all
    EACH.map((k) => [0, COLUMNS].map((v) => put(sum(0, 0) + v + k, zero))),
    put(row, add(get(expertAt), constant(4 * 2 * LANES * number))),
    put(end, add(get(row), times(get(rows), constant(4 * OUTPUTS)))),
    put(at, many ? add(get(x), times(times(get(tile), get(rows)), constant(DOUBLE * COLUMNS))) : get(x)),
    until(row, get(end),
      EACH.map((c) => put(input + c, splat(get(at), DOUBLE * c))), many ? all : one, advance(at, constant(DOUBLE * COLUMNS))),
    put(out, add(get(y), times(get(panel), constant(DOUBLE * OUTPUTS)))),
    many ? [
      put(gate, add(get(gates), times(add(times(get(tile), get(experts)), get(expert)), constant(DOUBLE * COLUMNS)))),
      advance(out, times(get(tile), times(get(stride), constant(COLUMNS)))),
      EACH.map((c) => [pairs.map((v) => blend(v, number, c, get(sum(v, c)))), advance(out, get(stride))]),
    ] : [
      put(gate, add(get(gates), times(get(expert), constant(DOUBLE)))),
      pairs.map((v) => blend(v, number, 0, plus(get(sum(v, 0)), get(sum(v, 1))))),
    ],
  ];
  const code = [
    put(expertAt, get(w)), put(stride, times(get(panels), constant(DOUBLE * OUTPUTS))), put(panel, constant(0)),
    until(panel, get(panels), put(expert, constant(0)),
      until(expert, get(experts), put(tile, constant(0)),
        many ? until(tile, get(first - 1), half(0), half(1), advance(tile, constant(1))) : half(0),
        advance(expertAt, times(get(rows), constant(4 * OUTPUTS))), advance(expert, constant(1))),
      advance(panel, constant(1))),
  ];
  return bodyOf([[10, I32], [1 + 3 * COLUMNS, V128]], code);
}

// Bytes of a module that imports page.memory and exports functions {name: [number of parameters, body]}.
export function assemble(functions) {
  const section = (id, items) => [id, sized(list(items))], bodies = Object.values(functions);
  return Uint8Array.from([
    0, 97, 115, 109, 1, 0, 0, 0, // "\0asm", version 1
    section(1, bodies.map(([parameters]) => [0x60, list(Array(parameters).fill(I32)), 0])),
    section(2, [[name("page"), name("memory"), 2, 0, 1]]),
    section(3, bodies.map((_, i) => i)),
    section(7, Object.keys(functions).map((text, i) => [name(text), 0, i])),
    section(10, bodies.map(([, body]) => body)),
  ].flat(Infinity));
}

// {many, one, memory}; null where the browser has no SIMD or its page forbids WebAssembly. A fused sum is twice as fast.
export function kernel(fused = true) {
  try {
    const memory = new WebAssembly.Memory({ initial: 1 });
    const made = new WebAssembly.Module(assemble({ many: [8, compute(true, fused)], one: [7, compute(false, fused)] }));
    return { ...new WebAssembly.Instance(made, { page: { memory } }).exports, memory, fused };
  } catch {
    return fused ? kernel(false) : null;
  }
}
