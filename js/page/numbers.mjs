// SPDX-License-Identifier: Apache-2.0
/* global escaped */
// The parts of a question as fields to type into, each number with buttons that move it by an ulp.
import { stepped } from "./doubles.mjs";
import { at, numbersOf, numeral, Numeral, parsed, put, resized, spelled } from "./question.mjs";

const mostNumbers = 300;
const by = { ArrowUp: 1, ArrowDown: -1, PageUp: 1000, PageDown: -1000 };
const axes = ["x", "y", "z"];

const pathOf = (path) => `data-path="${escaped(JSON.stringify(path))}"`;
const button = (path, attributes, name, words) =>
  `<button type="button" ${pathOf(path)} ${attributes} aria-label="${name}">${words}</button>`;
const numberField = (path, tree, name) =>
  `<span class="number">${button(path, 'data-ulps="-1"', `${name}: one ulp less`, "\u2212")}` +
  `<input inputmode="decimal" autocomplete="off" spellcheck="false" ${pathOf(path)} aria-label="${name}" ` +
  `value="${escaped(at(tree, path).text)}" size="8">` +
  `${button(path, 'data-ulps="1"', `${name}: one ulp more`, "+")}</span>`;

function fieldOf(part, tree) {
  const name = escaped(spelled(part.path)), value = at(tree, part.path);
  if (part.kind === "word" || part.kind === "flag") {
    const option = (word) =>
      `<option value="${escaped(JSON.stringify(word))}"${word === value ? " selected" : ""}>${word}</option>`;
    const options = (part.words ?? [true, false]).map(option).join("");
    return `<select ${pathOf(part.path)} aria-label="${name}">${options}</select>`;
  }
  if (part.kind === "list") {
    const less = `data-longer="false"${value.length > 1 ? "" : " disabled"}`;
    return `<span class="quiet">${value.length} in all</span>` +
      button(part.path, 'data-longer="true"', `${name}: one more`, "add") +
      button(part.path, less, `${name}: one less`, "remove");
  }
  const paths = numbersOf(part, tree);
  return paths.map((path, i) => numberField(path, tree, paths.length > 1 ? `${name} ${axes[i]}` : name)).join("");
}

export class Numbers {
  /** place: the element for the fields; changed(tree): the reader has changed one. */
  constructor(place, changed) {
    this.place = place;
    place.addEventListener("click", ({ target, shiftKey }) => {
      const { ulps, longer, path } = target.closest("button")?.dataset ?? {};
      if (longer)
        changed(put(this.tree, JSON.parse(path), resized(at(this.tree, JSON.parse(path)), longer === "true")));
      if (ulps) this.#nudge(JSON.parse(path), Number(ulps) * (shiftKey ? 10 : 1));
    });
    place.addEventListener("keydown", (event) => {
      const path = event.target.matches("input") && event.target.dataset.path, ulps = by[event.key];
      if (!path || !ulps) return;
      event.preventDefault();
      this.#nudge(JSON.parse(path), ulps * (event.shiftKey ? 10 : 1));
    });
    place.addEventListener("change", ({ target }) => {
      if (target.matches("select"))
        changed(put(this.tree, JSON.parse(target.dataset.path), JSON.parse(target.value)));
    });
    place.addEventListener("input", (event) => {
      if (!event.target.matches("input")) return;
      const value = typedNumber(event.target.value);
      event.target.toggleAttribute("aria-invalid", !value);
      if (value) changed(put(this.tree, JSON.parse(event.target.dataset.path), value));
    });
    this.changed = changed;
  }
  #nudge(path, ulps) {
    this.changed(put(this.tree, path, numeral(stepped(at(this.tree, path).value, ulps))));
  }

  set({ tree, parts }) {
    const shape = JSON.stringify(parts.map(({ path, words }) => [path, words]));
    this.tree = tree;
    if (shape !== this.shape) {
      this.shape = shape;
      let shown = 0;
      const rows = parts.filter((part) => (shown += Math.max(1, numbersOf(part, tree).length)) <= mostNumbers);
      const meaning = { direction: " (vector)", length: "", place: "" };
      this.place.innerHTML =
        rows
          .map(
            (part) =>
              `<div class="field"><span class="name">${escaped(spelled(part.path))}` +
              `<span class="quiet">${meaning[part.kind] ?? ""}</span></span>${fieldOf(part, tree)}</div>`,
          )
          .join("") +
        (rows.length < parts.length
          ? `<p class="small quiet">${parts.length - rows.length} more parts: change them in the text.</p>`
          : "");
      return;
    }
    for (const input of this.place.querySelectorAll("input")) {
      const { text } = at(tree, JSON.parse(input.dataset.path));
      // Not while it is typed: "0." is not a number yet.
      if (
        input.value !== text &&
        !(input === document.activeElement && typedNumber(input.value)?.value === Number(text))
      ) {
        input.value = text;
        input.removeAttribute("aria-invalid");
      }
    }
    for (const select of this.place.querySelectorAll("select"))
      select.value = JSON.stringify(at(tree, JSON.parse(select.dataset.path)));
  }
}

/** A number as it was typed; undefined if it is none. */
function typedNumber(text) {
  try {
    const value = parsed(text.trim().replace("\u2212", "-").replace(/^\+/, ""));
    return value instanceof Numeral && Number.isFinite(value.value) ? value : undefined;
  } catch {
    return undefined;
  }
}
