// A style vector that wanders slowly (runtime/life.py): a function of the frame number, the same numbers as in Python.

function uniform(size, number, seed) {
  const key = (Math.imul(number, 0x9e3779b1) + Math.imul(seed, 0x85ebca77)) | 0;
  return Float64Array.from({ length: size }, (_, i) => {
    let x = (Math.imul(i, 0xc2b2ae3d) + key) | 0;
    x = Math.imul(x ^ (x >>> 16), 0x7feb352d);
    x = Math.imul(x ^ (x >>> 15), 0x846ca68b);
    return Math.sqrt(3) * (((x ^ (x >>> 16)) >>> 0) / 2 ** 31 - 1);
  });
}

export class Life {
  constructor(amount, period, seed = 0) {
    Object.assign(this, { amount, period, seed, keys: new Map() });
  }
  key(number, size) {
    if (!this.keys.has(number)) {
      this.keys.delete(number - 2);
      this.keys.set(number, uniform(size, number, this.seed));
    }
    return this.keys.get(number);
  }
  // the style at a frame
  at(frame, style) {
    if (!this.amount) return style;
    const number = Math.floor(frame / this.period), share = frame / this.period - number;
    const angle = (Math.PI / 2) * share * share * (3 - 2 * share), a = Math.cos(angle), b = Math.sin(angle);
    const [here, next] = [this.key(number, style.length), this.key(number + 1, style.length)];
    const shifts = (i) => Math.floor((4 * i) / style.length) % 2; // FiLM's β, of γ and β of two layers
    return style.map((v, i) => v * (1 + this.amount * shifts(i) * (a * here[i] + b * next[i])));
  }
}
