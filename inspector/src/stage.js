// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The scene's images with the overlay, to be moved and zoomed.

import { clamp, element } from "./dom.js";
import { complete, draw_marks, draw_overlay, edge_at } from "./overlay.js";

const drag_from = 4; // px
const many = 1500; // lines; layers of more are drawn when nothing has moved for a while
const pause = 120; // ms

/// on: {hover(item, place), click(item), changed()}; item: {patch, point, u, v}, {edge} or null; place: px in the stage.
export const make_stage = (on) => {
  const rasters = element("div", { class: "rasters" });
  const marks = element("canvas", { class: "marks" });
  const overlay = element("canvas", { class: "overlay" }),
    front = element("canvas", { class: "overlay" });
  const root = element(
    "div",
    {
      class: "stage-2d",
      tabindex: 0,
      role: "application",
      "aria-label": "Scene in layers; point at a patch or an edge",
    },
    rasters,
    overlay,
    front,
  );
  const context = overlay.getContext("2d"),
    front_context = front.getContext("2d");
  let scene = null,
    images = null,
    view = { scale: 1, x: 0, y: 0 },
    fitted = true,
    edges = [],
    drag = null;
  let drawn = { key: "", view },
    waiting = 0,
    later = 0;

  const fit = () => {
    const { clientWidth: w, clientHeight: h } = root;
    if (!scene || !w || !h) return;
    const margin = 12;
    const scale = Math.min((w - 2 * margin) / scene.width, (h - 2 * margin) / scene.height);
    view = { scale, x: (w - scale * scene.width) / 2, y: (h - scale * scene.height) / 2 };
    fitted = true;
  };
  const zoom = (factor, x = root.clientWidth / 2, y = root.clientHeight / 2) => {
    const scale = clamp(view.scale * factor, 0.05, 40),
      ratio = scale / view.scale;
    view = { scale, x: x - ratio * (x - view.x), y: y - ratio * (y - view.y) };
    fitted = false;
    on.changed();
  };
  const move = (dx, dy) => {
    view = { ...view, x: view.x + dx, y: view.y + dy };
    fitted = false;
    on.changed();
  };

  const place_of = (event) => {
    const box = root.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const item_at = ([x, y]) => {
    if (!scene) return null;
    const u = (x - view.x) / view.scale - 0.5,
      v = (y - view.y) / view.scale - 0.5;
    const edge = edge_at(scene, edges, u, v, 5 / view.scale);
    return edge ? { edge } : scene.patch_at(u, v);
  };

  root.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    drag = { from: place_of(event), last: place_of(event), moved: false };
    root.setPointerCapture(event.pointerId);
  });
  root.addEventListener("pointermove", (event) => {
    const place = place_of(event);
    if (drag) {
      drag.moved ||= Math.hypot(place[0] - drag.from[0], place[1] - drag.from[1]) >= drag_from;
      if (drag.moved) {
        move(place[0] - drag.last[0], place[1] - drag.last[1]);
        root.classList.add("dragging");
        on.hover(null, place);
      }
      drag.last = place;
    } else on.hover(item_at(place), place);
  });
  root.addEventListener("pointerup", (event) => {
    if (drag && !drag.moved) on.click(item_at(place_of(event)));
    drag = null;
    root.classList.remove("dragging");
  });
  root.addEventListener("pointercancel", () => {
    drag = null;
    root.classList.remove("dragging");
  });
  root.addEventListener("pointerleave", () => on.hover(null, [0, 0]));
  root.addEventListener("dblclick", () => {
    fit();
    on.changed();
  });
  root.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      zoom(Math.exp(-clamp(event.deltaY, -60, 60) * 0.006), ...place_of(event));
    },
    { passive: false },
  );
  new ResizeObserver(() => {
    if (fitted) fit();
    on.changed();
  }).observe(root);

  /// The marked patches, lightened and outlined.
  const paint_marks = ({ patch, edges: marked }) => {
    const patches = new Set([...(patch === null ? [] : [patch]), ...marked.flatMap((edge) => [edge.a, edge.b])]);
    const key = [...patches].join();
    if (marks.dataset.patches === key) return;
    marks.dataset.patches = key;
    const chosen = new Uint8Array(scene.patches.length + 1);
    for (const one of patches) chosen[one + 1] = 1;
    const image = new ImageData(scene.columns, scene.rows);
    const pixels = new Uint32Array(image.data.buffer);
    for (let i = 0; i < pixels.length; ++i) if (chosen[scene.patch_of[i]]) pixels[i] = 0x30ffffff;
    for (let i = 0; i < scene.borders.length; i += 3)
      if (chosen[scene.borders[i + 1]] !== chosen[scene.borders[i + 2]]) pixels[scene.borders[i]] = 0xffffffff;
    marks.getContext("2d").putImageData(image, 0, 0);
  };

  const draw_layers = (key, state, cut) => {
    drawn = { key, view };
    overlay.style.transform = "";
    return draw_overlay(context, scene, state, cut, view, edges);
  };
  /// One part each frame, so that nothing has to wait for all of them.
  const go_on = (drawing) => {
    if (!drawing.next().done) later = requestAnimationFrame(() => go_on(drawing));
  };
  /// The layers of lines are redrawn when something in them has changed; what is slow follows the images later.
  const show_overlay = (state, cut) => {
    const shown = ["closures", "lines", "graph"].map((id) => state.visible[id] && state.opacity[id]);
    const key = [
      scene.index,
      shown,
      state.visible.graph && [state.filter, state.cut],
      view.scale,
      view.x,
      view.y,
      root.clientWidth,
      root.clientHeight,
      window.devicePixelRatio,
    ].join(" ");
    if (key === drawn.key) return;
    clearTimeout(waiting);
    cancelAnimationFrame(later);
    const lines = (state.visible.graph ? edges.length : 0) + (state.visible.lines ? scene.lines.length : 0);
    if (lines <= many) return complete(draw_layers(key, state, cut));
    const ratio = view.scale / drawn.view.scale;
    overlay.style.transform = `translate(${view.x - ratio * drawn.view.x}px, ${view.y - ratio * drawn.view.y}px) scale(${ratio})`;
    waiting = setTimeout(() => go_on(draw_layers(key, state, cut)), pause);
  };

  return {
    root,
    fit: () => {
      fit();
      on.changed();
    },
    zoom,
    /// A scene and the canvases of its layers.
    show: (complete, its_images) => {
      scene = complete;
      images = its_images;
      fit();
      rasters.style.width = `${scene.width}px`;
      rasters.style.height = `${scene.height}px`;
      marks.width = scene.columns;
      marks.height = scene.rows;
      delete marks.dataset.patches;
    },
    draw: (state, cut, shown, marked) => {
      if (!images) return;
      edges = shown;
      const wanted = images.ids
        .filter((id) => state.visible[id])
        .map((id) => {
          const canvas = images.canvas(id);
          canvas.style.opacity = state.opacity[id];
          return canvas;
        });
      paint_marks(marked);
      wanted.push(marks);
      if (wanted.length !== rasters.children.length || wanted.some((canvas, i) => rasters.children[i] !== canvas))
        rasters.replaceChildren(...wanted);
      rasters.style.transform = `translate(${view.x}px, ${view.y}px) scale(${view.scale})`;
      rasters.classList.toggle("coarse", view.scale > 1.5);
      show_overlay(state, cut);
      overlay.style.opacity = marked.patch === null ? 1 : 0.3;
      draw_marks(front_context, scene, state, cut, view, edges, marked);
    },
  };
};
