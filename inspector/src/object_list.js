// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The list of objects: what each looks like, how large it is and how sure its patches are joined.

import { css } from "./colours.js";
import { element } from "./dom.js";
import { p_text } from "./relations.js";

const side = 40; // px of a thumbnail

/// The columns and rows that a segment covers.
const box_of = (scene, cut, segment) => {
  let [left, top, right, bottom] = [scene.columns, scene.rows, -1, -1];
  for (let i = 0; i < scene.patch_of.length; ++i) {
    const patch = scene.patch_of[i] - 1;
    if (patch < 0 || cut.labels[patch] !== segment.label) continue;
    const u = i % scene.columns,
      v = (i - u) / scene.columns;
    left = Math.min(left, u);
    right = Math.max(right, u);
    top = Math.min(top, v);
    bottom = Math.max(bottom, v);
  }
  return right < 0 ? null : { left, top, width: right - left + 1, height: bottom - top + 1 };
};

/// The part of the colour image that shows a segment, or its colour where the scene has none.
const thumbnail = (scene, cut, segment) => {
  const canvas = element("canvas", { class: "thumbnail", width: side, height: side, "aria-hidden": "true" });
  const context = canvas.getContext("2d");
  const box = scene.colour && box_of(scene, cut, segment);
  if (!box) {
    context.fillStyle = css(segment.colour);
    context.fillRect(0, 0, side, side);
    return canvas;
  }
  const scale = Math.min(side / box.width, side / box.height);
  const [w, h] = [box.width * scale, box.height * scale];
  context.drawImage(scene.colour, box.left, box.top, box.width, box.height, (side - w) / 2, (side - h) / 2, w, h);
  return canvas;
};

/// The edge that a segment depends on most: the least likely one of those that are needed to connect its patches, when
/// the likeliest are taken first. null for a single patch, or where edges alone do not connect them.
export const weakest_join = (scene, segment) => {
  const inside = new Set(segment.patches);
  const group = new Map(segment.patches.map((patch) => [patch, patch]));
  const head = (patch) => {
    while (group.get(patch) !== patch) patch = group.get(patch);
    return patch;
  };
  const edges = segment.patches
    .flatMap((patch) => scene.edges_of[patch].filter((edge) => edge.a === patch && inside.has(edge.b)))
    .sort((x, y) => y.p - x.p || x.index - y.index);
  let left = segment.patches.length - 1;
  for (const edge of edges) {
    const [a, b] = [head(edge.a), head(edge.b)];
    if (a === b) continue;
    group.set(a, b);
    if (--left === 0) return edge;
  }
  return null;
};

const counted = (count, one, many) => `${count.toLocaleString("en")} ${count === 1 ? one : many}`;

/// choose(patch): the largest patch of the object that was chosen.
export const make_object_list = (choose) => {
  const count = element("span", { class: "dim count", "aria-live": "polite" });
  const list = element("ul", { class: "object-list" });
  const root = element(
    "section",
    { class: "objects", "aria-label": "Objects" },
    element("h2", {}, "Objects ", count),
    list,
  );
  const row = (scene, cut, segment) => {
    const largest = segment.patches.reduce((x, y) => (scene.patches[y].pixels > scene.patches[x].pixels ? y : x));
    const join = weakest_join(scene, segment);
    return element(
      "li",
      {},
      element(
        "button",
        { type: "button", class: "object", onclick: () => choose(largest) },
        thumbnail(scene, cut, segment),
        element("span", { class: "swatch", style: { background: css(segment.colour) } }),
        element(
          "span",
          { class: "object-facts" },
          element("b", {}, `Object ${segment.label}`),
          element(
            "span",
            { class: "dim" },
            `${counted(segment.pixels, "pixel", "pixels")}, ${counted(segment.patches.length, "patch", "patches")}`,
          ),
        ),
        element(
          "span",
          { class: "dim number", title: "p of the weakest join that holds the object together" },
          join ? p_text(join.p) : "",
        ),
      ),
    );
  };
  let shown = null;
  return {
    root,
    /// The objects of a cut, the largest first.
    show: (scene, cut) => {
      if (shown === cut) return;
      shown = cut;
      const objects = cut.list.filter((segment) => !segment.background).sort((x, y) => y.pixels - x.pixels);
      count.textContent = objects.length;
      list.replaceChildren(...objects.map((segment) => row(scene, cut, segment)));
    },
  };
};
