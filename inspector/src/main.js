// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The page: what is shown (state), and what is updated when it changes.

import { element, once_a_frame } from "./dom.js";
import { make_edge_list } from "./edge_list.js";
import { make_help } from "./help.js";
import { make_layer_list } from "./layer_list.js";
import { first_layers, layers } from "./layers.js";
import { edge_filters } from "./overlay.js";
import { make_rasters } from "./raster.js";
import { tell_edge, tell_patch } from "./relations.js";
import { object_name, read_scene, scene_names } from "./scene.js";
import { make_object_list } from "./object_list.js";
import { make_solver } from "./solver.js";
import { make_stage } from "./stage.js";
import { make_view3d } from "./view3d.js";

const names = scene_names();
const state = {
  ...first_layers(),
  filter: "telling",
  cut: 0, // index into scene.cuts
  pinned: null, // {patch} or {edge}
  hovered: null, // {patch, point} or {edge}
  view: "layers", // or "3d"
  colour_by: "colour", // in 3D
  points: true,
  surfaces: true,
  edges: false,
};
let scene = null,
  images = null,
  view3d = null,
  view3d_scene = null,
  opening = 0;

// Theme: that of the system until one is chosen.

const dark_system = matchMedia("(prefers-color-scheme: dark)");
const is_dark = () => (document.documentElement.dataset.theme ?? (dark_system.matches ? "dark" : "light")) === "dark";
const toggle_theme = () => {
  document.documentElement.dataset.theme = is_dark() ? "light" : "dark";
  draw();
};
dark_system.addEventListener("change", () => draw());

// What is pointed at and pinned.

const pinned_patch = () => state.pinned?.patch ?? null;

/// The edge that is meant: the one under the pointer, or that between the pinned patch and the one under the pointer.
const meant = (item) => {
  if (!item || item.edge || item.patch === null) return item?.edge ? item : item && { ...item, edge: null };
  const first = pinned_patch();
  return { ...item, edge: first !== null && first !== item.patch ? scene.edge_between(first, item.patch) : null };
};

const on = {
  hover: (item, place) => {
    state.hovered = scene ? meant(item) : null;
    state.place = place;
    draw_pointer();
  },
  click: (item) =>
    pin(!item ? null : item.edge ? { edge: item.edge } : item.patch === null ? null : { patch: item.patch }),
  changed: () => draw(),
};

const pin = (item) => {
  const same = item && state.pinned && item.edge === state.pinned.edge && item.patch === state.pinned.patch;
  state.pinned = same && item.patch !== undefined ? null : item;
  if (state.hovered) state.hovered = meant(state.hovered);
  tell_pinned();
  edge_list.mark(state.pinned?.edge ?? null, pinned_patch());
  draw();
};

// Parts of the page.

const stage = make_stage(on);
const canvas3d = element("canvas", {
  class: "stage-3d",
  tabindex: 0,
  role: "application",
  "aria-label": "Points and surfaces in 3D; arrow keys orbit, with Shift they move",
  hidden: true,
});
const tooltip = element("div", { class: "tooltip", role: "tooltip", hidden: true });
const status = element("div", { class: "status" });
const message = element("div", { class: "message", role: "status", hidden: true });
const panel = element("section", { class: "panel", "aria-label": "Pinned patch or edge", "aria-live": "polite" });
const edge_list = make_edge_list((edge) => {
  state.hovered = null;
  pin({ edge });
});
const object_list = make_object_list((patch) => {
  state.hovered = null;
  state.pinned = null;
  pin({ patch });
});
const layer_list = make_layer_list(state, () => draw());
const solver = make_solver((cut) => {
  state.cut = cut;
  tell_pinned();
  draw();
});
const help = make_help();
const notes = element("div", { class: "notes", role: "note", hidden: true });
const facts = element("div", { class: "scene-facts" });
const chooser =
  names.length > 1
    ? element(
        "select",
        { class: "chooser", "aria-label": "Scene", onchange: () => open(chooser.selectedIndex) },
        names.map((name) => element("option", {}, name)),
      )
    : element("span", { class: "chooser" }, names[0]);

const tabs = Object.fromEntries(
  [
    ["layers", "Layers"],
    ["3d", "3D"],
  ].map(([view, name]) => [
    view,
    element("button", { type: "button", "aria-pressed": "false", title: "v", onclick: () => set_view(view) }, name),
  ]),
);

const radio = (value, name) => element("option", { value }, name);
const colour_by = element("select", {
  "aria-label": "Colour of the points",
  onchange: () => {
    state.colour_by = colour_by.value;
    draw();
  },
});
const switch_of = (key, name) => {
  const box = element("input", {
    type: "checkbox",
    onchange: () => {
      state[key] = box.checked;
      draw();
    },
  });
  box.checked = state[key];
  return element("label", {}, box, name);
};
const tools3d = element(
  "section",
  { class: "tools-3d", "aria-label": "3D", hidden: true },
  element("h2", {}, "3D"),
  switch_of("points", "Points"),
  colour_by,
  switch_of("surfaces", "Fitted surfaces"),
  switch_of("edges", "Graph"),
  element("button", { type: "button", class: "small", title: "0", onclick: () => view3d?.home() }, "Back to the start"),
);

document
  .getElementById("app")
  .append(
    element(
      "header",
      {},
      element("h1", {}, "Gestalt ", element("span", {}, "Inspector")),
      chooser,
      facts,
      element("div", { class: "tabs", role: "group", "aria-label": "View" }, tabs.layers, tabs["3d"]),
      element(
        "button",
        {
          type: "button",
          class: "icon",
          title: "Light or dark (t)",
          "aria-label": "Light or dark",
          onclick: toggle_theme,
        },
        "◐",
      ),
      element(
        "button",
        { type: "button", class: "icon", title: "Help (?)", "aria-label": "Help", onclick: () => help.showModal() },
        "?",
      ),
    ),
    element("aside", { class: "left", "aria-label": "Layers and solver" }, layer_list.root, tools3d, solver.root),
    element("main", {}, notes, element("div", { class: "stage" }, stage.root, canvas3d, message, tooltip), status),
    element("aside", { class: "right", "aria-label": "Objects and relations" }, object_list.root, panel, edge_list.root),
    help,
  );

// Drawing.

const marked = () => {
  const edges = [state.hovered?.edge, state.pinned?.edge].filter(Boolean);
  const patch = state.hovered?.edge ? pinned_patch() : (state.hovered?.patch ?? pinned_patch());
  return { patch: patch ?? null, edges };
};

const shown = { key: "", edges: [] };
const shown_edges = () => {
  const key = `${scene.index} ${state.filter}`;
  if (shown.key !== key) Object.assign(shown, { key, edges: scene.edges.filter(edge_filters[state.filter].test) });
  return shown.edges;
};

const background = () => (is_dark() ? [0.063, 0.071, 0.082, 1] : [0.9, 0.912, 0.925, 1]);

const paint = () => {
  if (!scene) return;
  const cut = scene.cuts[state.cut];
  if (state.view === "layers") {
    images.cut(cut);
    stage.draw(state, cut, state.visible.graph ? shown_edges() : [], marked());
  } else view3d?.draw(state, cut, shown_edges(), marked(), background());
  layer_list.show(scene);
  object_list.show(scene, cut);
};
const draw = once_a_frame(() => {
  paint();
  tell_pointer();
});
const draw_pointer = draw;

const tell_pointer = () => {
  const item = state.hovered;
  const cut = scene?.cuts[state.cut];
  status.replaceChildren(...(item && item.u !== undefined ? status_of(item, cut) : [element("span", {}, hint())]));
  tooltip.hidden = !item || (!item.edge && item.patch === null);
  if (tooltip.hidden) return;
  tooltip.replaceChildren(
    ...(item.edge ? tell_edge(scene, cut, item.edge) : tell_patch(scene, cut, item.patch, { point: item.point })),
  );
  const box = tooltip.parentElement,
    [x, y] = state.place;
  const w = tooltip.offsetWidth,
    h = tooltip.offsetHeight,
    gap = 16;
  const left = x + gap + w <= box.clientWidth ? x + gap : Math.max(4, x - gap - w);
  tooltip.style.left = `${left}px`;
  tooltip.style.top = `${Math.max(4, Math.min(y + gap, box.clientHeight - h - 4))}px`;
};

const hint = () =>
  pinned_patch() === null
    ? "Point at a patch or an edge; a click pins it."
    : `Patch ${pinned_patch()} is pinned: point at another patch to see how the two are related.`;

const status_of = ({ patch, point, u, v }, cut) => {
  const truth = scene.truth && object_name(scene.truth[v * scene.columns + u]);
  const segment = patch !== null && cut.segments[cut.labels[patch]];
  return [
    `pixel ${u * scene.step}, ${v * scene.step}`,
    point ? `${point[0].toFixed(3)}, ${point[1].toFixed(3)}, ${point[2].toFixed(3)} m` : "no depth",
    patch === null ? "no patch" : `patch ${patch}`,
    segment ? `segment ${segment.label}` : "",
    truth ? `ground truth: ${truth}` : "",
  ]
    .filter(Boolean)
    .map((text) => element("span", {}, text));
};

const tell_pinned = () => {
  if (!scene) return;
  const cut = scene.cuts[state.cut],
    item = state.pinned;
  const pin_patch = (patch) => pin({ patch });
  panel.replaceChildren(
    ...(!item
      ? [
          element(
            "p",
            { class: "empty" },
            "Nothing is pinned. Click an object, a patch or an edge, or choose an edge in the list (↑ ↓).",
          ),
        ]
      : [
          element(
            "button",
            {
              type: "button",
              class: "icon close",
              "aria-label": "Unpin",
              title: "Unpin (Esc)",
              onclick: () => pin(null),
            },
            "×",
          ),
          ...(item.edge
            ? tell_edge(scene, cut, item.edge, pin_patch)
            : tell_patch(scene, cut, item.patch, { edges: 0 })),
        ]),
  );
};

// Views and scenes.

const set_view = (view) => {
  state.view = view;
  const flat = view === "layers";
  message.hidden = true;
  for (const [name, tab] of Object.entries(tabs)) tab.setAttribute("aria-pressed", String(name === view));
  if (!flat && !view3d) {
    try {
      view3d = make_view3d(canvas3d, on);
    } catch {
      message.textContent = "3D needs WebGL, which this browser does not offer here. The layers work without it.";
    }
  }
  stage.root.hidden = layer_list.root.hidden = !flat;
  canvas3d.hidden = tools3d.hidden = flat || !view3d;
  message.hidden = flat || Boolean(view3d);
  state.hovered = null;
  if (!flat && view3d) open_in_3d();
  draw();
};

const open_in_3d = () => {
  if (!scene || view3d_scene === scene) return;
  if (scene.colour && !scene.rgb) {
    const context = new OffscreenCanvas(scene.columns, scene.rows).getContext("2d");
    context.drawImage(scene.colour, 0, 0);
    scene.rgb = context.getImageData(0, 0, scene.columns, scene.rows).data;
  }
  view3d_scene = scene;
  view3d.open(scene);
};

const tell_facts = () => {
  const { patches, edges, edges_left_out: left_out } = scene;
  const { objects } = scene.cuts[0];
  const wrong = edges.filter((edge) => edge.error > 0.5).length;
  const texts = [
    `${objects} ${objects === 1 ? "object" : "objects"}`,
    `${patches.length} ${patches.length === 1 ? "patch" : "patches"}`,
    `${(edges.length + left_out).toLocaleString("en")} edges`,
    scene.truth ? `${wrong} ${wrong === 1 ? "edge" : "edges"} wrong` : "no ground truth",
    `${scene.width} × ${scene.height}`,
  ];
  facts.replaceChildren(...texts.map((text) => element("span", {}, text)));
  notes.hidden = !scene.notes.length;
  notes.replaceChildren(...scene.notes.map((note) => element("p", {}, note)));
};

const open = async (index) => {
  const turn = ++opening;
  scene = null;
  state.hovered = state.pinned = null;
  const read = await read_scene(index);
  if (turn !== opening) return;
  scene = read;
  images = make_rasters(scene);
  stage.show(scene, images);
  if (names.length > 1) chooser.selectedIndex = index;
  document.title = `${scene.name} – Gestalt Inspector`;
  if (!scene.truth && edge_filters[state.filter].needs_truth) state.filter = "telling";
  if (!scene.colour && !state.visible.depth) state.visible.depth = true;
  colour_by.replaceChildren(
    ...[
      scene.colour && radio("colour", "Colour"),
      radio("segments", "Segments"),
      radio("patches", "Patches"),
      scene.truth && radio("truth", "Ground truth"),
    ].filter(Boolean),
  );
  if (![...colour_by.options].some(({ value }) => value === state.colour_by))
    state.colour_by = colour_by.options[0].value;
  colour_by.value = state.colour_by;
  layer_list.open(scene);
  edge_list.open(scene);
  solver.open(scene);
  tell_facts();
  tell_pinned();
  if (state.view === "3d" && view3d) open_in_3d();
  paint();
  tell_pointer();
  performance.mark("ready");
  document.getElementById("picture-0")?.setAttribute("hidden", "");
  document.documentElement.dataset.ready = index;
};

// Keys.

const toggle_layer = ({ id }, alone) => {
  if ((id === "truth" && !scene.truth) || (["colour", "edges"].includes(id) && !scene.colour)) return;
  if (alone) state.visible = { [id]: true };
  else state.visible[id] = !state.visible[id];
  draw();
};

const keys = {
  ArrowDown: () => edge_list.step(1),
  ArrowUp: () => edge_list.step(-1),
  "[": () => solver.step(-1),
  "]": () => solver.step(1),
  "\\": () => solver.reset(),
  v: () => set_view(state.view === "layers" ? "3d" : "layers"),
  t: toggle_theme,
  "?": () => help.showModal(),
  "+": () => (state.view === "layers" ? stage : view3d)?.zoom(1.25),
  "-": () => (state.view === "layers" ? stage : view3d)?.zoom(0.8),
  0: () => (state.view === "layers" ? stage.fit() : view3d?.home()),
  n: () => open((opening_index() + 1) % names.length),
  p: () => open((opening_index() + names.length - 1) % names.length),
  Escape: () => pin(null),
};
const opening_index = () => scene?.index ?? 0;

document.addEventListener("keydown", (event) => {
  if (help.open || event.ctrlKey || event.metaKey || event.altKey || !scene) return;
  const within = event.target.tagName;
  const digit = /^Digit([1-9])$/.exec(event.code);
  if (within === "SELECT" || (within === "INPUT" && event.target.type === "range" && event.key.startsWith("Arrow")))
    return;
  const layer = digit ? layers[Number(digit[1]) - 1] : layers.find(({ key }) => key === event.key.toLowerCase());
  if (layer) toggle_layer(layer, event.shiftKey);
  else if (Object.hasOwn(keys, event.key)) keys[event.key]();
  else return;
  event.preventDefault();
});

new ResizeObserver(() => draw()).observe(canvas3d);
set_view("layers");
open(0);
