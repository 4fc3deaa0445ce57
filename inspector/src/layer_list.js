// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

import { closure_colour, css, depth_colour, edge_colours, image_edge_colours, line_colours } from "./colours.js";
import { element } from "./dom.js";
import { layers } from "./layers.js";
import { edge_filters } from "./overlay.js";

const key_line = (colour, text, dashed = false) =>
  element("li", {}, element("span", { class: dashed ? "dash" : "stroke", style: { "--colour": css(colour) } }), text);

const legends = {
  depth: (scene) => {
    const stops = Array.from({ length: 9 }, (_, i) => css(depth_colour(i / 8))).join(",");
    const [near, far] = scene.depth_range ?? [0, 0];
    return element(
      "div",
      { class: "ramp" },
      element("span", {}, near.toFixed(2)),
      element("span", { class: "bar", style: { background: `linear-gradient(90deg,${stops})` } }),
      element("span", {}, `${far.toFixed(2)} m`),
    );
  },
  lines: () =>
    element(
      "ul",
      { class: "keys" },
      Object.entries({
        farther: "before something farther",
        level: "at something as near",
        nothing: "before no depth",
        nearer: "hidden by something nearer",
      }).map(([kind, text]) => key_line(line_colours[kind], text)),
    ),
  closures: (scene) =>
    element("ul", { class: "keys" }, key_line(closure_colour, `${scene.closures.length}, the cheapest strongest`)),
  edges: (scene) =>
    element(
      "ul",
      { class: "keys" },
      key_line(image_edge_colours[0], "edge of the colour image"),
      scene.image_edges?.includes(2) ? key_line(image_edge_colours[1], "patches cut along it") : null,
    ),
  graph: (scene) =>
    element(
      "ul",
      { class: "keys" },
      key_line(edge_colours.likely, "p ≥ ½"),
      key_line(edge_colours.unlikely, "p < ½"),
      scene.truth ? key_line(edge_colours.wrong, "p against ground truth") : null,
      key_line([150, 155, 162], "dashed: cut apart", true),
    ),
};

/// change(): state was changed.
export const make_layer_list = (state, change) => {
  const rows = {};
  const filter = element("select", {
    "aria-label": "Edges of the graph layer",
    onchange: () => {
      state.filter = filter.value;
      change();
    },
  });
  const list = element(
    "ul",
    { class: "layers" },
    layers.map(({ id, key, name, text }, i) => {
      const box = element("input", {
        type: "checkbox",
        id: `layer-${id}`,
        onchange: () => {
          state.visible[id] = box.checked;
          change();
        },
      });
      const opacity = element("input", {
        type: "range",
        min: 0,
        max: 1,
        step: 0.05,
        "aria-label": `Opacity of ${name}`,
        oninput: () => {
          state.opacity[id] = Number(opacity.value);
          change();
        },
      });
      const legend = element("div", { class: "legend" });
      rows[id] = { box, opacity, legend };
      return element(
        "li",
        { title: text },
        box,
        element("label", { for: `layer-${id}` }, element("kbd", { "aria-hidden": "true" }, key ?? String(i + 1)), name),
        opacity,
        legend,
        id === "graph" ? filter : null,
      );
    }),
  );
  return {
    root: element("section", { "aria-label": "Layers" }, element("h2", {}, "Layers"), list),
    open: (scene) => {
      rows.truth.box.disabled = rows.truth.opacity.disabled = !scene.truth;
      for (const id of ["colour", "edges"]) rows[id].box.disabled = rows[id].opacity.disabled = !scene.colour;
      filter.replaceChildren(
        ...Object.entries(edge_filters)
          .filter(([, one]) => scene.truth || !one.needs_truth)
          .map(([value, { name }]) => element("option", { value }, name)),
      );
    },
    show: (scene) => {
      for (const { id } of layers) {
        const { box, opacity, legend } = rows[id];
        const visible = Boolean(state.visible[id]) && !box.disabled;
        box.checked = visible;
        opacity.value = state.opacity[id];
        if (legend.hidden !== !visible || legend.dataset.scene !== String(scene.index)) {
          legend.dataset.scene = scene.index;
          legend.hidden = !visible;
          legend.replaceChildren(...(visible && legends[id] ? [legends[id](scene)] : []));
        }
      }
      filter.value = state.filter;
      filter.hidden = !state.visible.graph;
    },
  };
};
