// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

/// The layers in the order in which they lie on each other. Their keys are 1 to 9 in this order, unless one has its own.
/// vector: drawn as lines, over all images.
export const layers = [
  { id: "colour", name: "Colour", text: "the camera's image" },
  { id: "depth", name: "Depth", text: "near is light, far is dark" },
  { id: "patches", name: "Patches", text: "what is grouped: pixels of one surface, after merging" },
  { id: "surfaces", name: "Surfaces", text: "the fitted surfaces, coloured by their normals" },
  { id: "lines", name: "Lines", text: "straight boundaries of the patches", vector: true },
  { id: "closures", name: "Closures", text: "closed convex contours over lines of several patches", vector: true },
  { id: "graph", name: "Graph", text: "edges between patches, with p(same object)", vector: true },
  { id: "segments", name: "Segments", text: "how the solver cuts the graph; background is clear" },
  { id: "truth", name: "Ground truth", text: "the labelled objects; background is grey" },
  { id: "edges", key: "e", name: "Image edges", text: "edges of the colour image, and where patches were cut along them" },
];

export const first_layers = () => ({
  visible: { colour: true, segments: true, graph: true },
  opacity: {
    colour: 1,
    depth: 1,
    patches: 0.7,
    surfaces: 0.8,
    lines: 1,
    closures: 0.8,
    graph: 1,
    segments: 0.5,
    truth: 0.6,
    edges: 1,
  },
});
