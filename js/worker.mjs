// SPDX-License-Identifier: Apache-2.0
// A worker that answers one call after the other: {id, name, given} with {id, result} or {id, failure}.
import { engineOf } from "./engine.mjs";
import touchstone from "./index.mjs";

const inNode = Boolean(globalThis.process?.versions?.node);
const port = inNode ? (await import("node:worker_threads")).parentPort : globalThis;

/** Engines are functions, which cannot be sent: the address of a module with the engine stands for it. */
const imported = async (engine) => (typeof engine === "string" ? engineOf(await import(engine)) : engine);
const takesEngine = { audit: 0, judge: 0 };

async function answered(name, given) {
  const module = await ready;
  if (name in takesEngine) given[0] = await imported(given[0]);
  if (name === "shrink" && given[2]?.engine) given[2] = { ...given[2], engine: await imported(given[2].engine) };
  const result = await module[name](...given);
  return name === "draw" ? [...result] : result;
}

const ready = touchstone();
let last = ready;
const receive = ({ id, name, given }) => {
  last = last.catch(() => {}).then(() => answered(name, given)).then(
    (result) => port.postMessage({ id, result }),
    (failure) => port.postMessage({ id, failure: { message: failure.message, field: failure.field, rule: failure.rule } }));
};
if (inNode) port.on("message", receive);
else port.onmessage = ({ data }) => receive(data);
