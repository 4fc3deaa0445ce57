// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The data of a scene, as the page's script elements have it (README.md), prepared for drawing.

import { colour_of } from "./colours.js";

export const scene_names = () => JSON.parse(document.getElementById("scenes").textContent);

/// The pixels exactly as they are in the file.
const bitmap_of = async (uri) =>
  createImageBitmap(await (await fetch(uri)).blob(), { colorSpaceConversion: "none", premultiplyAlpha: "none" });

const pixels_of = (bitmap) => {
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
};

/// Numbers of 16 bits, high byte in red, low one in green.
const numbers_of = async (uri) => {
  const bytes = pixels_of(await bitmap_of(uri));
  const numbers = new Uint16Array(bytes.length / 4);
  for (let i = 0; i < numbers.length; ++i) numbers[i] = (bytes[4 * i] << 8) | bytes[4 * i + 1];
  return numbers;
};

const read_edge = ([a, b, level, p, truth, values, contributions], index) => ({
  index,
  a,
  b,
  level,
  p,
  truth, // 1 same object, 0 not, null unknown
  values,
  contributions,
  error: truth === null ? null : Math.abs(p - truth),
  doubt: 1 - Math.abs(2 * p - 1), // 1 at p = 1/2
});

/// A colour for each patch, for a segment of which it is the largest: segments then keep their colours while the slider
/// moves. Those of the config's cut are given, as in overlay.png.
const family_colours = ({ labels }, patches, given) => {
  const by_size = patches.map((_, i) => i).sort((x, y) => patches[y].pixels - patches[x].pixels || x - y);
  const seen = new Set();
  const heads = by_size.filter((patch) => !seen.has(labels[patch]) && seen.add(labels[patch]));
  const colours = [];
  [...new Set([...heads, ...by_size])].forEach((patch, rank) => (colours[patch] = colour_of(rank)));
  for (const patch of heads) colours[patch] = given[labels[patch] - 1] ?? colours[patch];
  return colours;
};

/// A cut's segments: label of each patch, and of each label its patches, role and colour.
const read_cut = ({ labels, background }, patches, colours) => {
  const segments = [];
  labels.forEach((label, patch) => {
    segments[label] ??= { label, patches: [], pixels: 0, background: background.includes(label), colour: 0 };
    segments[label].patches.push(patch);
    segments[label].pixels += patches[patch].pixels;
  });
  for (const segment of segments) {
    if (!segment) continue;
    const largest = segment.patches.reduce((x, y) => (patches[y].pixels > patches[x].pixels ? y : x));
    segment.colour = colours[largest];
  }
  const list = segments.filter(Boolean);
  return { labels, segments, list, objects: list.filter((segment) => !segment.background).length };
};

/// What the cut does against ground truth, counted in edges.
export const against_truth = (scene, cut) => {
  let joined = 0,
    parted = 0;
  for (const { a, b, truth } of scene.edges) {
    const same = cut.labels[a] === cut.labels[b];
    if (truth === 0 && same) ++joined;
    if (truth === 1 && !same) ++parted;
  }
  return { joined, parted };
};

/// The point of a pixel of the thinned images, metres in the camera frame; null without depth.
const point_at = (scene, u, v) => {
  const z = scene.depth[v * scene.columns + u] * scene.depth_unit;
  if (z === 0) return null;
  const { fx, fy, cx, cy } = scene.camera;
  return [((u * scene.step - cx) / fx) * z, ((v * scene.step - cy) / fy) * z, z];
};

/// The pixels beside another patch: [pixel, patch here, patch there, ...], patches 1 + index, 0: none.
const borders_of = (patch_of, columns) => {
  const borders = [];
  for (let i = 0; i < patch_of.length; ++i) {
    const here = patch_of[i];
    const right = (i + 1) % columns ? patch_of[i + 1] : here;
    const below = i + columns < patch_of.length ? patch_of[i + columns] : here;
    if (right !== here) borders.push(i, here, right);
    if (below !== here) borders.push(i, here, below);
  }
  return Int32Array.from(borders);
};

/// Reads scene number index.
export const read_scene = async (index) => {
  const data = JSON.parse(document.getElementById(`scene-${index}`).textContent);
  const picture = document.getElementById(`picture-${index}`);
  const [colour, depth, patch_of, normals, truth, image_edges] = await Promise.all([
    picture && bitmap_of(picture.src),
    numbers_of(data.images.depth),
    numbers_of(data.images.patches),
    bitmap_of(data.images.normals),
    data.images.truth && numbers_of(data.images.truth),
    data.images.edges && numbers_of(data.images.edges),
  ]);
  const { step, depth_unit } = data.images;
  const scene = {
    ...data,
    index,
    step,
    depth_unit,
    colour,
    depth,
    patch_of, // 1 + index of the patch, 0: none
    normals,
    truth,
    image_edges, // 1 edge of the colour image, 2 cut along one, 0 neither; null without colour
    width: data.camera.width,
    height: data.camera.height,
    columns: normals.width,
    rows: normals.height,
    edges: data.edges.map(read_edge),
  };
  const colours = family_colours(data.solver.cuts[0], data.patches, data.colours);
  scene.cuts = data.solver.cuts.map((cut) => read_cut(cut, data.patches, colours));
  scene.borders = borders_of(patch_of, scene.columns);
  scene.edges_of = data.patches.map(() => []);
  for (const edge of scene.edges) {
    scene.edges_of[edge.a].push(edge);
    scene.edges_of[edge.b].push(edge);
  }
  scene.edge_between = (a, b) => scene.edges_of[a].find((edge) => edge.a === b || edge.b === b) ?? null;
  scene.patch_at = (x, y) => {
    const u = Math.floor((x + 0.5) / step),
      v = Math.floor((y + 0.5) / step);
    if (u < 0 || v < 0 || u >= scene.columns || v >= scene.rows) return null;
    const patch = patch_of[v * scene.columns + u];
    return { patch: patch ? patch - 1 : null, point: point_at(scene, u, v), u, v };
  };
  scene.point_at = (u, v) => point_at(scene, u, v);
  return scene;
};

export const level_name = (scene, edge) => scene.levels[edge.level].name;

export const object_name = (object) => (object === 0 ? "none" : object === 1 ? "background" : `object ${object - 1}`);
