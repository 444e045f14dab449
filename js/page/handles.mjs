// SPDX-License-Identifier: Apache-2.0
// What of a question can be dragged: its places, the tips of its directions, the ends of its radii, and its planes.
import { at, put, spelled, valuesAt, Numeral } from "./question.mjs";
import { dot, footOf, minus, plus, size } from "./view.mjs";

const mostHandles = 60,
  shortest = 34; // pixels
const centres = ["origin", "center", "position", "start", "point"];
const isPlace = (value) =>
  Array.isArray(value) && (value.length === 2 || value.length === 3) && value.every((x) => x instanceof Numeral);

/** The place that a direction or a length belongs to: of the record that holds it, or of a body next to it. */
function placeBeside(tree, path) {
  const holder = at(tree, path.slice(0, -1));
  if (typeof holder !== "object" || holder === null) return undefined;
  const own = (record) =>
    centres.map((name) => record?.[name]).find(isPlace) ??
    (isPlace(record?.min) ? record.min : Array.isArray(record?.segment) ? record.segment[0] : undefined);
  if (Array.isArray(holder)) return path.length > 1 ? placeBeside(tree, path.slice(0, -1)) : undefined;
  const body = /_([ab])$/.exec(path.at(-1))?.[1]; // velocity_a moves a
  const near = own(body ? holder[body] : holder) ?? Object.values(holder).map(own).find(Boolean);
  return near?.map((x) => x.value);
}

/** Of the arrows and rays of a drawing the one that shows a direction: [its start, how long it is drawn]. */
function drawnArrow(figures, dimension, path, v) {
  const names = [spelled(path), spelled(path.slice(0, -1))], long = size(v);
  for (const { kind, whose, label, numbers } of figures) {
    if ((kind !== "arrow" && kind !== "ray") || whose !== "question" || !names.includes(label)) continue;
    const start = numbers.slice(0, dimension).map(Number),
      way = minus(numbers.slice(dimension, 2 * dimension).map(Number), start);
    const times = size(way) / long;
    if (dot(way, v) > 0.999999 * size(way) * long) return [start, times];
  }
  return undefined;
}

/**
 * {path, name, of, at, put}: at: where a handle is; put(p, number): the question after it was moved to p, where number
 * writes one; of: "place", "direction", "length", "plane", "normal". A direction has start, where it begins, and drawn,
 * whether the drawing has its arrow.
 */
export function handlesOf(parts, tree, drawing, view) {
  const dimension = view.isFlat ? 2 : 3, figures = view.isFlat ? drawing.figures : drawing.space, handles = [];
  const written = (path, p, number) => (now) =>
    p.reduce((changed, x, i) => put(changed, [...path, i], number(x)), now);
  for (const { path, kind } of parts) {
    if (handles.length >= mostHandles) break;
    const name = spelled(path), holder = at(tree, path.slice(0, -1)), last = path.at(-1);
    if (kind === "length" && (last === "radius" || last === "margin")) {
      const centre = placeBeside(tree, path), r = at(tree, path).value;
      if (centre?.length !== dimension) continue;
      const moved = (p, number) => put(tree, path, number(size(minus(p, centre))));
      handles.push({ path, name, of: "length", at: centre.map((x, i) => (i ? x : x + r)), put: moved });
    }
    if (kind !== "place" && kind !== "direction") continue;
    const v = valuesAt(tree, path);
    if (v.length !== dimension) continue;
    if (kind === "place")
      handles.push({ path, name, of: "place", at: v, put: (p, number) => written(path, p, number)(tree) });
    else if (last === "normal" && holder?.offset instanceof Numeral && dimension === 3)
      handles.push(...ofPlane(path, name, v, tree, view));
    else handles.push(ofDirection(path, name, v, tree, figures, dimension, view));
  }
  return handles;

  function ofPlane(path, name, normal, whole, seen) {
    const offset = [...path.slice(0, -1), "offset"],
      foot = footOf(normal, at(whole, offset).value, seen.centre),
      long = size(normal);
    if (!(long > 0)) return [];
    const times = (0.2 * seen.span) / long;
    const through = (now, n, p, number) => put(now, offset, number(-dot(n, p)));
    return [
      {
        path: offset,
        name: spelled(offset),
        of: "plane",
        at: foot,
        put: (p, number) => through(whole, normal, p, number),
      },
      {
        path,
        name,
        of: "normal",
        at: plus(foot, normal, times),
        put: (p, number) => {
          const changed = written(
            path,
            minus(p, foot).map((x) => x / times),
            number,
          )(whole);
          return through(changed, valuesAt(changed, path), foot, number);
        },
      },
    ];
  }
  function ofDirection(path, name, v, whole, drawn, dimensions, seen) {
    const shown = drawnArrow(drawn, dimensions, path, v);
    const place = placeBeside(whole, path), zero = v.map(() => 0);
    const start = shown?.[0] ?? (place?.length === v.length ? place : zero), long = size(v) * (shown?.[1] || 1);
    // A tip too near to its start to be held is shown farther away.
    const enough = long > 0 && long < shortest * seen.pixel ? (shortest * seen.pixel) / long : 1,
      times = (shown?.[1] || 1) * enough;
    return {
      path,
      name,
      of: "direction",
      at: plus(start, v, times),
      start,
      drawn: Boolean(shown) && enough === 1,
      put: (p, number) =>
        written(
          path,
          minus(p, start).map((x) => x / times),
          number,
        )(whole),
    };
  }
}
