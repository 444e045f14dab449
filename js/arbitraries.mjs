// SPDX-License-Identifier: Apache-2.0
// Generators for fast-check: questions of the families, degenerate on purpose, and of raw numbers.

/** Of the input as `operations()` describes it. */
function rawValue(fc, described) {
  if (Array.isArray(described)) {
    if (described[1] === "...") return fc.array(rawValue(fc, described[0]), { maxLength: 8 });
    return fc.tuple(...described.map((each) => rawValue(fc, each)));
  }
  if (typeof described === "object") {
    if (described["one of"]) return fc.oneof(...described["one of"].map((each) => rawValue(fc, each)));
    const fields = Object.entries(described).map(([name, each]) => [name.replace("?", ""), rawValue(fc, each)]);
    const requiredKeys = Object.keys(described).filter((name) => !name.endsWith("?"));
    return fc.record(Object.fromEntries(fields), { requiredKeys });
  }
  if (described === "number")
    return fc.oneof({ weight: 2, arbitrary: fc.integer({ min: -8, max: 8 }) },
                    { weight: 1, arbitrary: fc.double({ noNaN: true, noDefaultInfinity: true }) });
  if (described === "index") return fc.nat(7);
  if (described === "true | false") return fc.boolean();
  return fc.constantFrom(...described.split(" | "));
}

/** const { questions, raw } = arbitraries(fc, await touchstone()) */
export default function arbitraries(fc, touchstone) {
  const within = (operation, some) => some.filter((question) => touchstone.accepts(operation, question));
  return {
    /** Questions of families, by default of all, within the contract; they shrink within their family. */
    questions(operation, { families = touchstone.operation(operation).families } = {}) {
      const bytes = fc.uint8Array({ maxLength: 256, size: "max" });
      const drawn = fc.tuple(fc.constantFrom(...families), bytes)
        .map(([family, chosen]) => touchstone.replay(operation, family, chosen));
      return within(operation, drawn);
    },
    /** Any small integers and any finite doubles, within the contract; `all` leaves in what it refuses. */
    raw(operation, { all = false } = {}) {
      const { input } = touchstone.operation(operation);
      const some = rawValue(fc, Array.isArray(input) ? { "one of": input } : input);
      return all ? some : within(operation, some);
    },
  };
}
