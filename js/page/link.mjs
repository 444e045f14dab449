// SPDX-License-Identifier: Apache-2.0
// All that the reader has chosen, as the fragment of the page's address. Nothing of it is sent to a server.

/** Texts by name; what is empty is left out. */
export const fragmentOf = (chosen) =>
  "#" +
  Object.entries(chosen)
    .filter(([, text]) => text !== "" && text !== undefined)
    .map(([name, text]) => `${name}=${encodeURIComponent(text).replaceAll("%2C", ",").replaceAll("%3A", ":")}`)
    .join("&");

export function chosenIn(fragment) {
  const chosen = {};
  for (const pair of fragment.replace(/^#/, "").split("&")) {
    const [, name, text] = /^([a-z]+)=(.*)$/s.exec(pair) ?? [];
    if (name)
      try {
        chosen[name] = decodeURIComponent(text);
      } catch {
        // A link that was cut: what is whole of it is taken.
      }
  }
  return chosen;
}
