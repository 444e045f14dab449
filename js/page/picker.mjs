// SPDX-License-Identifier: Apache-2.0
/* global escaped */
// The list of all operations, with a picture of each: by chapter, or those of which the reader types a word.
import { thumbnail } from "./picture.mjs";

export class Picker {
  /** dialog: has input and .operations; drawing(name, question): asks for figures; pick(name). */
  constructor(dialog, { operations, drawing, pick }) {
    Object.assign(this, { dialog, operations, drawing });
    const list = dialog.querySelector(".operations"), search = dialog.querySelector("input");
    const card = ({ name, question }) =>
      `<li data-name="${name}"><button type="button"><span class="picture"></span>` +
      `<strong>${escaped(name.replaceAll("_", " "))}</strong>` +
      `<span class="small quiet">${escaped(question)}</span></button></li>`;
    const chapters = [...new Set(operations.map(({ chapter }) => chapter))];
    list.innerHTML = chapters
      .map(
        (chapter) =>
          `<section><h3>${escaped(chapter.replaceAll("_", " "))}</h3><ul>` +
          `${operations
            .filter((each) => each.chapter === chapter)
            .map(card)
            .join("")}</ul></section>`,
      )
      .join("");
    list.addEventListener("click", ({ target }) => {
      const name = target.closest("li")?.dataset.name;
      if (!name) return;
      dialog.close();
      pick(name);
    });
    search.addEventListener("input", () => this.#filter(search.value));
    search.addEventListener("keydown", (event) => {
      if (event.key !== "Enter") return;
      event.preventDefault();
      const named = search.value.trim().toLowerCase().replace(/[\s_]+/g, "_");
      const found = list.querySelector(`[data-name="${CSS.escape(named)}"]`) ?? list.querySelector("li:not([hidden])");
      found?.querySelector("button").click();
    });
    dialog.querySelector(".close").addEventListener("click", () => dialog.close());
    dialog.addEventListener("click", ({ target }) => target === dialog && dialog.close());
  }

  open(current) {
    this.dialog.showModal();
    const search = this.dialog.querySelector("input");
    search.value = "";
    this.#filter("");
    search.focus();
    this.dialog.querySelector(`[data-name="${current}"]`)?.scrollIntoView({ block: "center" });
    if (!this.drawn) this.drawn = this.#draw();
  }
  #filter(text) {
    const words = text
      .toLowerCase()
      .split(/[\s_]+/)
      .filter(Boolean);
    for (const item of this.dialog.querySelectorAll("li")) {
      const has = item.textContent.toLowerCase();
      item.hidden = !words.every((word) => has.includes(word));
    }
    for (const section of this.dialog.querySelectorAll("section"))
      section.hidden = !section.querySelector("li:not([hidden])");
  }
  async #draw() {
    for (const { name, example } of this.operations) {
      const place = this.dialog.querySelector(`[data-name="${name}"] .picture`);
      const drawing = await this.drawing(name, JSON.stringify(example)).catch(() => null);
      if (drawing && drawing.figures.length + drawing.space.length > 0) place.innerHTML = thumbnail(drawing);
    }
  }
}
