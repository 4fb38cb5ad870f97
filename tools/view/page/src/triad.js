// SPDX-License-Identifier: BSD-3-Clause
// The directions of x, y and z in a corner of the picture.
import { Vector3 } from "three";

import { byId } from "./elements.js";

const AXES = [
  { name: "x", colour: "#c0392b", direction: new Vector3(1, 0, 0) },
  { name: "y", colour: "#2e8b57", direction: new Vector3(0, 1, 0) },
  { name: "z", colour: "#2563b0", direction: new Vector3(0, 0, 1) },
];

/** Length of an axis, in pixels. */
const LENGTH = 25;

function svg(tag, attributes, content = "") {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.textContent = content;
  return element;
}

export function addTriad(space) {
  const drawing = byId("triad");
  space.afterDraw.push(() => {
    const turned = AXES.map((axis) => ({
      ...axis,
      at: axis.direction.clone().transformDirection(space.camera.matrixWorldInverse),
    }));
    turned.sort((a, b) => a.at.z - b.at.z);
    drawing.replaceChildren(
      ...turned.flatMap(({ name, colour, at }) => {
        const x = LENGTH * at.x,
          y = -LENGTH * at.y;
        return [
          svg("line", { x1: 0, y1: 0, x2: x, y2: y, stroke: colour, "stroke-width": 2 }),
          svg("text", { x: 1.4 * x, y: 1.4 * y, fill: colour }, name),
        ];
      }),
    );
  });
}
