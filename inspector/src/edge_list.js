// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The list of edges: sorted, filtered, and only as many rows in the document as are seen.

import { clamp, element, once_a_frame } from "./dom.js";
import { edge_filters, is_wrong } from "./overlay.js";
import { level_name } from "./scene.js";
import { p_bar, p_text, verdict } from "./relations.js";

const row_height = 26; // px, as in style.css

const by = (key) => (x, y) => key(y) - key(x) || x.index - y.index;
const orders = {
  wrongest: { name: "Largest error first", needs_truth: true, compare: by((edge) => edge.error ?? -1) },
  doubtful: { name: "Least certain first", compare: by((edge) => edge.doubt) },
  likely: { name: "Most likely first", compare: by((edge) => edge.p) },
  unlikely: { name: "Least likely first", compare: by((edge) => -edge.p) },
  patches: { name: "By patch", compare: (x, y) => x.index - y.index },
};

const list_filters = {
  all: { name: "All levels", test: () => true },
  structural: edge_filters.structural,
  assembly: edge_filters.assembly,
  wrong: { ...edge_filters.wrong, name: "Wrong only" },
};

/// choose(edge): an edge was chosen here.
export const make_edge_list = (choose) => {
  let scene = null,
    rows = [],
    chosen = null,
    patch = null;
  const order = element("select", { "aria-label": "Order of the edges", onchange: () => refresh() });
  const filter = element("select", { "aria-label": "Edges in the list", onchange: () => refresh() });
  const count = element("span", { class: "dim count", "aria-live": "polite" });
  const spacer = element("div", { class: "spacer", role: "presentation" });
  const list = element(
    "div",
    {
      class: "edge-list",
      role: "listbox",
      tabindex: 0,
      "aria-label": "Edges",
      onscroll: () => draw(),
      onkeydown: (event) => {
        const pages = Math.max(1, Math.floor(list.clientHeight / row_height) - 1);
        const steps = { PageDown: pages, PageUp: -pages, Home: -Infinity, End: Infinity };
        if (!(event.key in steps)) return;
        event.preventDefault();
        step(steps[event.key]);
      },
    },
    spacer,
  );
  const root = element(
    "section",
    { class: "edges", "aria-label": "Edges" },
    element("div", { class: "edges-head" }, element("h2", {}, "Edges ", count), element("div", {}, order, filter)),
    list,
  );

  const fill = (select, options) => {
    const before = select.value;
    const offered = Object.entries(options).filter(([, option]) => scene.truth || !option.needs_truth);
    select.replaceChildren(...offered.map(([value, { name }]) => element("option", { value }, name)));
    if (offered.some(([value]) => value === before)) select.value = before;
  };
  const refresh = () => {
    rows = (patch === null ? scene.edges : scene.edges_of[patch])
      .filter(list_filters[filter.value].test)
      .sort(orders[order.value].compare);
    const left_out = scene.edges_left_out;
    count.textContent = `${rows.length.toLocaleString("en")}${patch === null ? "" : ` of patch ${patch}`}`;
    count.title = left_out
      ? `${left_out.toLocaleString("en")} more of the assembly level, which p and ground truth agree on, are not in this page`
      : "";
    if (left_out && patch === null) count.textContent += ` (+${left_out.toLocaleString("en")})`;
    spacer.style.height = `${rows.length * row_height}px`;
    list.scrollTop = 0;
    draw();
  };
  const row = (edge, index) => {
    const { kind, text } = verdict(scene, edge);
    return element(
      "div",
      {
        class: is_wrong(edge) ? "row wrong" : "row",
        role: "option",
        id: `edge-${edge.index}`,
        "aria-selected": String(edge === chosen),
        "aria-setsize": rows.length,
        "aria-posinset": index + 1,
        "aria-label": `Patches ${edge.a} and ${edge.b}, ${level_name(scene, edge)}, p ${p_text(edge.p)}, ${text}`,
        style: { top: `${index * row_height}px` },
        onclick: () => choose(edge),
      },
      element("span", { class: "pair" }, `${edge.a} – ${edge.b}`),
      element("span", { class: "dim level" }, level_name(scene, edge)),
      element("span", { class: "number" }, p_text(edge.p)),
      p_bar(edge),
      element("span", { class: `mark ${kind}`, title: text }, kind === "good" ? "✓" : kind === "bad" ? "✗" : "·"),
    );
  };
  const paint = () => {
    const first = Math.max(0, Math.floor(list.scrollTop / row_height) - 4);
    const last = Math.min(rows.length, Math.ceil((list.scrollTop + list.clientHeight) / row_height) + 4);
    spacer.replaceChildren(...rows.slice(first, last).map((edge, i) => row(edge, first + i)));
    if (chosen && rows.includes(chosen)) list.setAttribute("aria-activedescendant", `edge-${chosen.index}`);
    else list.removeAttribute("aria-activedescendant");
  };
  const draw = once_a_frame(paint);
  const show_chosen = () => {
    const at = rows.indexOf(chosen);
    if (at < 0) return;
    const top = at * row_height;
    if (top < list.scrollTop) list.scrollTop = top;
    else if (top + row_height > list.scrollTop + list.clientHeight)
      list.scrollTop = top + row_height - list.clientHeight;
  };
  const step = (by_rows) => {
    if (!rows.length) return;
    const at = rows.indexOf(chosen);
    choose(rows[clamp(at < 0 ? (by_rows > 0 ? 0 : rows.length - 1) : at + by_rows, 0, rows.length - 1)]);
  };
  new ResizeObserver(draw).observe(list);

  return {
    root,
    step,
    open: (opened) => {
      scene = opened;
      chosen = patch = null;
      fill(order, orders);
      fill(filter, list_filters);
      refresh();
    },
    /// The edge to mark, and the patch to whose edges the list is narrowed; null: none.
    mark: (edge, of_patch) => {
      const other = of_patch !== patch;
      chosen = edge;
      patch = of_patch;
      if (other) refresh();
      show_chosen();
      draw();
    },
  };
};
