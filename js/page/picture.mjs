// SPDX-License-Identifier: Apache-2.0
/* global escaped, tenths, viewer */
// The picture of the question and its truth, with handles that the reader drags or moves by keys.
import { handlesOf } from "./handles.mjs";
import { at } from "./question.mjs";
import { View, extentOf, minus, pictureOf, size, ticksOf } from "./view.mjs";

const { width, height } = viewer.size;
const nothing = { figures: [], space: [], notes: [], search: "" };
// Ways of keys: x and y with the arrows, z with the pages.
const ways = {
  ArrowLeft: [-1, 0, 0],
  ArrowRight: [1, 0, 0],
  ArrowUp: [0, 1, 0],
  ArrowDown: [0, -1, 0],
  PageUp: [0, 0, 1],
  PageDown: [0, 0, -1],
};

export class Picture {
  view = new View();
  #drawing = nothing;
  #parts = [];
  #handles = [];
  #held = null;
  #waiting = false;

  /**
   * svg: an element with .ticks, .turning and .handles in it
   * moved(tree): the reader has moved something; turned(): the view; numberAt(pixel): writes numbers where a pixel is
   * so long; stepAt(pixel): how far a key moves a handle
   */
  constructor(svg, { moved, turned, numberAt, stepAt }) {
    this.svg = svg;
    Object.assign(this, { moved, turned, numberAt, stepAt });
    this.view.turnBack();
    svg.addEventListener("pointerdown", (event) => this.#down(event));
    svg.addEventListener("pointermove", (event) => this.#move(event));
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"])
      svg.addEventListener(end, () => {
        this.#held = null;
      });
    svg.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    svg.addEventListener("keydown", (event) => this.#key(event));
  }

  /** The first view of a link, [yaw, pitch], or null for the usual one. */
  turnWith(angles) {
    this.isTurned = angles !== null;
    if (angles) [this.view.yaw, this.view.pitch] = angles;
    else this.view.turnBack();
    this.draw();
  }
  get isHeld() {
    return this.hold !== undefined;
  }
  /** While a handle is dragged an object, another for each drag. */
  get hold() {
    return this.#held?.handle && this.#held;
  }
  /** Shows a question and its figures, in the plane where they are; what has another dimension has no handles. */
  set({ tree, parts, drawing = nothing }, fit = false) {
    this.tree = tree;
    this.#parts = parts;
    this.#drawing = drawing;
    const inSpace = ({ kind, path }) => (kind === "place" || kind === "direction") && at(tree, path).length === 3;
    const flat = drawing.figures.length > 0 || (drawing.space.length === 0 && !parts.some(inSpace));
    if (flat !== this.view.isFlat && drawing !== nothing) fit = true;
    this.view.isFlat = flat;
    if (fit) this.fit(false);
    this.draw();
  }
  fit(byReader = true) {
    const shown = extentOf(this.#drawing, this.view.isFlat);
    if (byReader) this.isTurned = false;
    if (!this.isTurned) this.view.turnBack();
    this.view.fit(shown);
    const handles = handlesOf(this.#parts, this.tree, this.#drawing, this.view).filter(
      ({ of }) => of === "direction" || of === "place",
    );
    this.view.fit([...shown, ...handles.map(({ at }) => at)]);
    this.draw();
    if (byReader) this.turned();
  }

  draw() {
    if (this.#waiting) return;
    this.#waiting = true;
    requestAnimationFrame(() => {
      this.#waiting = false;
      this.#paint();
    });
  }
  #paint() {
    const one = (part) => this.svg.querySelector(part), focused = document.activeElement?.dataset?.handle;
    this.svg.classList.toggle("flat", this.view.isFlat);
    this.#handles = handlesOf(this.#parts, this.tree, this.#drawing, this.view);
    one(".ticks").innerHTML = ticksOf(this.view);
    one(".turning").innerHTML = pictureOf(this.#drawing, this.view);
    one(".handles").innerHTML = this.#handles.map((handle, i) => this.#handleAsSvg(handle, i)).join("");
    if (focused !== undefined) this.svg.querySelector(`[data-handle="${CSS.escape(focused)}"]`)?.focus();
    if (this.#held?.handle)
      this.#held.handle = this.#handles.find(({ name }) => name === this.#held.handle.name) ?? this.#held.handle;
  }
  #handleAsSvg({ name, of, at, start, drawn }, i) {
    const [x, y] = this.view.seen(at).map(tenths);
    if (![x, y].every((each) => Math.abs(each) < 1e5)) return "";
    const foot = of === "direction" && !drawn ? this.view.seen(start).map(tenths) : null;
    const stem = foot ? `<path class="aid stroke" stroke-dasharray="2 3" d="M${foot.join(" ")}L${x} ${y}"/>` : "";
    const mark =
      {
        place: `<circle class="mark" cx="${x}" cy="${y}" r="4.5"/>`,
        length: `<path class="mark" d="M${x - 5} ${y}l5 -5 5 5 -5 5z"/>`,
        plane: `<path class="mark" d="M${x - 4.5} ${y - 4.5}h9v9h-9z"/>`,
      }[of] ?? `<circle class="mark tip" cx="${x}" cy="${y}" r="5"/>`;
    const words = {
      place: "point",
      direction: "vector",
      length: "radius",
      plane: "plane",
      normal: "normal of a plane",
    }[of];
    return (
      `<g class="handle" data-handle="${escaped(name)}" tabindex="${i ? -1 : 0}" role="slider" aria-valuenow="0" ` +
      `aria-label="${escaped(`${words} ${name}`)}" aria-valuetext="${at.map((v) => +v.toPrecision(6)).join(", ")}">` +
      `<title>${escaped(`${words} ${name}`)}</title>${stem}` +
      `<circle class="grip" cx="${x}" cy="${y}" r="14" fill-opacity="0"/>${mark}</g>`
    );
  }

  /** Of a pointer, in pixels of the viewer. */
  #pixel(event) {
    const box = this.svg.getBoundingClientRect(), scale = width / box.width;
    return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
  }
  #down(event) {
    if (event.button !== 0) return;
    const [x, y] = this.#pixel(event);
    // Where grips overlap, the handle nearest to the pointer.
    const near = event.target.closest(".handle")
      ? this.#handles
          .map((handle) => ({ handle, beside: minus([x, y], this.view.seen(handle.at)) }))
          .sort((one, other) => size(one.beside) - size(other.beside))[0]
      : {};
    this.#held = { id: event.pointerId, x, y, ...near };
    this.svg.setPointerCapture(event.pointerId);
    if (near.handle)
      this.svg.querySelector(`[data-handle="${CSS.escape(near.handle.name)}"]`).focus({ preventScroll: true });
    event.preventDefault();
  }
  #move(event) {
    const held = this.#held;
    if (!held || held.id !== event.pointerId) return;
    const [x, y] = this.#pixel(event);
    if (held.handle) {
      const [atX, atY] = this.view.seen(held.handle.at);
      this.#put(held.handle, this.view.across(x - held.beside[0] - atX, y - held.beside[1] - atY));
    } else {
      if (this.view.isFlat) this.view.move(x - held.x, y - held.y);
      else if (event.shiftKey) this.view.move(x - held.x, y - held.y);
      else this.#turn((held.x - x) / 120, (y - held.y) / 120);
      this.draw();
      this.turned();
    }
    held.x = x;
    held.y = y;
  }
  #turn(byYaw, byPitch) {
    this.isTurned = true;
    this.view.yaw += byYaw;
    this.view.pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.view.pitch + byPitch));
  }
  /** Moves a handle; coordinates across which it does not move stay as they were typed. */
  #put(handle, way, number = this.numberAt(this.view.pixel)) {
    const there = handle.at.map((x, i) => x + way[i]);
    if (!there.every(Number.isFinite)) return;
    const tree = handle.put(there, number);
    this.tree = tree;
    this.moved(tree);
    // The next event may come before the next frame.
    const again = handlesOf(this.#parts, tree, this.#drawing, this.view).find(({ name }) => name === handle.name);
    if (again && this.#held) this.#held.handle = again;
    this.draw();
  }
  #wheel(event) {
    event.preventDefault();
    this.zoom(Math.exp(event.deltaY / 500), this.#pixel(event));
  }
  zoom(times, pixel) {
    this.view.zoom(times, pixel);
    this.draw();
    this.turned();
  }
  /** A handle moves by a step along an axis, the view turns or moves; Tab and Shift go from handle to handle. */
  #key(event) {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const way = ways[event.key], name = event.target.closest(".handle")?.dataset.handle;
    const handle = this.#handles.find((each) => each.name === name);
    if (handle && way) {
      this.#put(
        handle,
        way.map((x) => x * this.stepAt(this.view.pixel)),
      );
    } else if (handle && (event.key === "n" || event.key === "p")) {
      const i = this.#handles.indexOf(handle) + (event.key === "n" ? 1 : this.#handles.length - 1);
      this.svg.querySelector(`[data-handle="${CSS.escape(this.#handles[i % this.#handles.length].name)}"]`)?.focus();
    } else if (way) {
      if (this.view.isFlat) this.view.move(-20 * way[0], 20 * way[1]);
      else this.#turn((-way[0] * Math.PI) / 24, (-way[1] * Math.PI) / 24);
      this.draw();
      this.turned();
    } else if (event.key === "+" || event.key === "=") this.zoom(0.8);
    else if (event.key === "-") this.zoom(1.25);
    else if (event.key === "Home") this.fit();
    else return;
    event.preventDefault();
  }
}

/** A small picture of a drawing, in its own frame. */
export function thumbnail(drawing) {
  const view = new View();
  view.isFlat = drawing.figures.length > 0;
  view.turnBack();
  view.fit(extentOf(drawing, view.isFlat));
  const plain = (figures) =>
    figures.map((figure) => ({ ...figure, label: figure.whose === "question" && figure.label ? figure.label : "" }));
  const svg = pictureOf({ ...drawing, figures: plain(drawing.figures), space: plain(drawing.space) }, view);
  return `<svg class="fig space flat thumbnail" viewBox="0 0 ${width} ${height}" aria-hidden="true">` +
    `<g class="turning">${svg}</g></svg>`;
}
