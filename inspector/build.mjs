// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Bundles src/ into one page, dist/inspector.html, that loads nothing. With --check only compares the two.

import { createHash } from "node:crypto";
import { readFileSync, mkdirSync, renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const root = fileURLToPath(new URL(".", import.meta.url));
const file = join(root, "dist", "inspector.html");

const bundle = async (entry) => {
  const result = await build({
    entryPoints: [join(root, "src", entry)],
    bundle: true,
    minify: true,
    write: false,
    charset: "utf8",
    format: "iife",
    target: "es2022",
    legalComments: "none",
    absWorkingDir: root,
  });
  return result.outputFiles[0].text.trim();
};

const page = async () => {
  const script = await bundle("main.js");
  if (/<\/script|<!--/i.test(script)) throw new Error("the script would end its element");
  const parts = {
    licence: readFileSync(join(root, "node_modules", "regl", "LICENSE"), "utf8")
      .trim()
      .replaceAll("--", "- -"),
    // Only this script runs, whatever stands in the data of a scene.
    hash: createHash("sha256").update(script).digest("base64"),
    style: await bundle("style.css"),
    script,
  };
  return readFileSync(join(root, "src", "page.html"), "utf8").replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name]);
};

const fresh = await page();
if (process.argv.includes("--check")) {
  if (readFileSync(file, "utf8") !== fresh) {
    console.error("dist/inspector.html is not what src/ builds to; run `npm run build` and commit it");
    process.exit(1);
  }
} else {
  mkdirSync(join(root, "dist"), { recursive: true });
  writeFileSync(`${file}.new`, fresh);
  renameSync(`${file}.new`, file);
  console.log(`${file}: ${Math.ceil(fresh.length / 1000)} kB`);
}
