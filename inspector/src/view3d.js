// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Points and fitted surfaces in 3D, in the camera's frame (x right, y down, z forward), seen from an orbit around what
// is in the middle of the scene.

import createREGL from "regl";
import { colour_of } from "./colours.js";
import { clamp } from "./dom.js";
import { edge_colour } from "./overlay.js";

const most_points = 150000;
const field_of_view = (45 * Math.PI) / 180;
const grey = [140, 144, 150];

const sub = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / (Math.hypot(...a) || 1));

/// Column-major 4x4 matrices, as WebGL has them.
const multiply = (a, b) => {
  const product = new Float32Array(16);
  for (let c = 0; c < 4; ++c)
    for (let r = 0; r < 4; ++r) for (let k = 0; k < 4; ++k) product[4 * c + r] += a[4 * k + r] * b[4 * c + k];
  return product;
};

const look_at = (eye, target, up) => {
  const z = unit(sub(eye, target)),
    x = unit(cross(up, z)),
    y = cross(z, x);
  return [x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot(x, eye), -dot(y, eye), -dot(z, eye), 1];
};

const perspective = (aspect, near, far) => {
  const f = 1 / Math.tan(field_of_view / 2);
  return [
    f / aspect,
    0,
    0,
    0,
    0,
    f,
    0,
    0,
    0,
    0,
    (far + near) / (near - far),
    -1,
    0,
    0,
    (2 * far * near) / (near - far),
    0,
  ];
};

const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];

const read_points = (scene) => {
  const measured = scene.depth.reduce((count, depth) => count + (depth > 0), 0);
  const step = Math.max(1, Math.ceil(Math.sqrt(measured / most_points)));
  const positions = [],
    pixels = [];
  for (let v = 0; v < scene.rows; v += step)
    for (let u = 0; u < scene.columns; u += step) {
      const point = scene.point_at(u, v);
      if (!point) continue;
      positions.push(...point);
      pixels.push(v * scene.columns + u);
    }
  return { positions: new Float32Array(positions), pixels: Int32Array.from(pixels), step };
};

/// All meshes as one, each vertex with the normal of its triangle's surface and its patch.
const read_meshes = (scene) => {
  const positions = [],
    normals = [],
    patches = [],
    triangles = [];
  scene.patches.forEach(({ mesh }, patch) => {
    if (!mesh) return;
    const first = patches.length;
    const at = (i) => [0, 1, 2].map((k) => mesh.vertices[3 * i + k] * scene.mesh_unit);
    const sums = Array.from({ length: mesh.vertices.length / 3 }, () => [0, 0, 0]);
    for (let i = 0; i < mesh.triangles.length; i += 3) {
      const corners = mesh.triangles.slice(i, i + 3);
      const [a, b, c] = corners.map(at),
        normal = cross(sub(b, a), sub(c, a));
      for (const corner of corners) normal.forEach((x, k) => (sums[corner][k] += x));
      triangles.push(...corners.map((corner) => first + corner));
    }
    sums.forEach((sum, i) => {
      positions.push(...at(i));
      normals.push(...unit(sum));
      patches.push(patch);
    });
  });
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    patches: Int32Array.from(patches),
    triangles: Uint32Array.from(triangles),
  };
};

const make_programs = (regl) => {
  const shared = {
    uniforms: { camera: regl.prop("camera") },
    blend: { enable: true, func: { src: "src alpha", dst: "one minus src alpha" } },
  };
  return {
    points: regl({
      ...shared,
      vert: `precision highp float; uniform mat4 camera; uniform float size; attribute vec3 position; attribute vec4 colour;
        varying vec4 shade; void main() { gl_Position = camera * vec4(position, 1.0); gl_PointSize = max(1.5, size / gl_Position.w);
        shade = colour; }`,
      frag: "precision mediump float; varying vec4 shade; void main() { gl_FragColor = shade; }",
      attributes: { position: regl.prop("position"), colour: { buffer: regl.prop("colour"), normalized: true } },
      uniforms: { ...shared.uniforms, size: regl.prop("size") },
      count: regl.prop("count"),
      primitive: "points",
    }),
    meshes: regl({
      ...shared,
      vert: `precision highp float; uniform mat4 camera; uniform vec3 eye; attribute vec3 position, normal; attribute vec4 colour;
        varying vec4 shade; void main() { gl_Position = camera * vec4(position, 1.0);
        float light = 0.55 + 0.45 * abs(dot(normalize(eye - position), normal));
        shade = vec4(colour.rgb * light, colour.a); }`,
      frag: "precision mediump float; varying vec4 shade; void main() { gl_FragColor = shade; }",
      attributes: {
        position: regl.prop("position"),
        normal: regl.prop("normal"),
        colour: { buffer: regl.prop("colour"), normalized: true },
      },
      uniforms: { ...shared.uniforms, eye: regl.prop("eye") },
      elements: regl.prop("elements"),
      depth: { mask: false },
      cull: { enable: false },
    }),
    edges: regl({
      ...shared,
      vert: `precision highp float; uniform mat4 camera; attribute vec3 position; attribute vec4 colour; varying vec4 shade;
        void main() { gl_Position = camera * vec4(position, 1.0); shade = colour; }`,
      frag: "precision mediump float; varying vec4 shade; void main() { gl_FragColor = shade; }",
      attributes: { position: regl.prop("position"), colour: { buffer: regl.prop("colour"), normalized: true } },
      count: regl.prop("count"),
      primitive: "lines",
      depth: { enable: false },
    }),
  };
};

/// Throws where there is no WebGL. on: {hover(item, place), click(item), changed()} as of the stage.
export const make_view3d = (canvas, on) => {
  const regl = createREGL({
    canvas,
    onDone: (error) => {
      if (error) throw new Error(error);
    },
    extensions: ["OES_element_index_uint"],
    attributes: { antialias: true, alpha: false, preserveDrawingBuffer: true },
  });
  const programs = make_programs(regl);
  let scene = null,
    points = null,
    meshes = null,
    buffers = {},
    camera = null,
    orbit = null,
    matrix = null,
    painted = "",
    drag = null;

  const home = () => {
    const sample = (k) =>
      median(
        Array.from({ length: 2000 }, (_, i) => points.positions[3 * Math.floor((i * points.pixels.length) / 2000) + k]),
      );
    const target = [0, 1, 2].map(sample);
    orbit = { target, yaw: 0.35, pitch: 0.3, distance: 1.15 * Math.hypot(...target) };
  };
  const eye_of = ({ target, yaw, pitch, distance }) =>
    // Yaw 0 and pitch 0: from where the camera looked, along z.
    [
      target[0] - distance * Math.sin(yaw) * Math.cos(pitch),
      target[1] - distance * Math.sin(pitch),
      target[2] - distance * Math.cos(yaw) * Math.cos(pitch),
    ];
  const aim = () => {
    const eye = eye_of(orbit),
      aspect = canvas.width / canvas.height || 1;
    camera = look_at(eye, orbit.target, [0, -1, 0]);
    matrix = multiply(perspective(aspect, 0.02 * orbit.distance, 20 * orbit.distance), camera);
    return eye;
  };

  /// Colours of all patches, by what is asked for.
  const patch_colours = (by, cut) =>
    scene.patches.map((patch, i) => {
      if (by === "patches") return colour_of(i + 1);
      if (by === "truth") return patch.object > 1 ? colour_of(patch.object) : grey;
      const segment = cut.segments[cut.labels[i]];
      return !segment || segment.background ? grey : segment.colour;
    });
  const paint = (state, cut, marked) => {
    const key = [state.colour_by, scene.cuts.indexOf(cut), marked.patch].join();
    if (key === painted) return;
    painted = key;
    const colours = patch_colours(state.colour_by, cut);
    const bytes = new Uint8Array(4 * points.pixels.length);
    points.pixels.forEach((pixel, i) => {
      const patch = scene.patch_of[pixel] - 1;
      const own = scene.rgb ? [scene.rgb[4 * pixel], scene.rgb[4 * pixel + 1], scene.rgb[4 * pixel + 2]] : grey;
      const tint = state.colour_by === "colour" || patch < 0 ? own : colours[patch];
      const lift = patch >= 0 && patch === marked.patch ? 0.45 : 0;
      for (let k = 0; k < 3; ++k) bytes[4 * i + k] = tint[k] + lift * (255 - tint[k]);
      bytes[4 * i + 3] = 255;
    });
    buffers.point_colours(bytes);
    const surface_colours = state.colour_by === "colour" ? patch_colours("segments", cut) : colours;
    const of_vertices = new Uint8Array(4 * meshes.patches.length);
    meshes.patches.forEach((patch, i) => {
      of_vertices.set(surface_colours[patch], 4 * i);
      of_vertices[4 * i + 3] = patch === marked.patch ? 215 : cut.segments[cut.labels[patch]]?.background ? 60 : 130;
    });
    buffers.mesh_colours(of_vertices);
  };

  const draw_edges = (edges, marked) => {
    const listed = [...edges, ...marked.edges].filter((edge) => scene.anchors[edge.a] && scene.anchors[edge.b]);
    if (!listed.length) return;
    const positions = [],
      colours = [];
    for (const edge of listed) {
      positions.push(...scene.anchors[edge.a], ...scene.anchors[edge.b]);
      const colour = [...edge_colour(edge), marked.edges.includes(edge) ? 255 : marked.edges.length ? 50 : 150];
      colours.push(...colour, ...colour);
    }
    programs.edges({ camera: matrix, position: positions, colour: new Uint8Array(colours), count: 2 * listed.length });
  };

  const place_of = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  /// The nearest point within some pixels of a place.
  const item_at = ([x, y]) => {
    if (!matrix || !points) return null;
    const w = canvas.clientWidth,
      h = canvas.clientHeight,
      m = matrix,
      p = points.positions;
    let best = -1,
      least = Infinity;
    for (let i = 0; i < points.pixels.length; i += 2) {
      const a = p[3 * i],
        b = p[3 * i + 1],
        c = p[3 * i + 2];
      const depth = m[3] * a + m[7] * b + m[11] * c + m[15];
      if (depth <= 0) continue;
      const dx = (((m[0] * a + m[4] * b + m[8] * c + m[12]) / depth + 1) * w) / 2 - x;
      const dy = ((1 - (m[1] * a + m[5] * b + m[9] * c + m[13]) / depth) * h) / 2 - y;
      if (dx * dx + dy * dy > 25 || depth >= least) continue;
      least = depth;
      best = i;
    }
    if (best < 0) return null;
    const pixel = points.pixels[best],
      patch = scene.patch_of[pixel];
    return {
      patch: patch ? patch - 1 : null,
      point: Array.from(p.slice(3 * best, 3 * best + 3)),
      u: pixel % scene.columns,
      v: Math.floor(pixel / scene.columns),
    };
  };

  const turn = (yaw, pitch) => {
    orbit.yaw += yaw;
    orbit.pitch = clamp(orbit.pitch + pitch, -1.5, 1.5);
    on.changed();
  };
  const shift = (dx, dy) => {
    const size = (2 * orbit.distance * Math.tan(field_of_view / 2)) / (canvas.clientHeight || 1);
    for (let k = 0; k < 3; ++k) orbit.target[k] += size * (-dx * camera[4 * k] + dy * camera[4 * k + 1]);
    on.changed();
  };
  const zoom = (factor) => {
    orbit.distance = clamp(orbit.distance / factor, 0.05, 100);
    on.changed();
  };

  canvas.addEventListener("pointerdown", (event) => {
    drag = { last: place_of(event), from: place_of(event), moved: false, shift: event.shiftKey || event.button !== 0 };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const place = place_of(event);
    if (!drag) return on.hover(item_at(place), place);
    const dx = place[0] - drag.last[0],
      dy = place[1] - drag.last[1];
    drag.moved ||= Math.hypot(place[0] - drag.from[0], place[1] - drag.from[1]) >= 4;
    drag.last = place;
    if (!drag.moved) return;
    on.hover(null, place);
    if (drag.shift) shift(dx, dy);
    else turn(dx * 0.006, dy * 0.006);
  });
  canvas.addEventListener("pointerup", (event) => {
    if (drag && !drag.moved && !drag.shift) on.click(item_at(place_of(event)));
    drag = null;
  });
  canvas.addEventListener("pointercancel", () => (drag = null));
  canvas.addEventListener("pointerleave", () => on.hover(null, [0, 0]));
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      zoom(Math.exp(-clamp(event.deltaY, -60, 60) * 0.005));
    },
    { passive: false },
  );
  canvas.addEventListener("dblclick", () => {
    home();
    on.changed();
  });
  canvas.addEventListener("keydown", (event) => {
    const step = event.shiftKey ? { move: 25 } : { turn: 0.08 };
    const [x, y] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [0, 0];
    if (!x && !y) return;
    event.preventDefault();
    event.stopPropagation();
    if (step.move) shift(-x * step.move, -y * step.move);
    else turn(x * step.turn, -y * step.turn);
  });

  return {
    zoom,
    home: () => {
      home();
      on.changed();
    },
    open: (opened) => {
      scene = opened;
      painted = "";
      points = read_points(scene);
      meshes = read_meshes(scene);
      scene.anchors = scene.patches.map(({ anchor: [u, v] }) =>
        scene.point_at(Math.floor(u / scene.step), Math.floor(v / scene.step)),
      );
      Object.values(buffers).forEach((buffer) => buffer.destroy());
      buffers = {
        points: regl.buffer(points.positions),
        point_colours: regl.buffer({ usage: "dynamic", type: "uint8", length: 4 * points.pixels.length }),
        meshes: regl.buffer(meshes.positions),
        normals: regl.buffer(meshes.normals),
        mesh_colours: regl.buffer({ usage: "dynamic", type: "uint8", length: 4 * Math.max(1, meshes.patches.length) }),
        triangles: regl.elements({ data: meshes.triangles, type: "uint32", primitive: "triangles" }),
      };
      home();
    },
    draw: (state, cut, edges, marked, background) => {
      const ratio = window.devicePixelRatio || 1;
      const width = Math.round(canvas.clientWidth * ratio),
        height = Math.round(canvas.clientHeight * ratio);
      if (!scene || !width || !height) return;
      if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
      regl.poll();
      const eye = aim();
      paint(state, cut, marked);
      regl.clear({ color: background, depth: 1 });
      const size = (1.2 * points.step * scene.step * height) / (2 * Math.tan(field_of_view / 2)) / scene.camera.fy;
      if (state.points)
        programs.points({
          camera: matrix,
          position: buffers.points,
          colour: buffers.point_colours,
          count: points.pixels.length,
          size: size * Math.hypot(...orbit.target),
        });
      if (state.surfaces && meshes.triangles.length)
        programs.meshes({
          camera: matrix,
          eye,
          position: buffers.meshes,
          normal: buffers.normals,
          colour: buffers.mesh_colours,
          elements: buffers.triangles,
        });
      if (state.edges) draw_edges(edges, marked);
      else draw_edges([], marked);
    },
  };
};
