// Arrays of numbers inside a page, which Python wrote: base64, little-endian.
const HALVES = (() => { // every float16
  let table;
  return () => (table ??= Float32Array.from({ length: 65536 }, (_, bits) => {
    const sign = bits >> 15 ? -1 : 1, power = (bits >> 10) & 31, rest = bits & 1023;
    if (power === 31) return rest ? NaN : sign * Infinity;
    return sign * (power ? (1 + rest / 1024) * 2 ** (power - 15) : rest * 2 ** -24);
  }));
})();

export function decode(base64, Type) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return new Type(bytes.buffer);
}

// {type: "float32" or "float16", data} as float32
export function numbers({ type, data }) {
  if (type === "float32") return decode(data, Float32Array);
  const table = HALVES();
  return Float32Array.from(decode(data, Uint16Array), (bits) => table[bits]);
}
