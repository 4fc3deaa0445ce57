// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The layers that are lines, and what is marked, drawn over the images at the screen's resolution: lines are as wide at
// every zoom.

import { closure_colour, css, edge_colours, line_colours } from "./colours.js";

export const edge_filters = {
  telling: { name: "Likely or wrong", test: (edge) => edge.p >= 0.5 || edge.error > 0.5 },
  wrong: { name: "Wrong: p against ground truth", test: (edge) => edge.error > 0.5, needs_truth: true },
  structural: { name: "Structural level", test: (edge) => edge.level === 0 },
  assembly: { name: "Assembly level", test: (edge) => edge.level === 1 },
  all: { name: "All", test: () => true },
};

export const is_wrong = (edge) => edge.error !== null && edge.error > 0.5;

export const edge_colour = (edge) =>
  is_wrong(edge) ? edge_colours.wrong : edge.p >= 0.5 ? edge_colours.likely : edge_colours.unlikely;

/// Draws in pixels of the screen what is given in pixels of the scene.
const pen = (context, { scale, x, y }) => {
  const at = ([u, v]) => [(u + 0.5) * scale + x, (v + 0.5) * scale + y];
  return {
    begin: () => context.beginPath(),
    path(points) {
      points.forEach((point, i) => (i ? context.lineTo(...at(point)) : context.moveTo(...at(point))));
    },
    close: () => context.closePath(),
    stroke(style, width) {
      context.strokeStyle = style;
      context.lineWidth = width;
      context.stroke();
    },
    fill(style) {
      context.fillStyle = style;
      context.fill();
    },
    disc(point, radius) {
      context.beginPath();
      context.arc(...at(point), radius, 0, 2 * Math.PI);
    },
    dash: (on) => context.setLineDash(on ? [4, 4] : []),
    opacity: (share) => (context.globalAlpha = share),
  };
};

/// A cleared canvas of the size that it is shown in, ready to draw.
const fresh = (context, view) => {
  const { canvas } = context,
    ratio = window.devicePixelRatio || 1;
  const width = Math.round(canvas.clientWidth * ratio),
    height = Math.round(canvas.clientHeight * ratio);
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.lineJoin = "round";
  return pen(context, view);
};

const draw_closure = (draw, closure, strength, marked) => {
  draw.begin();
  draw.path(closure.outline);
  draw.close();
  draw.fill(css(closure_colour, (marked ? 0.2 : 0.07) * strength));
  draw.stroke(css(closure_colour, strength), marked ? 2.5 : 1.5);
};

/// Lines of one colour at once, with a dark rim.
const draw_lines = (draw, lines, width) => {
  for (const kind of Object.keys(line_colours)) {
    draw.begin();
    for (const [, beyond, from, to] of lines) if (beyond === kind) draw.path([from, to]);
    draw.stroke("rgb(0 0 0 / 0.5)", width + 2);
    draw.stroke(css(line_colours[kind]), width);
  }
};

const ends_of = (scene, edge) => [scene.patches[edge.a].anchor, scene.patches[edge.b].anchor];

const slice = 300; // edges

/// Edges of one look at once: thousands of strokes take longer than thousands of lines. More than a thousand are not
/// dashed, for the same reason. Yields now and then, for who cannot wait.
const draw_edges = function* (draw, scene, cut, edges, crowding) {
  const looks = new Map();
  for (const edge of edges) {
    const joined = cut.labels[edge.a] === cut.labels[edge.b];
    const strength = Math.ceil(4 * Math.max(edge.p, edge.error ?? 0)) / 4;
    const look = `${edge_colour(edge)} ${joined} ${strength}`;
    if (!looks.has(look))
      looks.set(look, { colour: edge_colour(edge), joined, strength: 0.35 + 0.65 * strength, edges: [] });
    looks.get(look).edges.push(edge);
  }
  for (const { colour, joined, strength, edges: alike } of looks.values()) {
    for (let first = 0; first < alike.length; first += slice) {
      draw.begin();
      for (const edge of alike.slice(first, first + slice)) draw.path(ends_of(scene, edge));
      draw.dash(!joined && edges.length <= 1000);
      draw.stroke(css(colour, strength * crowding), joined ? 2 : 1.25);
      draw.dash(false);
      yield;
    }
  }
};

const draw_nodes = (draw, scene, cut, patches, radius) => {
  for (const patch of patches) {
    const segment = cut.segments[cut.labels[patch]];
    draw.disc(scene.patches[patch].anchor, radius);
    draw.fill(segment?.background ? "#8a8f96" : segment ? css(segment.colour) : "#444");
    draw.stroke("rgb(0 0 0 / 0.8)", 1.25);
  }
};

const node_radius = (scene) => (scene.patches.length > 200 ? 2.2 : 3.5);

export const complete = (drawing) => {
  while (!drawing.next().done);
};

/// Runs what draws each visible layer of lines, with its opacity set.
const draw_layers = function* (draw, state, layers) {
  for (const [id, layer] of Object.entries(layers)) {
    if (!state.visible[id]) continue;
    draw.opacity(state.opacity[id]);
    yield* layer();
    draw.opacity(1);
  }
};

/// Draws the layers, a part with each step of the generator. view: {scale, x, y} from pixels of the scene to those of the
/// screen; edges: those of the graph layer.
export const draw_overlay = function* (context, scene, state, cut, view, edges) {
  const draw = fresh(context, view);
  yield* draw_layers(draw, state, {
    *closures() {
      scene.closures.forEach((closure, rank) => draw_closure(draw, closure, Math.max(0.2, 1 - rank / 12), false));
    },
    *lines() {
      draw_lines(draw, scene.lines, 2);
    },
    *graph() {
      yield* draw_edges(draw, scene, cut, edges, Math.min(1, Math.max(0.25, 16 / Math.sqrt(edges.length + 1))));
      draw_nodes(draw, scene, cut, scene.patches.keys(), node_radius(scene));
    },
  });
};

/// Draws what belongs to the marked patch and the marked edges over the layers.
export const draw_marks = (context, scene, state, cut, view, edges, { patch, edges: marked }) => {
  const draw = fresh(context, view);
  if (patch !== null)
    complete(
      draw_layers(draw, state, {
        *closures() {
          for (const closure of scene.closures)
            if (closure.patches.includes(patch)) draw_closure(draw, closure, 1, true);
        },
        *lines() {
          draw_lines(
            draw,
            scene.lines.filter(([surface]) => surface === patch),
            3,
          );
        },
        *graph() {
          const own = edges.filter(({ a, b }) => a === patch || b === patch);
          yield* draw_edges(draw, scene, cut, own, 1);
          draw_nodes(draw, scene, cut, new Set(own.flatMap(({ a, b }) => [a, b])), node_radius(scene));
        },
      }),
    );
  for (const edge of marked) {
    draw.begin();
    draw.path(ends_of(scene, edge));
    draw.stroke("rgb(0 0 0 / 0.65)", 6);
    draw.dash(cut.labels[edge.a] !== cut.labels[edge.b]);
    draw.stroke(css(edge_colour(edge)), 3);
    draw.dash(false);
    for (const end of ends_of(scene, edge)) {
      draw.disc(end, 5);
      draw.fill("#fff");
      draw.stroke("#000", 1.5);
    }
  }
};

/// The shown edge that passes nearest to a point of the scene, within so many of its pixels; null when none does, and
/// near its ends, where patches are meant.
export const edge_at = (scene, edges, x, y, reach) => {
  let best = null,
    nearest = reach * reach;
  for (const edge of edges) {
    const [ax, ay] = scene.patches[edge.a].anchor,
      [bx, by] = scene.patches[edge.b].anchor;
    const dx = bx - ax,
      dy = by - ay,
      length = dx * dx + dy * dy;
    if (length === 0) continue;
    const along = ((x - ax) * dx + (y - ay) * dy) / length;
    const margin = Math.min(0.25, (2 * reach) / Math.sqrt(length));
    if (along < margin || along > 1 - margin) continue;
    const distance = (x - ax - along * dx) ** 2 + (y - ay - along * dy) ** 2;
    if (distance < nearest) {
      nearest = distance;
      best = edge;
    }
  }
  return best;
};
