// SPDX-License-Identifier: Apache-2.0
/* global escaped */
// Maps of the questions around one: two of its numbers move by units in the last place, a square for each question.
import { at, numbersOf, numeral, put, spelled } from "./question.mjs";

const side = 41, middle = (side - 1) / 2, pixels = 8;
const tints = ["--q0", "--q1", "--q2", "--q3", "--link", "--truth"];
const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class Maps {
  #axes = null;
  #asked = 0;

  /** place: the element of the maps; map: asks for one; go(tree): to a neighbour; chosen(): other axes. */
  constructor(place, { map, go, chosen }) {
    Object.assign(this, { place, map, go, chosen });
    place.addEventListener("click", ({ target, offsetX, offsetY }) => {
      if (!target.matches("canvas")) return;
      const scale = side / target.clientWidth;
      this.#goTo(Math.floor(offsetX * scale) - middle, Math.floor(offsetY * scale) - middle);
    });
    place.addEventListener("keydown", (event) => {
      const way = event.target.matches("canvas") && ways[event.key];
      if (!way) return;
      event.preventDefault();
      this.#goTo(...way);
    });
    place.addEventListener("change", () => {
      this.#axes = [...place.querySelectorAll("select")].map(({ value }) => Number(value));
      this.chosen();
      this.show(this.question);
    });
  }

  get axes() {
    return this.#axes;
  }
  set axes(axes) {
    this.#axes = axes;
  }

  /** Asks for the maps of a question: {operation, tree, parts, text}. */
  async show(question) {
    this.question = question;
    const { operation, tree, parts, text } = question, asked = ++this.#asked;
    const paths = parts.filter(({ kind }) => kind !== "index").flatMap((part) => numbersOf(part, tree)),
      most = paths.length;
    if (most < 2) return this.#say("This question has no two numbers.");
    const axes =
      this.#axes?.every((axis) => axis < most) && this.#axes[0] !== this.#axes[1] ? this.#axes : operation.axes;
    const names = paths.map(spelled);
    try {
      const [double, float] = await Promise.all(
        [false, true].map((binary32) => this.map(operation.name, text, { axes, side, float: binary32 })),
      );
      if (asked === this.#asked) this.#draw({ double, float, axes, names, paths });
    } catch (failure) {
      if (asked === this.#asked) this.#say(failure.rule ?? failure.message);
    }
  }
  #say(words) {
    this.place.innerHTML = `<p>${escaped(words)}</p>`;
  }

  #draw({ double, float, axes, names, paths }) {
    this.shown = { double, paths: double.fields.map((field) => paths[names.indexOf(field)]) };
    const truths = [...new Set(double.truths.flat())].sort();
    const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim() || "#888";
    const verdictColour = (verdict) => (verdict === "refused" ? colour("--paper") : colour(`--${verdict}`));
    const truthColour = (truth) =>
      truth === "refused" ? colour("--paper") : colour(tints[truths.indexOf(truth) % tints.length]);
    const views = [
      ["formula in double", double.verdicts, verdictColour],
      ["formula in float", float.verdicts, verdictColour],
      ["the truth", double.truths, truthColour],
    ];
    const options = (chosen) =>
      names
        .map((name, i) => `<option value="${i}"${i === chosen ? " selected" : ""}>${escaped(name)}</option>`)
        .join("");
    const focused = [...this.place.querySelectorAll("canvas, select")].indexOf(document.activeElement);
    this.place.innerHTML =
      `<p class="controls"><label>to the right <select>${options(axes[0])}</select></label>` +
      `<label>upwards <select>${options(axes[1])}</select></label></p>` +
      `<div class="maps">${views
        .map(
          ([words, cells, colourOf]) =>
            `<figure class="map"><canvas width="${side * pixels}" height="${side * pixels}" ` +
            `tabindex="0" role="img" aria-label="${words}: ${escaped(inWords(cells))}"></canvas>` +
            `<figcaption>${words}</figcaption>${legend(cells, colourOf)}</figure>`,
        )
        .join("")}</div>` +
      `<p class="small quiet">${side} x ${side} questions, this one in the middle; a square is a unit in the last ` +
      `place (${double.steps.map((step) => Number(step).toExponential(1)).join(" and ")}). ` +
      "A click or an arrow key goes to a neighbour.</p>";
    [...this.place.querySelectorAll("canvas")].forEach((canvas, k) => {
      const pen = canvas.getContext("2d"), [, cells, colourOf] = views[k];
      cells.forEach((row, j) =>
        row.forEach((cell, i) => {
          pen.fillStyle = colourOf(cell);
          pen.fillRect(i * pixels, j * pixels, pixels, pixels);
        }),
      );
      pen.strokeStyle = colour("--ink");
      pen.lineWidth = 2;
      pen.strokeRect(middle * pixels, middle * pixels, pixels, pixels);
    });
    this.place
      .querySelectorAll("[data-colour]")
      .forEach((swatch) => swatch.style.setProperty("--c", swatch.dataset.colour));
    this.place.querySelectorAll("canvas, select")[focused]?.focus({ preventScroll: true });
  }

  #goTo(right, down) {
    if (!this.shown || this.shown.paths.some((path) => !path)) return;
    const [across, up] = this.shown.paths, [dx, dy] = this.shown.double.steps.map(Number);
    const moved = (tree, path, by) => (by === 0 ? tree : put(tree, path, numeral(at(tree, path).value + by)));
    this.go(moved(moved(this.question.tree, across, right * dx), up, -down * dy));
  }
}

const counted = (cells) =>
  Object.entries(cells.flat().reduce((sum, cell) => ({ ...sum, [cell]: 1 + (sum[cell] ?? 0) }), {})).sort(
    ([, a], [, b]) => b - a,
  );
const inWords = (cells) =>
  counted(cells)
    .map(([word, n]) => `${word} ${n}`)
    .join(", ");
const legend = (cells, colourOf) =>
  `<ul class="legend">${counted(cells)
    .map(
      ([word, n]) =>
        `<li><span class="swatch" data-colour="${colourOf(word)}"></span>${escaped(word.replaceAll("_", " "))} ` +
        `<b>${n}</b></li>`,
    )
    .join("")}</ul>`;
