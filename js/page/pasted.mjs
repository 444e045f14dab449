// SPDX-License-Identifier: Apache-2.0
// What the reader pastes: JSON of a question, a line or file of a report, a shell line of one, OBJ; WKT and GeoJSON are
// read by the module.
import { asksFor, numeral, parsed, textOf } from "./question.mjs";

/** The first JSON object in a text, with numerals; undefined if there is none. */
function firstObject(text) {
  for (let from = text.indexOf("{"); from >= 0; from = text.indexOf("{", from + 1)) {
    let depth = 0, quoted = false;
    for (let to = from; to < text.length; ++to) {
      const c = text[to];
      if (quoted) {
        if (c === "\\") ++to;
        else if (c === '"') quoted = false;
      } else if (c === '"') quoted = true;
      else if (c === "{") ++depth;
      else if (c === "}" && --depth === 0) {
        try {
          return parsed(text.slice(from, to + 1));
        } catch {
          break;
        }
      }
    }
  }
  return undefined;
}

/** The first object within a value that has an input; op is that of the nearest object around it that names one. */
function firstInput(value, op) {
  if (typeof value !== "object" || value === null) return undefined;
  const named = typeof value.op === "string" ? value.op : typeof value.operation === "string" ? value.operation : op;
  if (typeof value.input === "object" && value.input !== null && !Array.isArray(value.input))
    return { op: named, tree: value.input, answer: value.answer };
  for (const part of Object.values(value)) {
    const found = firstInput(part, named);
    if (found) return found;
  }
  return undefined;
}

/** The vertices and faces of a Wavefront file; of each corner only the vertex. */
function meshOf(text) {
  const vertices = [], faces = [];
  for (const line of text.split("\n")) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === "v") vertices.push(rest.slice(0, 3).map((each) => parsed(each)));
    if (word !== "f") continue;
    const corner = (each) => {
      const i = parseInt(each, 10);
      return numeral(i < 0 ? vertices.length + i : i - 1);
    };
    faces.push(rest.map(corner));
  }
  return { vertices, faces };
}
const isObj = (text) => /^\s*v\s+\S+\s+\S+\s+\S+/m.test(text) && /^\s*f\s/m.test(text);
const isMesh = (meaning) =>
  meaning !== null && typeof meaning === "object" && "vertices" in meaning && "faces" in meaning;

/**
 * {op, text, answer}: the operation's name (that of the text, otherwise `current`, otherwise the first that asks for such
 * geometries or fields) and a question in JSON.
 * answer: what an object with an input holds beside it, to be judged.
 * tree: the question that is shown; of a mesh file its first mesh is replaced.
 * Throws Error with what is wrong in words.
 */
export async function pasted(text, { current, tree, operations, read }) {
  const names = new Set(operations.map(({ name }) => name));
  if (isObj(text)) {
    const field = Object.entries(current.meanings).find(([, meaning]) => isMesh(meaning))?.[0];
    if (!field) throw new Error(`OBJ: ${current.name} asks about no mesh`);
    return { op: current.name, text: textOf({ ...tree, [field]: meshOf(text) }) };
  }
  const found = firstObject(text);
  if (found && typeof found.type !== "string") {
    const given = firstInput(found) ?? { tree: found };
    const said =
      given.op ?? /touchstone ask (\w+)/.exec(text)?.[1] ?? text.match(/\w+/g)?.find((word) => names.has(word));
    if (said !== undefined && !names.has(said)) throw new Error(`there is no operation ${said}`);
    const answer = given.answer === undefined ? undefined : JSON.parse(textOf(given.answer));
    return { op: said ?? operationFor(given.tree, current, operations).name, text: textOf(given.tree), answer };
  }
  // Geometries of WKT on lines of their own, as reports have them.
  const geometries = text.trim().replace(/\)\s*\n\s*(?=[a-z])/gi, "); ");
  let failure;
  for (const { name } of [current, ...operations]) {
    try {
      return { op: name, text: await read(name, geometries) };
    } catch (each) {
      failure ??= each;
    }
  }
  if (failure.field !== "line") throw failure;
  const isNone = failure.rule.startsWith("not JSON") && !/^\s*[[{]/.test(text);
  throw new Error(isNone ? "this is no JSON, WKT, GeoJSON or OBJ" : failure.rule);
}

/** The current operation, if the question has its form; otherwise the first of which it has the form. */
function operationFor(tree, current, operations) {
  const has = ({ meanings }) => asksFor(meanings, tree);
  return has(current) ? current : (operations.find(has) ?? current);
}
