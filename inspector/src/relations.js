// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Details of patches and edges, in the panel and beside the pointer.

import { clamp, element } from "./dom.js";
import { css } from "./colours.js";
import { edge_colour, is_wrong } from "./overlay.js";
import { phrase, reasons } from "./reasons.js";
import { level_name, object_name } from "./scene.js";

export const p_text = (p) => (p < 0.001 ? "< 0.001" : p > 0.999 ? "> 0.999" : p.toFixed(3));

export const number_text = (x) => {
  if (x === 0) return "0";
  const size = Math.abs(x);
  return size >= 1e5 || size < 1e-3
    ? x.toExponential(1).replace(/e\+?(.*)/, (_, power) => "·10" + power.replace(/./g, (digit) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(digit)]))
    : String(Number(x.toPrecision(3)));
};

const signed = (x) => (Math.abs(x) < 0.0005 ? "0" : (x > 0 ? "+" : "−") + Math.abs(x).toFixed(3));

/// "agrees", "disagrees", or that nothing is known.
export const verdict = (scene, edge) => {
  if (edge.truth === null)
    return { text: scene.truth ? "ground truth does not say" : "no ground truth", kind: "unknown" };
  const told = edge.truth ? "same object" : "different objects";
  return is_wrong(edge)
    ? { text: `ground truth: ${told} — p disagrees`, kind: "bad" }
    : { text: `ground truth: ${told} — p agrees`, kind: "good" };
};

export const patch_label = (scene, cut, patch, pin) => {
  const segment = cut.segments[cut.labels[patch]];
  const swatch = element("span", {
    class: "swatch",
    style: { background: !segment || segment.background ? "var(--faint)" : css(segment.colour) },
  });
  return pin
    ? element("button", { type: "button", class: "patch-name", onclick: () => pin(patch) }, swatch, `Patch ${patch}`)
    : element("span", { class: "patch-name" }, swatch, `Patch ${patch}`);
};

export const p_bar = (edge) =>
  element(
    "span",
    { class: "p-bar", "aria-hidden": "true" },
    element("span", { style: { width: `${100 * edge.p}%`, background: css(edge_colour(edge)) } }),
  );

/// Where a value lies in the range that it had in training.
const range_track = (value, [low, high]) => {
  const share = high > low ? (value - low) / (high - low) : 0.5;
  const outside = share < 0 || share > 1;
  return element(
    "span",
    { class: "track", title: `in training from ${number_text(low)} to ${number_text(high)}` },
    element("span", { class: outside ? "dot outside" : "dot", style: { left: `${100 * clamp(share, 0, 1)}%` } }),
  );
};

const contribution_bar = (part, largest) =>
  element(
    "span",
    { class: "contribution" },
    element("span", {
      class: part < 0 ? "against" : "for",
      style: { width: `${(50 * Math.abs(part)) / largest}%` },
    }),
  );

/// The relation values of an edge, those that contribute most first.
export const values_table = (scene, edge) => {
  const { values } = scene.levels[edge.level];
  const order = values
    .map((_, i) => i)
    .sort((x, y) => Math.abs(edge.contributions[y]) - Math.abs(edge.contributions[x]));
  const largest = Math.max(0.05, ...edge.contributions.map(Math.abs));
  return element(
    "table",
    { class: "values" },
    element(
      "thead",
      {},
      element(
        "tr",
        {},
        element("th", { scope: "col" }, "Relation"),
        element("th", { scope: "col", class: "number" }, "Value"),
        element(
          "th",
          { scope: "col", title: "where the value lies in the range that it had in training" },
          "In training",
        ),
        element(
          "th",
          { scope: "col", title: "p minus the mean of p over other values: docs/inspector.md" },
          "Contribution",
        ),
        element("th", {}),
      ),
    ),
    element(
      "tbody",
      {},
      order.map((i) =>
        element(
          "tr",
          { title: `${values[i].relation}: ${values[i].text}` },
          element(
            "th",
            { scope: "row" },
            values[i].name,
            element("span", { class: "dim relation-name" }, values[i].relation.replaceAll("_", " ")),
          ),
          element("td", { class: "number" }, number_text(edge.values[i])),
          element("td", {}, range_track(edge.values[i], values[i].trained)),
          element("td", {}, contribution_bar(edge.contributions[i], largest)),
          element("td", { class: "number" }, signed(edge.contributions[i])),
        ),
      ),
    ),
  );
};

/// An edge in full. pin(patch), where the patches' names are to be buttons.
export const tell_edge = (scene, cut, edge, pin = null) => {
  const { text, kind } = verdict(scene, edge);
  const joined = cut.labels[edge.a] === cut.labels[edge.b];
  return [
    element(
      "div",
      { class: "edge-title" },
      patch_label(scene, cut, edge.a, pin),
      element("span", { class: "dim" }, "–"),
      patch_label(scene, cut, edge.b, pin),
      element("span", { class: "tag" }, level_name(scene, edge)),
    ),
    element(
      "div",
      { class: "p-line" },
      element("span", { class: "p" }, "p = ", element("b", {}, p_text(edge.p))),
      p_bar(edge),
      element("span", { class: "dim" }, joined ? "one segment" : "cut apart"),
    ),
    element("div", { class: `verdict ${kind}` }, text),
    element("p", { class: "reasons" }, reasons(scene, edge, number_text)),
    values_table(scene, edge),
  ];
};

const fact = (name, ...value) => [element("dt", {}, name), element("dd", {}, ...value)];

export const tell_patch = (scene, cut, patch, { point = null, edges = 6, choose = null } = {}) => {
  const told = scene.patches[patch],
    segment = cut.segments[cut.labels[patch]];
  const touching = [...scene.edges_of[patch]].sort((x, y) => y.p - x.p);
  return [
    element(
      "div",
      { class: "edge-title" },
      patch_label(scene, cut, patch),
      element("span", { class: "tag" }, told.type),
    ),
    element(
      "dl",
      { class: "facts" },
      fact(
        "Segment",
        segment
          ? `${segment.label}, ${segment.background ? "background" : "object"} of ${segment.patches.length} ${segment.patches.length === 1 ? "patch" : "patches"}`
          : "none",
      ),
      told.object === null ? [] : fact("Ground truth", object_name(told.object)),
      fact("Pixels", told.pixels.toLocaleString("en")),
      fact("Fit error", `${(1000 * told.rms).toFixed(2)} mm RMS`),
      point ? fact("Depth", `${point[2].toFixed(3)} m`) : [],
    ),
    element(
      "div",
      { class: "edges-of" },
      element("div", { class: "dim" }, !touching.length
          ? "No edges."
          : edges
            ? `${touching.length} ${touching.length === 1 ? "edge" : "edges"}, most likely first`
            : `${touching.length} ${touching.length === 1 ? "edge" : "edges"}, in the list below`),
      touching.slice(0, edges).map((edge) => edge_row(scene, cut, edge, patch, choose)),
    ),
  ];
};

/// An edge of a patch in one line.
const edge_row = (scene, cut, edge, patch, choose) => {
  const other = edge.a === patch ? edge.b : edge.a,
    { kind, text } = verdict(scene, edge);
  const strongest = edge.contributions.reduce((best, c, i, all) => (Math.abs(c) > Math.abs(all[best]) ? i : best), 0);
  const { name } = scene.levels[edge.level].values[strongest];
  const content = [
    patch_label(scene, cut, other),
    element("span", { class: "number" }, p_text(edge.p)),
    p_bar(edge),
    element("span", { class: `mark ${kind}`, title: text }, kind === "good" ? "✓" : kind === "bad" ? "✗" : ""),
    element(
      "span",
      { class: "dim strongest" },
      `${phrase(name, edge.values[strongest], name)} ${signed(edge.contributions[strongest])}`,
    ),
  ];
  return choose
    ? element("button", { type: "button", class: "edge-row", onclick: () => choose(edge) }, content)
    : element("div", { class: "edge-row" }, content);
};
