// SPDX-License-Identifier: Apache-2.0
// The functions of index.mjs, answered by a worker: const t = await inWorker(); await t.ask("orientation", {...})
import { Answers, InvalidInput } from "./core.mjs";
import { Touchstone } from "./engine.mjs";

export { InvalidInput };

const names = [Answers, Touchstone]
  .flatMap(({ prototype }) => Object.getOwnPropertyNames(prototype)).filter((name) => name !== "constructor");

async function started(address) {
  if (!globalThis.process?.versions?.node) return new Worker(address, { type: "module" });
  const { Worker: Thread } = await import("node:worker_threads");
  return new Thread(address);
}

/** All functions return promises, `draw` one of a list; an engine is the address of a module that exports it. */
export default async function inWorker() {
  let ended;
  const worker = await started(new URL("./worker.mjs", import.meta.url));
  const waiting = new Map();
  const settle = ({ id, result, failure }) => {
    const { resolve, reject } = waiting.get(id);
    waiting.delete(id);
    if (waiting.size === 0) worker.unref?.();
    if (!failure) resolve(result);
    else reject(failure.rule === undefined ? new Error(failure.message) : new InvalidInput(failure.field, failure.rule));
  };
  const fail = (failure) => {
    for (const { reject } of waiting.values()) reject(failure);
    waiting.clear();
  };
  const exit = () => fail(ended ??= new Error("the worker has ended"));
  if (worker.on) worker.on("message", settle).on("error", fail).on("exit", exit);
  else worker.onmessage = ({ data }) => settle(data), worker.onerror = (event) => fail(new Error(event.message));
  let calls = 0;
  const call = (name, given) =>
    new Promise((resolve, reject) => {
      if (ended) return reject(ended);
      waiting.set(++calls, { resolve, reject });
      worker.ref?.();
      worker.postMessage({ id: calls, name, given });
    });
  const client = Object.fromEntries(names.map((name) => [name, (...given) => call(name, given)]));
  /** Ends the worker; calls that it has not answered fail. */
  client.terminate = () => {
    fail(ended ??= new Error("the worker was ended"));
    return worker.terminate();
  };
  await client.operations();
  return client;
}
