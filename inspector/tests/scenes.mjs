// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Scenes and pages for the tests, made by the real command (named in GESTALT) below the folder in INSPECTOR_TESTS.

import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { crc32, deflateSync } from "node:zlib";

const needed = (name) => {
  const value = process.env[name];
  if (!value)
    throw new Error(`${name} is not set; ctest -R inspector sets it, README.md shows how to run it without ctest`);
  return value;
};

// Each test file runs in a process of its own.
export const folder = join(needed("INSPECTOR_TESTS"), basename(process.argv[1], ".mjs"));
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });

export const gestalt = (...words) =>
  execFileSync(needed("GESTALT"), words, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

/// Segments a scene and gives its page with the data in it.
export const page_of = (name, scenes, options = []) => {
  const out = join(folder, `${name}_results`);
  // Its two parameters are two sliders with many different cuts.
  gestalt("segment", ...scenes, "--output", out, ...options, "--set", "decision.solver=group_linkage");
  const results = scenes.map((scene) => join(out, scene.split("/").at(-1)));
  const file = join(folder, `${name}.html`);
  gestalt("inspect", ...results, "--output", file);
  return { file, results, scenes: data_of(file) };
};

/// The scenes in a page.
export const data_of = (file) =>
  [...readFileSync(file, "utf8").matchAll(/<script type="application\/json" id="scene-\d+">(.*?)<\/script>/gs)].map(
    ([, text]) => JSON.parse(text),
  );

const png = (width, height, bits, channels, samples) => {
  const chunk = (type, data) => {
    const body = Buffer.concat([Buffer.from(type, "latin1"), data]);
    const ends = Buffer.alloc(8);
    ends.writeUInt32BE(data.length, 0);
    ends.writeUInt32BE(crc32(body), 4);
    return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)]);
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([bits, channels === 3 ? 2 : 0, 0, 0, 0], 8);
  const row = 1 + (width * channels * bits) / 8,
    rows = Buffer.alloc(row * height);
  samples.forEach((sample, i) => {
    const at = Math.floor(i / (width * channels)) * row + 1 + ((i % (width * channels)) * bits) / 8;
    if (bits === 16) rows.writeUInt16BE(sample, at);
    else rows[at] = sample;
  });
  return Buffer.concat([
    Buffer.from("\x89PNG\r\n\x1a\n", "latin1"),
    chunk("IHDR", head),
    chunk("IDAT", deflateSync(rows)),
    chunk("IEND", Buffer.alloc(0)),
  ]);
};

/// A scene of columns x rows facets, tilted in turn to all sides, each with a colour of its own; four by four are an
/// object of the ground truth.
export const facets = (columns, rows) => {
  const width = 640,
    height = 480,
    f = 525,
    cx = 319.5,
    cy = 239.5,
    distance = 0.8;
  const depth = [],
    colour = [],
    label = [];
  for (let v = 0; v < height; ++v)
    for (let u = 0; u < width; ++u) {
      const column = Math.floor((u * columns) / width),
        row = Math.floor((v * rows) / height);
      const x0 = (((column + 0.5) * width) / columns - cx) / f,
        y0 = (((row + 0.5) * height) / rows - cy) / f;
      const sx = column % 2 ? 0.7 : -0.7,
        sy = row % 2 ? 0.7 : -0.7;
      const z = (distance * (1 - sx * x0 - sy * y0)) / (1 - (sx * (u - cx)) / f - (sy * (v - cy)) / f);
      depth.push(Math.round(10000 * z));
      colour.push(50 + ((37 * column) % 150), 50 + ((53 * row) % 150), 50 + ((71 * (column + row)) % 150));
      label.push(20 + 10 * (Math.floor(column / 4) + 7 * Math.floor(row / 4)));
    }
  const scene = join(folder, `facets_${columns * rows}`);
  mkdirSync(scene, { recursive: true });
  writeFileSync(join(scene, "depth.png"), png(width, height, 16, 1, depth));
  writeFileSync(join(scene, "rgb.png"), png(width, height, 8, 3, colour));
  writeFileSync(join(scene, "label.png"), png(width, height, 16, 1, label));
  writeFileSync(
    join(scene, "camera.yaml"),
    `width: ${width}\nheight: ${height}\nfx: ${f}\nfy: ${f}\ncx: ${cx}\ncy: ${cy}\ndepth_scale: 0.0001\n`,
  );
  return scene;
};
