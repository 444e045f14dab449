// SPDX-License-Identifier: Apache-2.0
// Doubles by units in the last place, and by decimals.

const bits = new DataView(new ArrayBuffer(8));
const least = -0x8000000000000000n;

/** The double so many steps from x to greater ones; infinities are not passed. */
export function stepped(x, ulps) {
  bits.setFloat64(0, x);
  let n = bits.getBigInt64(0); // doubles are ordered as these are, negative ones backwards
  if (n < 0n) n = least - n;
  n += BigInt(ulps);
  bits.setBigInt64(0, n < 0n ? least - n : n);
  const there = bits.getFloat64(0);
  return Number.isFinite(there) ? there : x;
}

/** The multiple of 10^power nearest to x, as decimals are typed. */
export function decimals(x, power) {
  if (power > 0) return String(Math.round(x / 10 ** power) * 10 ** power || 0);
  if (power < -100 || Math.abs(x) >= 1e21) return String(x);
  const text = x.toFixed(-power);
  const tidy = text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  return tidy === "-0" ? "0" : tidy;
}

/** Up to six round numbers from low to top: multiples of 1, 2 or 5 times a power of 10. */
export function roundNumbers(low, top) {
  const power = Math.floor(Math.log10(top - low));
  for (const [times, exponent] of [
    [1, power],
    [5, power - 1],
    [2, power - 1],
  ]) {
    const step = times * 10 ** exponent, first = Math.ceil(low / step), last = Math.floor(top / step);
    if (!(step > 0) || last - first > 6) return [];
    if (last - first >= 2)
      return Array.from({ length: last - first + 1 }, (_, i) => +((first + i) * step).toPrecision(12));
  }
  return [];
}
