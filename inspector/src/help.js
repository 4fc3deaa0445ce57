// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

import { element } from "./dom.js";

const sections = {
  Mouse: [
    ["point", "relation values of an edge; facts and edges of a patch"],
    ["click", "pin it; then point at another patch to see what relates the two"],
    ["drag, wheel", "move and zoom; in 3D orbit (right button: move)"],
    ["double click", "fit the scene into the view"],
  ],
  Keys: [
    ["1 – 9", "show or hide a layer; with Shift only this layer"],
    ["↑ ↓", "next edge of the list; in 3D, once it is clicked, orbit"],
    ["[ ]", "next value of the solver's parameter where the cut changes"],
    ["\\", "the parameter as it was"],
    ["v", "layers or 3D"],
    ["+ − 0", "zoom, fit"],
    ["n p", "next, previous scene"],
    ["t", "light, dark"],
    ["Esc", "unpin"],
    ["?", "this help"],
  ],
};

const contribution =
  "A value's contribution is p, less the mean of the p that the pair would have were this one value anything of its " +
  "range in training and all others as they are (five values, evenly over the range). Positive speaks for one " +
  "object. Values act together, so that contributions need not add up to p.";

export const make_help = () => {
  const dialog = element(
    "dialog",
    { class: "help", "aria-label": "Help" },
    Object.entries(sections)
      .map(([title, rows]) => [
        element("h2", {}, title),
        element(
          "dl",
          {},
          rows.map(([key, text]) => [element("dt", {}, element("kbd", {}, key)), element("dd", {}, text)]),
        ),
      ])
      .flat(),
    element("h2", {}, "Contributions"),
    element("p", {}, contribution),
    element("h2", {}, "The slider"),
    element(
      "p",
      {},
      "Each cut was made by the solver itself when this page was written, for the values that the slider stops at.",
    ),
    element("form", { method: "dialog" }, element("button", { class: "primary" }, "Close")),
  );
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  return dialog;
};
