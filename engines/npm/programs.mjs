// SPDX-License-Identifier: Apache-2.0
// Programs of bodies and commands, for packages that keep boxes. A structure has insert(box), which returns the body's
// index, move(body, box), remove(body), pairs() and in_box(box).

const point_box = (point) => ({ min: point, max: point });
const boxes_of = ({ boxes, commands }) => [
  ...boxes,
  ...commands.flatMap(({ insert, box, in_box, at_point }) => {
    return insert ?? box ?? in_box ?? (at_point ? point_box(at_point) : []);
  }),
];
export const has_ray = ({ commands }) => commands.some((command) => command.along_ray);

/** The two axes that decide, where on the third all boxes, those of queries too, have a number in common: there boxes
 * meet where their rectangles do. */
export function deciding_axes(program) {
  const all = boxes_of(program);
  const decides_nothing = (k) =>
    all.reduce((most, { min }) => Math.max(most, min[k]), -Infinity) <=
    all.reduce((least, { max }) => Math.min(least, max[k]), Infinity);
  const idle = [2, 1, 0].find(decides_nothing);
  return idle === undefined ? undefined : [0, 1, 2].filter((k) => k !== idle);
}

/** The replies of a structure to a program. */
export function replies(structure, { boxes, commands }) {
  for (const box of boxes) structure.insert(box);
  const found = [];
  for (const command of commands) {
    if (command.insert) structure.insert(command.insert);
    else if (command.box) structure.move(command.move, command.box);
    else if ("remove" in command) structure.remove(command.remove);
    else if (command.ask) found.push({ pairs: structure.pairs() });
    else found.push({ bodies: structure.in_box(command.in_box ?? point_box(command.at_point)) });
  }
  return { replies: found };
}
