// The network for one character or many: gating, blended experts, FiLM (Mason et al. 2022, section 4; compiled/network.py).
//
// network = {
//   means, deviations: numbers of x, phases and z,
//   gating, experts: {widths: [in, hidden, hidden, out], layers: [numbers]},  experts also {count: K}
//   epsilon: added to a deviation;  dropped: variance of an input under dropout, of a calibrated model; 0 of others
// }
// A layer is panels × experts × inputs × 8: the weights of eight outputs lie together, in the order in which they are read, once a
// frame. Its last input is a one, whose weights are the biases. simd.js multiplies, or JavaScript where the browser cannot.
import { numbers } from "./numbers.js";
import { kernel } from "./simd.js";

const PANEL = 8, TILE = 4, DOUBLE = 8, PAGE = 65536;
const rounded = (n, to) => to * Math.ceil(n / to);

// complementary error function, to 1.2e-7 of its value (Press et al., Numerical Recipes)
function erfc(v) {
  const t = 1 / (1 + 0.5 * Math.abs(v)), terms = [0.17087277, -0.82215223, 1.48851587, -1.13520398, 0.27886807, -0.18628806,
    0.09678418, 0.37409196, 1.00002368];
  const value = t * Math.exp(-v * v - 1.26551223 + t * terms.reduce((sum, term) => term + t * sum, 0));
  return v >= 0 ? value : 2 - value;
}

// E[ELU(X)] of a normal variable: networks/film.py's expected_elu
function expectedElu(m, deviation) {
  const s = Math.max(deviation, 1e-6), at = m / s, below = 0.5 * erfc(at * Math.SQRT1_2);
  const tail = Math.exp(Math.min(m + 0.5 * s * s, 60)) * 0.5 * erfc((at + s) * Math.SQRT1_2);
  return m * (1 - below) + (s * Math.exp(-0.5 * at * at)) / Math.sqrt(2 * Math.PI) + tail - below;
}

const elu = (v) => (v > 0 ? v : Math.exp(v) - 1);

// What simd.js computes for one character, in JavaScript: y += Σ gate W x, in doubles. Eight sums under way keep a processor busy; V8
// checks bounds of what it reads, and is still near its limit.
function blend(y, w, x, gates, { rows, experts, panels }) {
  for (let o = 0, p = 0; o < PANEL * panels; o += PANEL) {
    for (let k = 0; k < experts; k++) {
      let a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0;
      for (let i = 0; i < rows; i++, p += PANEL) {
        const v = x[i];
        a += v * w[p], b += v * w[p + 1], c += v * w[p + 2], d += v * w[p + 3];
        e += v * w[p + 4], f += v * w[p + 5], g += v * w[p + 6], h += v * w[p + 7];
      }
      const gate = gates[k];
      y[o] += gate * a, y[o + 1] += gate * b, y[o + 2] += gate * c, y[o + 3] += gate * d;
      y[o + 4] += gate * e, y[o + 5] += gate * f, y[o + 6] += gate * g, y[o + 7] += gate * h;
    }
  }
}

// the weights of a layer with rows of zeros, where their number is no multiple of four
function padded(weights, inputs, rows) {
  const whole = new Float32Array((weights.length / inputs) * rows);
  for (let from = 0, to = 0; from < weights.length; from += PANEL * inputs, to += PANEL * rows)
    whole.set(weights.subarray(from, from + PANEL * inputs), to);
  return whole;
}

export class Network {
  // plain: without WebAssembly
  constructor({ means, deviations, gating, experts, epsilon, dropped }, { plain = false } = {}) {
    Object.assign(this, { means: means.map(numbers), deviations: deviations.map(numbers), epsilon, dropped, count: 0 });
    this.gating = gating.layers.map((layer, i) => ({
      weights: numbers(layer), x: new Float64Array(gating.widths[i] + 1).fill(1), y: new Float64Array(rounded(gating.widths[i + 1], PANEL)),
      rows: gating.widths[i] + 1, experts: 1, panels: Math.ceil(gating.widths[i + 1] / PANEL),
    }));
    let end = 0;
    this.experts = experts.layers.map((layer, i) => {
      const inputs = experts.widths[i] + 1, rows = rounded(inputs, TILE), weights = padded(numbers(layer), inputs, rows), at = end;
      end += 4 * weights.length;
      return { weights, at, inputs, rows, experts: experts.count, panels: Math.ceil(experts.widths[i + 1] / PANEL) };
    });
    this.weights = end;
    this.simd = plain ? null : kernel();
    this.reserve(1);
  }

  // Makes room for so many characters at once.
  reserve(count) {
    if (count <= this.count) return;
    this.count = count > 1 ? rounded(count, TILE) : 1;
    const [{ experts }] = this.experts, widest = Math.max(...this.experts.map(({ panels }) => PANEL * panels));
    const lengths = [...this.experts.map(({ rows }) => rows), experts, widest].map((n) => n * this.count);
    const bytes = this.weights + DOUBLE * lengths.reduce((sum, n) => sum + n), first = !this.memory;
    if (this.simd) {
      const { memory } = this.simd, more = Math.ceil((bytes - memory.buffer.byteLength) / PAGE);
      if (more > 0) memory.grow(more);
      this.memory = memory.buffer;
    } else this.memory = new ArrayBuffer(bytes);
    // WebAssembly memory that grows keeps what is in it, but ends old views; a new ArrayBuffer is empty.
    for (const layer of this.experts) {
      const weights = new Float32Array(this.memory, layer.at, layer.weights.length);
      if (first || !this.simd) weights.set(layer.weights);
      layer.weights = weights;
    }
    // behind the weights, one after the other: x of each layer, gates, y
    let at = this.weights;
    const parts = lengths.map((n) => new Float64Array(this.memory, (at += DOUBLE * n) - DOUBLE * n, n));
    this.experts.forEach((layer, i) => (layer.x = parts[i]));
    [this.gates, this.y] = parts.slice(-2);
  }

  // where the numbers of character c of n lie, and how far apart, in an array of so many for each
  place(c, n, count) {
    const tile = this.simd && n > 1 ? TILE : 1;
    return [tile * count * Math.floor(c / tile) + (c % tile), tile];
  }

  // Fills each character's z with its next frame, physical units, as Model.predict does; characters = [{x, phase, style, z}].
  predict(characters) {
    const [first, second, third] = this.experts, [mean, , shift] = this.means, [deviation, , scale] = this.deviations;
    const n = characters.length;
    this.reserve(n);
    characters.forEach(({ x, phase }, c) => {
      const [at, step] = this.place(c, n, first.rows);
      this.gate(phase, c, n);
      for (let i = 0; i < x.length; i++) first.x[at + i * step] = (x[i] - mean[i]) / deviation[i];
    });
    this.blend(first, n);
    characters.forEach(({ style }, c) => this.modulate(first, style, 0, second, c, n));
    this.blend(second, n);
    characters.forEach(({ style }, c) => this.modulate(second, style, style.length / 2, third, c, n));
    this.blend(third, n);
    characters.forEach(({ z }, c) => {
      const at = PANEL * third.panels * c;
      for (let i = 0; i < z.length; i++) z[i] = this.y[at + i] * scale[i] + shift[i];
    });
  }

  // gating coefficients of a phase
  gate(phase, c, n) {
    const [first, second, last] = this.gating, mean = this.means[1], deviation = this.deviations[1], [{ experts }] = this.experts;
    for (let i = 0; i < phase.length; i++) first.x[i] = (phase[i] - mean[i]) / deviation[i];
    const multiply = (layer) => blend(layer.y.fill(0), layer.weights, layer.x, [1], layer);
    for (const [layer, next] of [[first, second], [second, last]]) {
      multiply(layer);
      for (let i = 0; i < next.x.length - 1; i++) next.x[i] = elu(layer.y[i]);
    }
    multiply(last);
    const [at, step] = this.place(c, n, experts), { gates } = this;
    let high = -Infinity, sum = 0;
    for (let k = 0; k < experts; k++) high = Math.max(high, last.y[k]);
    for (let k = 0; k < experts; k++) sum += last.y[k] = Math.exp(last.y[k] - high);
    for (let k = 0; k < experts; k++) gates[at + k * step] = last.y[k] / sum;
  }

  // Σ αₖ (Wₖ x + bₖ) of all characters
  blend(layer, n) {
    const { at, weights, x, inputs, rows, experts, panels } = layer, { y, gates, simd } = this;
    for (let c = 0; c < n; c++) {
      const [start, step] = this.place(c, n, rows);
      x[start + (inputs - 1) * step] = 1;
    }
    y.fill(0);
    if (!simd) {
      for (let c = 0; c < n; c++) {
        const [start] = this.place(c, n, rows), [gate] = this.place(c, n, experts);
        blend(y.subarray(PANEL * panels * c), weights, x.subarray(start), gates.subarray(gate), layer);
      }
    } else if (n === 1) simd.one(y.byteOffset, at, x.byteOffset, gates.byteOffset, rows, experts, panels);
    else simd.many(y.byteOffset, at, x.byteOffset, gates.byteOffset, rows, experts, panels, Math.ceil(n / TILE));
  }

  // variance that dropout would add to each output of a layer: Σᵢ (xᵢ Σₖ αₖ Wₖᵢⱼ)², times `dropped`
  scatter({ weights, x, inputs, rows, experts, panels }, c, n) {
    const [at, step] = this.place(c, n, rows), [gate] = this.place(c, n, experts), spread = new Float64Array(PANEL * panels);
    for (let o = 0, p = 0; o < spread.length; o += PANEL, p += PANEL * rows * experts) {
      for (let i = 0; i < inputs - 1; i++) { // the last input is the one of the biases
        for (let j = 0; j < PANEL; j++) {
          let v = 0;
          for (let k = 0; k < experts; k++) v += this.gates[gate + k * step] * weights[p + PANEL * (k * rows + i) + j];
          v *= x[at + i * step];
          spread[o + j] += this.dropped * v * v;
        }
      }
    }
    return spread;
  }

  // ELU(γ ∘ LN(y) + β) of a layer, with γ at a place of the style vector and β behind it; its mean over dropout if calibrated
  modulate(layer, style, from, next, c, n) {
    const width = style.length / 4, y = this.y.subarray(PANEL * layer.panels * c), result = next.x;
    const spread = this.dropped ? this.scatter(layer, c, n) : null, [at, step] = this.place(c, n, next.rows);
    let mean = 0, square = 0, added = 0;
    for (let i = 0; i < width; i++) mean += y[i];
    mean /= width;
    for (let i = 0; i < width; i++) square += (y[i] - mean) ** 2;
    if (spread) {
      for (let i = 0; i < width; i++) added += spread[i] / width;
      const scale = 1 / (Math.sqrt(square / (width - 1) + added) + this.epsilon);
      for (let i = 0; i < width; i++) {
        const gamma = style[from + i], size = Math.abs(gamma) * Math.sqrt(spread[i]) * scale;
        result[at + i * step] = expectedElu(gamma * (y[i] - mean) * scale + style[from + width + i], size);
      }
      return;
    }
    const scale = 1 / (Math.sqrt(square / (width - 1)) + this.epsilon);
    for (let i = 0; i < width; i++) result[at + i * step] = elu(style[from + i] * (y[i] - mean) * scale + style[from + width + i]);
  }
}
