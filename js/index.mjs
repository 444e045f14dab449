// SPDX-License-Identifier: Apache-2.0
// const t = await touchstone(); t.ask("orientation", {p0: [0, 0], p1: [1, 1], p: [2, 2]})
import { Touchstone } from "./engine.mjs";
import createModule from "./module.mjs";

export { InvalidInput } from "./core.mjs";

/** A new instance of the module, with memory of its own. */
export default async function touchstone() {
  const options = {};
  if (globalThis.process?.versions?.node) {  // whose fetch reads no files
    const { readFile } = await import("node:fs/promises");
    options.wasmBinary = await readFile(new URL("./module.wasm", import.meta.url));
  }
  return new Touchstone(await createModule(options));
}
