// SPDX-License-Identifier: Apache-2.0
// As much of a browser as the scripts of a report's pages need.
import {readFileSync} from 'node:fs';

export const plain = html => html.replace(/<[^>]*>/g, '').replace(/&#(\d+);/g, (_, n) => String.fromCharCode(n))
    .replace(/&quot;/g, '"').replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&amp;/g, '&');

// What the script of a page defines with these names, made of these files of report/scripts/, with this document.
export const defined = (names, files, document) => {
  const text = name => readFileSync(new URL('../../../report/scripts/' + name, import.meta.url), 'utf8');
  return new Function('document', files.map(text).join('') + `\nreturn [${names}];`)(document);
};

export class Element {
  constructor(width = 0) {
    Object.assign(this, {width, style: {}, dataset: {}, heard: {}, innerHTML: '', parts: {}, attributes: {}});
    this.classList = {add() {}};
  }
  addEventListener(type, listener) { (this.heard[type] ??= []).push(listener); }
  // Whether a listener has dealt with the event.
  send(type, event) {
    let prevented = false;
    for (const listener of this.heard[type] ?? [])
      listener({button: 0, pointerId: 1, preventDefault() { prevented = true; }, ...event});
    return prevented;
  }
  append(child) { this.child = child; }
  closest() { return this.frame; }
  insertAdjacentHTML(_, html) { this.innerHTML += html; }
  getAttribute(name) { return this.attributes[name]; }
  setAttribute(name, value) { this.attributes[name] = value; }
  get src() { return this.attributes.src; }
  getBoundingClientRect() { return {left: 0, top: 0, width: this.width, height: this.width}; }
  setPointerCapture() {}
  scrollIntoView() { this.scrolled = true; }
  querySelectorAll(selector) { return this.parts[selector]; }
  querySelector(selector) { return (this.parts[selector] ??= [new Element()])[0]; }
}

// A document in which these are the elements of each selector.
export const documentOf = elements => ({
  querySelectorAll: selector => elements[selector] ?? [],
  createElement: () => new Element(),
});
