// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

import { element } from "./dom.js";

const sections = {
  Mouse: [
    ["point", "show the relation values of an edge, or the details and edges of a patch"],
    ["click", "pin it; then point at another patch to see how the two are related"],
    ["drag, wheel", "move and zoom; in 3D orbit (right button: move)"],
    ["double click", "fit the scene into the view"],
  ],
  Keys: [
    ["1 – 9 e", "show or hide a layer; with Shift only this layer"],
    ["↑ ↓", "next edge of the list; in 3D, once it is clicked, orbit"],
    ["[ ]", "next value of the solver's parameter where the cut changes"],
    ["\\", "reset the parameter"],
    ["v", "switch between layers and 3D"],
    ["+ − 0", "zoom, fit"],
    ["n p", "next, previous scene"],
    ["t", "light, dark"],
    ["Esc", "unpin"],
    ["?", "this help"],
  ],
};

const contribution =
  "A value's contribution is p minus the mean p over five values of this one relation value, evenly spaced over its " +
  "training range, with all other values unchanged. A positive contribution supports one object. Values interact, so " +
  "contributions need not add up to p.";

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
      "The solver itself computed each cut when this page was written, for the values at which the slider stops.",
    ),
    element("form", { method: "dialog" }, element("button", { class: "primary" }, "Close")),
  );
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  return dialog;
};
