// The network for one character: gating, blended experts, FiLM (Mason et al. 2022, section 4; compiled/network.py).
//
// network = {
//   means, deviations: numbers of x, phases and z,
//   gating, experts: {widths: [in, hidden, hidden, out], layers: [numbers]},  experts also {count: K}
//   epsilon: added to a deviation;  dropped: variance of an input under dropout, of a calibrated model; 0 of others
// }
// A layer is panels × inputs × 8: the weights of eight outputs lie together, in the order in which they are read, once a frame.
// Its last input is a one, whose weights are the biases. Those of the experts follow each other: input i of expert k is
// k (in + 1) + i, and comes scaled by the gate, so that one product blends them all.
import { numbers } from "./numbers.js";

const PANEL = 8;

// y = W x, in doubles. Eight sums under way keep a processor busy; V8 checks bounds of what it reads, and is still near its limit.
function multiply(w, x, y) {
  const n = x.length;
  for (let o = 0, p = 0; o < y.length; o += PANEL) {
    let a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0;
    for (let i = 0; i < n; i++, p += PANEL) {
      const v = x[i];
      a += v * w[p], b += v * w[p + 1], c += v * w[p + 2], d += v * w[p + 3];
      e += v * w[p + 4], f += v * w[p + 5], g += v * w[p + 6], h += v * w[p + 7];
    }
    y[o] = a, y[o + 1] = b, y[o + 2] = c, y[o + 3] = d, y[o + 4] = e, y[o + 5] = f, y[o + 6] = g, y[o + 7] = h;
  }
}

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

const elu = (v) => (v > 0 ? v : Math.expm1(v));

// inputs of a layer, and the one behind them
function inputs(n) {
  const x = new Float64Array(n + 1);
  x[n] = 1;
  return x;
}

const panels = (n) => new Float64Array(Math.ceil(n / PANEL) * PANEL);

export class Network {
  constructor({ means, deviations, gating, experts, epsilon, dropped }) {
    Object.assign(this, { means: means.map(numbers), deviations: deviations.map(numbers), epsilon, dropped });
    this.gating = gating.layers.map((layer, i) => ({
      weights: numbers(layer), x: inputs(gating.widths[i]), y: panels(gating.widths[i + 1]),
    }));
    this.experts = experts.layers.map((layer, i) => ({
      weights: numbers(layer), x: inputs(experts.widths[i]), y: panels(experts.widths[i + 1]),
      scaled: new Float64Array(experts.count * (experts.widths[i] + 1)),
    }));
    this.gates = new Float64Array(experts.count);
  }

  // Fills z with the next frame, physical units: Model.predict.
  predict(x, phase, style, z) {
    const [first, second, third] = this.experts, [mean, , shift] = this.means, [deviation, , scale] = this.deviations;
    this.gate(phase);
    for (let i = 0; i < x.length; i++) first.x[i] = (x[i] - mean[i]) / deviation[i];
    const width = style.length / 4;
    this.modulate(first, style, 0, width, second.x);
    this.modulate(second, style, 2 * width, width, third.x);
    const y = this.blend(third);
    for (let i = 0; i < z.length; i++) z[i] = y[i] * scale[i] + shift[i];
  }

  // gating coefficients of a phase
  gate(phase) {
    const [first, second, last] = this.gating, mean = this.means[1], deviation = this.deviations[1], { gates } = this;
    for (let i = 0; i < phase.length; i++) first.x[i] = (phase[i] - mean[i]) / deviation[i];
    for (const [layer, next] of [[first, second], [second, last]]) {
      multiply(layer.weights, layer.x, layer.y);
      for (let i = 0; i < next.x.length - 1; i++) next.x[i] = elu(layer.y[i]);
    }
    multiply(last.weights, last.x, last.y);
    let high = -Infinity, sum = 0;
    for (let k = 0; k < gates.length; k++) high = Math.max(high, last.y[k]);
    for (let k = 0; k < gates.length; k++) sum += gates[k] = Math.exp(last.y[k] - high);
    for (let k = 0; k < gates.length; k++) gates[k] /= sum;
  }

  // Σ αₖ (Wₖ x + bₖ)
  blend({ weights, x, y, scaled }) {
    const { gates } = this, n = x.length;
    for (let k = 0; k < gates.length; k++) for (let i = 0; i < n; i++) scaled[k * n + i] = gates[k] * x[i];
    multiply(weights, scaled, y);
    return y;
  }

  // variance that dropout would add to each output of a layer: Σᵢ (xᵢ Σₖ αₖ Wₖᵢⱼ)², times `dropped`; scaled inputs are those of blend
  scatter({ weights, x, y, scaled }) {
    const n = x.length, count = this.gates.length, spread = new Float64Array(y.length);
    for (let o = 0, p = 0; o < y.length; o += PANEL, p += PANEL * n * count) {
      for (let i = 0; i < n - 1; i++) { // the last input is the one of the biases
        for (let c = 0; c < PANEL; c++) {
          let v = 0;
          for (let k = 0; k < count; k++) v += scaled[k * n + i] * weights[p + PANEL * (k * n + i) + c];
          spread[o + c] += this.dropped * v * v;
        }
      }
    }
    return spread;
  }

  // ELU(γ ∘ LN(y) + β) of a layer, with γ at a place of the style vector and β behind it; its mean over dropout if calibrated
  modulate(layer, style, at, width, result) {
    const y = this.blend(layer), spread = this.dropped ? this.scatter(layer) : null;
    let mean = 0, square = 0, added = 0;
    for (let i = 0; i < width; i++) mean += y[i];
    mean /= width;
    for (let i = 0; i < width; i++) square += (y[i] - mean) ** 2;
    if (spread) {
      for (let i = 0; i < width; i++) added += spread[i] / width;
      const scale = 1 / (Math.sqrt(square / (width - 1) + added) + this.epsilon);
      for (let i = 0; i < width; i++) {
        const gamma = style[at + i];
        result[i] = expectedElu(gamma * (y[i] - mean) * scale + style[at + width + i], Math.abs(gamma) * Math.sqrt(spread[i]) * scale);
      }
      return;
    }
    const scale = 1 / (Math.sqrt(square / (width - 1)) + this.epsilon);
    for (let i = 0; i < width; i++) result[i] = elu(style[at + i] * (y[i] - mean) * scale + style[at + width + i]);
  }
}
