// SPDX-License-Identifier: BSD-3-Clause
// Lines of some pixels of width: contours, the outline of the marked face, control meshes and
// ellipses.
import { BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

export class Lines {
  constructor({ width, colour = 0xffffff, opacity = 1, hasColours = false, isOnTop = false }) {
    this.material = new LineMaterial({
      color: new Color(colour),
      linewidth: width,
      vertexColors: hasColours,
      transparent: opacity < 1 || isOnTop,
      opacity,
      depthTest: !isOnTop,
    });
    this.object = new LineSegments2(new LineSegmentsGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.visible = false;
    if (isOnTop) this.object.renderOrder = 1;
  }

  /** Segments as x, y, z of both ends; colours likewise as red, green, blue from 0 to 1. */
  set(positions, colours = null) {
    this.object.geometry.dispose();
    this.object.geometry = new LineSegmentsGeometry();
    this.isEmpty = positions.length === 0;
    this.object.visible = !this.isEmpty;
    if (this.isEmpty) return;
    this.object.geometry.setPositions(positions);
    if (colours) this.object.geometry.setColors(colours);
  }

  show(isShown) {
    this.object.visible = isShown && !this.isEmpty;
  }
}

/** The same of one pixel, which cost a tenth. */
export class HairLines {
  constructor() {
    this.object = new LineSegments(
      new BufferGeometry(),
      new LineBasicMaterial({ vertexColors: true }),
    );
    this.object.frustumCulled = false;
  }

  set(positions, colours) {
    this.object.geometry.dispose();
    this.object.geometry = new BufferGeometry();
    this.object.geometry.setAttribute(
      "position",
      new BufferAttribute(new Float32Array(positions), 3),
    );
    this.object.geometry.setAttribute("color", new BufferAttribute(new Float32Array(colours), 3));
  }
}

/** The closed line through points, as segments. */
export function closedLine(points) {
  return points.flatMap((p, i) => [...p, ...points[(i + 1) % points.length]]);
}

/** sRGB bytes as three.js wants the colours of vertices. */
export function linear(rgb) {
  const colour = new Color().setRGB(rgb[0] / 255, rgb[1] / 255, rgb[2] / 255, "srgb");
  return [colour.r, colour.g, colour.b];
}
