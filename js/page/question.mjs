// SPDX-License-Identifier: Apache-2.0
// A question as the reader edits it: JSON in which each number keeps its text, so that decimals are answered as typed;
// and what its numbers mean, by `meanings` of the catalogue: places, directions, lengths.

/** A number with the text that it was typed with. */
export class Numeral {
  constructor(text) {
    this.text = text;
  }
  get value() {
    return Number(this.text);
  }
}
/** The numeral of a double. */
export const numeral = (x) => new Numeral(Object.is(x, -0) ? "-0.0" : String(x));

const token = /("(?:[^"\\]|\\.)*")|-?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?/g;
/** JSON with numerals for numbers. Throws SyntaxError. */
export const parsed = (text) =>
  JSON.parse(
    text.replace(token, (all, string) => string ?? `"\\u0001${all}"`),
    (_, value) => (typeof value === "string" && value[0] === "\u0001" ? new Numeral(value.slice(1)) : value),
  );

export function textOf(value) {
  if (value instanceof Numeral) return value.text;
  if (Array.isArray(value)) return `[${value.map(textOf).join(",")}]`;
  if (typeof value !== "object" || value === null) return JSON.stringify(value);
  return `{${Object.entries(value)
    .map(([name, field]) => `${JSON.stringify(name)}:${textOf(field)}`)
    .join(",")}}`;
}

export const at = (tree, path) => path.reduce((value, key) => value?.[key], tree);
/** The tree with another value at a path; what lies beside the path is shared. */
export function put(tree, [key, ...rest], value) {
  if (key === undefined) return value;
  const copy = Array.isArray(tree) ? [...tree] : { ...tree };
  copy[key] = put(tree?.[key], rest, value);
  return copy;
}
/** A path as the program names fields: a[0], plane.normal[2]. */
export const spelled = (path) =>
  path.map((key, i) => (typeof key === "number" ? `[${key}]` : (i ? "." : "") + key)).join("");

const isList = (meaning) => Array.isArray(meaning) && meaning[1] === "...";
const isTuple = (meaning) => Array.isArray(meaning) && meaning.every((each) => each === meaning[0]);
const fields = (meaning) =>
  Object.entries(meaning).map(([name, each]) => [name.replace(/\?$/, ""), each, name.endsWith("?")]);

/** Whether a value has the form that a meaning describes. */
function fits(meaning, value) {
  if (typeof meaning === "string") {
    if (meaning === "true | false") return typeof value === "boolean";
    if (meaning.includes(" | ")) return meaning.split(" | ").includes(value);
    return value instanceof Numeral;
  }
  if (isList(meaning)) return Array.isArray(value) && value.every((each) => fits(meaning[0], each));
  if (Array.isArray(meaning))
    return (
      Array.isArray(value) && value.length === meaning.length && meaning.every((each, i) => fits(each, value[i]))
    );
  if (meaning["one of"]) return meaning["one of"].some((each) => fits(each, value));
  if (typeof value !== "object" || value === null || Array.isArray(value) || value instanceof Numeral) return false;
  const known = fields(meaning);
  return (
    Object.keys(value).every((name) => known.some(([field]) => field === name)) &&
    known.every(([name, each, optional]) => (name in value ? fits(each, value[name]) : optional))
  );
}
/** Whether a question has the form of an operation's. */
export const asksFor = (meanings, tree) => [meanings].flat().some((each) => fits(each, tree));

/** Of an operation that is asked in the plane or in space, the form that the question has. */
const formOf = (meanings, tree) =>
  Array.isArray(meanings) ? (meanings.find((each) => fits(each, tree)) ?? meanings[0]) : meanings;

/**
 * The parts of a question in the catalogue's order: {path, kind, words}, by kind
 *   place, direction   a list of two or three numbers
 *   length, number     one number; index: one place in a list
 *   word               one of words; flag: true or false
 *   list               a list that may be longer or shorter, before what is in it
 */
export function partsOf(meanings, tree) {
  const parts = [];
  const walk = (meaning, value, path) => {
    if (value === undefined) return;
    if (typeof meaning === "string") {
      if (meaning === "true | false") parts.push({ path, kind: "flag" });
      else if (meaning.includes(" | ")) parts.push({ path, kind: "word", words: meaning.split(" | ") });
      else if (value instanceof Numeral) parts.push({ path, kind: meaning });
    } else if (isList(meaning)) {
      if (!Array.isArray(value)) return;
      if (value.length && !JSON.stringify(meaning).includes('"index"')) parts.push({ path, kind: "list" });
      value.forEach((each, i) => walk(meaning[0], each, [...path, i]));
    } else if (isTuple(meaning) && ["place", "direction"].includes(meaning[0])) {
      if (fits(meaning, value)) parts.push({ path, kind: meaning[0] });
    } else if (Array.isArray(meaning)) {
      if (Array.isArray(value)) meaning.forEach((each, i) => walk(each, value[i], [...path, i]));
    } else if (meaning["one of"]) {
      walk(meaning["one of"].find((each) => fits(each, value)) ?? meaning["one of"][0], value, path);
    } else {
      for (const [name, each] of fields(meaning)) walk(each, value?.[name], [...path, name]);
    }
  };
  walk(formOf(meanings, tree), tree, []);
  return parts;
}
/** A list with one more element, of places in the middle between the last and the first, or without its last. */
export function resized(list, isLonger) {
  if (!isLonger) return list.slice(0, -1);
  const [start, end] = [list[0], list.at(-1)];
  const isPlace = Array.isArray(end) && end.every((x) => x instanceof Numeral);
  return [...list, isPlace ? end.map((x, i) => numeral(x.value / 2 + start[i].value / 2)) : end];
}
/** The paths of a part's numbers. */
export const numbersOf = (part, tree) =>
  ({ place: true, direction: true })[part.kind]
    ? at(tree, part.path).map((_, i) => [...part.path, i])
    : ["length", "number", "index"].includes(part.kind)
      ? [part.path]
      : [];
/** The values of a place or direction. */
export const valuesAt = (tree, path) => at(tree, path).map((each) => each.value);
