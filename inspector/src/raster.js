// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The layers that are images: a canvas each, of the size of the thinned images.

import { colour_of, depth_colour, image_edge_colours, packed } from "./colours.js";

const grey = [128, 132, 138];
const outline = packed([16, 18, 20]);

/// Paints palette[number] for each pixel's number.
const paint = (canvas, numbers, palette, change = () => {}) => {
  const image = new ImageData(canvas.width, canvas.height);
  const pixels = new Uint32Array(image.data.buffer);
  for (let i = 0; i < pixels.length; ++i) pixels[i] = palette[numbers[i]];
  change(pixels);
  canvas.getContext("2d").putImageData(image, 0, 0);
};

const paint_depth = (scene, canvas) => {
  const sorted = scene.depth.filter(Boolean).sort();
  const near = sorted[Math.floor(0.01 * sorted.length)],
    far = sorted[Math.floor(0.99 * (sorted.length - 1))];
  const palette = new Uint32Array(65536);
  for (let depth = 1; depth < 65536; ++depth) {
    const share = Math.min(1, Math.max(0, (depth - near) / (far - near || 1)));
    palette[depth] = packed(depth_colour(Math.round(share * 255) / 255));
  }
  paint(canvas, scene.depth, palette);
  return [near * scene.depth_unit, far * scene.depth_unit];
};

const paint_patches = (scene, canvas) => {
  const palette = Uint32Array.from([0, ...scene.patches.map((_, i) => packed(colour_of(i + 1)))]);
  paint(canvas, scene.patch_of, palette, (pixels) => {
    for (let i = 0; i < scene.borders.length; i += 3) pixels[scene.borders[i]] = outline;
  });
};

const paint_truth = (scene, canvas) => {
  const palette = new Uint32Array(65536);
  for (let object = 2; object < 65536; ++object) palette[object] = object < 1000 ? packed(colour_of(object)) : 0;
  palette[1] = packed(grey);
  paint(canvas, scene.truth, palette);
};

const paint_image_edges = (scene, canvas) =>
  paint(canvas, scene.image_edges, Uint32Array.from([0, ...image_edge_colours.map((colour) => packed(colour))]));

/// Paints a cut again; fast, as it follows the slider.
const paint_segments = (scene, canvas, cut) => {
  const palette = new Uint32Array(scene.patches.length + 1);
  cut.labels.forEach((label, patch) => {
    const segment = cut.segments[label];
    palette[patch + 1] = segment && !segment.background ? packed(segment.colour) : 0;
  });
  // As in overlay.png, only objects are outlined.
  const labels = [0, ...cut.labels.map((label) => (cut.segments[label]?.background ? 0 : label))];
  paint(canvas, scene.patch_of, palette, (pixels) => {
    for (let i = 0; i < scene.borders.length; i += 3)
      if (labels[scene.borders[i + 1]] !== labels[scene.borders[i + 2]]) pixels[scene.borders[i]] = outline;
  });
};

/// Canvases by layer, painted when they are first shown.
export const make_rasters = (scene) => {
  const canvases = {};
  const blank = (id) => {
    const canvas = document.createElement("canvas");
    canvas.width = scene.columns;
    canvas.height = scene.rows;
    canvas.dataset.layer = id;
    canvases[id] = canvas;
    return canvas;
  };
  const painters = {
    colour: (canvas) => scene.colour && canvas.getContext("2d").drawImage(scene.colour, 0, 0),
    depth: (canvas) => (scene.depth_range = paint_depth(scene, canvas)),
    patches: (canvas) => paint_patches(scene, canvas),
    surfaces: (canvas) => canvas.getContext("2d").drawImage(masked(scene), 0, 0),
    truth: (canvas) => scene.truth && paint_truth(scene, canvas),
    edges: (canvas) => scene.image_edges && paint_image_edges(scene, canvas),
    segments: () => {},
  };
  let painted_cut = null;
  return {
    ids: Object.keys(painters),
    canvas: (id) => {
      if (!canvases[id]) painters[id](blank(id));
      return canvases[id];
    },
    cut: (cut) => {
      if (painted_cut === cut) return;
      painted_cut = cut;
      paint_segments(scene, canvases.segments ?? blank("segments"), cut);
    },
  };
};

/// The normals, lit a little, and nothing where there is no patch.
const masked = (scene) => {
  const canvas = new OffscreenCanvas(scene.columns, scene.rows);
  const context = canvas.getContext("2d");
  context.drawImage(scene.normals, 0, 0);
  const image = context.getImageData(0, 0, scene.columns, scene.rows);
  for (let i = 0; i < scene.patch_of.length; ++i) if (!scene.patch_of[i]) image.data[4 * i + 3] = 0;
  for (let i = 0; i < scene.borders.length; i += 3)
    for (let c = 0; c < 3; ++c) image.data[4 * scene.borders[i] + c] *= 0.55;
  context.putImageData(image, 0, 0);
  return canvas;
};
