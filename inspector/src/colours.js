// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

const to_byte = (linear) => {
  const x = linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
  return Math.round(255 * Math.min(1, Math.max(0, x)));
};

/// sRGB of OKLCH, in which equal steps look equal (Ottosson 2020).
export const oklch = (lightness, chroma, degrees) => {
  const a = chroma * Math.cos((degrees * Math.PI) / 180),
    b = chroma * Math.sin((degrees * Math.PI) / 180);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    to_byte(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    to_byte(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    to_byte(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
};

/// A colour for a number: neighbouring numbers differ most in hue, and by turns in lightness.
export const colour_of = (number) => oklch([0.74, 0.62, 0.82][number % 3], 0.15, 30 + number * 137.508);

/// Near to far: yellow over green to violet, even in lightness.
export const depth_colour = (share) => oklch(0.92 - 0.62 * share, 0.13, 105 + 200 * share);

/// The pixel of an ImageData seen as Uint32Array (all machines that run browsers are little-endian).
export const packed = ([r, g, b], alpha = 255) => ((alpha << 24) | (b << 16) | (g << 8) | r) >>> 0;

export const css = ([r, g, b], alpha = 1) => `rgb(${r} ${g} ${b} / ${alpha})`;

/// Of boundary lines, by what is beyond them.
export const line_colours = {
  farther: [46, 189, 107],
  nothing: [236, 196, 58],
  level: [86, 140, 255],
  nearer: [160, 160, 160],
  "image edge": [125, 125, 125],
};

export const closure_colour = [225, 90, 220];

/// Of edges: same object, not, and what ground truth contradicts.
/// An edge of the colour image, and a cut along one.
export const image_edge_colours = [
  [255, 220, 90],
  [255, 60, 200],
];
export const edge_colours = { likely: [70, 190, 255], unlikely: [245, 165, 60], wrong: [255, 62, 72] };
