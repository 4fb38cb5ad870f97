// SPDX-License-Identifier: BSD-3-Clause
// Makes elements of the page. Texts are always set as text, never as markup: they come from models.

/** make("button", {class: "x", title: "…", onclick: act}, "text", child, …) */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (typeof value === "boolean") element[name] = value;
    else element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

export const byId = (id) => document.getElementById(id);

export const css = (rgb) => `rgb(${rgb.join(" ")})`;

/** A small square of a colour. */
export function swatch(rgb) {
  const element = make("span", { class: "swatch" });
  element.style.background = css(rgb);
  return element;
}

/** A table of two columns: names and values, which may be elements. */
export function pairs(rows) {
  const shown = rows.filter(([, value]) => value !== null && value !== undefined);
  return make(
    "dl",
    { class: "pairs" },
    ...shown.flatMap(([name, value]) => [make("dt", {}, name), make("dd", {}, value)]),
  );
}

/** A part of the panel that can be folded; folded parts stay out of the way of short meshes. */
export function section(id, title, isOpen = true) {
  const body = make("div", { class: "body" });
  const count = make("span", { class: "count" });
  const element = make("details", { id, class: "section", open: isOpen });
  element.append(make("summary", {}, title, count), body);
  byId("panel").append(element);
  return { element, body, count };
}

/** 12345 as 12 345. */
export const whole = (number) => Math.round(number).toLocaleString("en").replaceAll(",", "\u202f");
