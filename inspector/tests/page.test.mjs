// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The page in a real Chromium: every layer, pointing, the slider, the list, keys, themes, 3D.

import assert from "node:assert/strict";
import { cpSync, mkdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launch, open } from "./browser.mjs";
import { data_of, folder, gestalt, page_of } from "./scenes.mjs";

const layer_ids = ["colour", "depth", "patches", "surfaces", "lines", "closures", "graph", "segments", "truth", "edges"];
const layer_key = (i) => (layer_ids[i] === "edges" ? "Shift+KeyE" : `Shift+Digit${i + 1}`);
let browser, made, scene, page;

before(async () => {
  gestalt(
    "synthesize",
    "--category",
    "mixed_objects",
    "--seed",
    "1",
    "--count",
    "2",
    "--width",
    "320",
    "--height",
    "240",
    "--output",
    join(folder, "scenes"),
  );
  made = page_of(
    "two",
    ["mixed_objects_1_000", "mixed_objects_1_001"].map((name) => join(folder, "scenes", name)),
  );
  scene = made.scenes[0];
  browser = await launch();
});
after(() => browser?.close());

/// Runs work on a fresh page of the two scenes; nothing may go wrong in it.
const on_page = async (work, options = {}, file = made.file) => {
  page = await open(browser, file, options);
  try {
    await work(page);
    assert.deepEqual(page.problems, []);
  } finally {
    await page.context().close();
  }
};

/// Pixels of the stage that differ from what they were in before, of all; what lies over the stage does not count.
const stage_of = () => page.locator(".stage").screenshot();
const settled = () =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const is_same = async (before) => before.equals(await stage_of());

/// Where a pixel of the scene is on the screen: the stage fits the scene into itself.
const place_of = async ([u, v], data = scene) => {
  const box = await page.locator(".stage-2d").boundingBox(),
    { width, height } = data.camera;
  const scale = Math.min((box.width - 24) / width, (box.height - 24) / height);
  return [
    box.x + (box.width - scale * width) / 2 + (u + 0.5) * scale,
    box.y + (box.height - scale * height) / 2 + (v + 0.5) * scale,
  ];
};
const point_at = async (pixel) => {
  await page.mouse.move(...(await place_of(pixel)));
  await settled();
};
const click_at = async (pixel) => {
  await page.mouse.click(...(await place_of(pixel)));
  await settled();
};
const press = async (...keys) => {
  for (const key of keys) await page.keyboard.press(key);
  await settled();
};
const text_of = (selector) => page.locator(selector).innerText();
const rows = () => page.locator(".edge-list .row .pair").allInnerTexts();

const error_of = ([, , , p, truth]) => (truth === null ? -1 : Math.abs(p - truth));
const by_error = (data) =>
  data.edges
    .map((edge, i) => [edge, i])
    .sort(([x, i], [y, j]) => error_of(y) - error_of(x) || i - j)
    .map(([edge]) => edge);

test("every layer shows something of its own, by mouse and by key", () =>
  on_page(async () => {
    const seen = new Map();
    for (const [i, id] of layer_ids.entries()) {
      await press(layer_key(i));
      assert.deepEqual(
        await page.locator(".layers input[type=checkbox]:checked").evaluateAll((boxes) => boxes.map((box) => box.id)),
        [`layer-${id}`],
      );
      const picture = await stage_of();
      for (const [other, its] of seen) assert(!picture.equals(its), `${id} looks like ${other}`);
      seen.set(id, picture);
    }
    await press("Shift+Digit9");
    const truth = await stage_of();
    await page.locator("#layer-colour").click();
    assert(!(await is_same(truth)));
    await page.locator("#layer-colour").click();
    assert(await is_same(truth));
    await page.getByLabel("Opacity of Ground truth").fill("0");
    await settled();
    assert(!(await is_same(truth)));
  }));

test("depth and normals mean what they say", () =>
  on_page(async () => {
    await press("Shift+Digit2");
    const [near, far] = await page.locator(".ramp span:not(.bar)").allInnerTexts();
    assert(Number(near) > 0.3 && parseFloat(far) > Number(near) && parseFloat(far) < 10, `${near} ${far}`);
    const patch = scene.patches.findIndex(({ pixels }) => pixels > 500);
    await point_at(scene.patches[patch].anchor);
    const [, , z] = /(-?[\d.]+), (-?[\d.]+), ([\d.]+) m/
      .exec(await text_of(".status"))
      .slice(1)
      .map(Number);
    const { mesh } = scene.patches[patch];
    const depths = mesh.vertices.filter((_, i) => i % 3 === 2).map((x) => x * scene.mesh_unit);
    assert(
      z > Math.min(...depths) - 0.03 && z < Math.max(...depths) + 0.03,
      `${z} of ${Math.min(...depths)} to ${Math.max(...depths)}`,
    );
  }));

test("pointing at a patch tells its facts and edges", () =>
  on_page(async () => {
    await press("Shift+Digit3");
    for (const [patch, told] of scene.patches.entries()) {
      if (told.pixels < 300) continue;
      await point_at(told.anchor);
      const text = await text_of(".tooltip");
      assert(text.startsWith(`Patch ${patch}\n`), text);
      assert.match(text, new RegExp(`${(1000 * told.rms).toFixed(2)} mm RMS`));
      assert.match(
        text,
        told.object === 0
          ? /Ground truth\s+none/
          : told.object === 1
            ? /Ground truth\s+background/
            : new RegExp(`Ground truth\\s+object ${told.object - 1}`),
      );
      const count = scene.edges.filter(([a, b]) => a === patch || b === patch).length;
      assert.match(text, count ? new RegExp(`${count} edges`) : /No edges/);
    }
  }));

/// The number that a text as "−2.4·10⁻⁵" tells.
const number_of = (text) =>
  Number(
    text
      .replace("·10", "e")
      .replace("−", "-")
      .replace(/[⁻⁰-⁹¹²³]/g, (digit) => "-0123456789"["⁻⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(digit)]),
  );

/// Expects a shown edge to be told in full.
const expect_edge = (text, [a, b, level, p, truth, values, contributions]) => {
  assert.match(text, new RegExp(`^Patch ${a}\\s+–\\s+Patch ${b}\\s+${scene.levels[level].name}`));
  if (p > 0.001 && p < 0.999) assert(text.includes(`p = ${p.toFixed(3)}`), text);
  const verdict =
    truth === null ? "ground truth does not say" : p >= 0.5 === (truth === 1) ? "p agrees" : "p disagrees";
  assert(text.includes(verdict), text);
  const reasons = /^(One object|Two objects): (.*)$/m.exec(text);
  assert.equal(reasons?.[1], p >= 0.5 ? "One object" : "Two objects", text);
  for (const [, part] of reasons[2].matchAll(/ ([+−]\d\.\d\d)(?=[,;]|$)/g)) {
    const told = Number(part.replace("−", "-"));
    assert(contributions.some((one) => Math.abs(one - told) < 0.006), `${part} is not a contribution: ${text}`);
  }
  const shown = [...text.matchAll(/^(r_\S+)\n([^\t\n]+)\s+(\S+)\s+([+−]?[\d.]+)$/gm)];
  assert.equal(shown.length, values.length, text);
  for (const [, name, relation, value, part] of shown) {
    const i = scene.levels[level].values.findIndex((one) => one.name === name);
    assert.equal(relation, scene.levels[level].values[i].relation.replaceAll("_", " "));
    assert(
      Math.abs(number_of(value) - values[i]) <= 0.06 * Math.abs(values[i]),
      `${name} ${value}`,
    );
    assert.equal(Number(part.replace("−", "-")), contributions[i]);
  }
};

test("pointing at an edge tells its relation values, contributions, p and ground truth", () =>
  on_page(async () => {
    await press("Shift+Digit7");
    await page.getByLabel("Edges of the graph layer").selectOption("structural");
    await page.locator(".stage-2d").focus();
    const structural = scene.edges.filter(([, , level]) => level === 0);
    let told = 0;
    for (const edge of structural) {
      const [x, y] = scene.patches[edge[0]].anchor,
        [u, v] = scene.patches[edge[1]].anchor;
      await point_at([(x + u) / 2, (y + v) / 2]);
      const text = await text_of(".tooltip");
      if (!text.startsWith(`Patch ${edge[0]}`) || !text.includes(`Patch ${edge[1]}\n`) || !text.includes("structural"))
        continue; // where two cross
      expect_edge(text, edge);
      ++told;
    }
    assert(told > structural.length / 2, `${told} of ${structural.length}`);
  }));

test("a pinned patch and one that is pointed at show what relates the two", () =>
  on_page(async () => {
    const edge = scene.edges.find(([a, b]) => scene.patches[a].pixels > 300 && scene.patches[b].pixels > 300);
    await press("Shift+Digit1");
    await click_at(scene.patches[edge[0]].anchor);
    assert.match(await text_of(".panel"), new RegExp(`Patch ${edge[0]}\n`));
    await point_at(scene.patches[edge[1]].anchor);
    expect_edge(await text_of(".tooltip"), edge);
    const listed = await rows();
    assert(listed.length > 0 && listed.every((pair) => pair.split(" – ").includes(String(edge[0]))), listed.join());
    await press("Escape");
    assert.match(await text_of(".panel"), /Nothing is pinned/);
  }));

test("the list begins with the wrongest edges, and arrow keys go through it", () =>
  on_page(async () => {
    const expected = by_error(scene).map(([a, b]) => `${a} – ${b}`);
    const listed = await rows();
    assert(listed.length > 5);
    assert.deepEqual(listed, expected.slice(0, listed.length));
    for (let i = 0; i < 3; ++i) {
      await press("ArrowDown");
      assert.equal(await text_of(".row[aria-selected=true] .pair"), expected[i]);
      expect_edge(
        await text_of(".panel .edge-title")
          .then(() => text_of(".panel"))
          .then((text) => text.replace(/^×\s*/, "")),
        by_error(scene)[i],
      );
    }
    await press("ArrowUp");
    assert.equal(await text_of(".row[aria-selected=true] .pair"), expected[1]);
    await page.locator(".edge-list").focus();
    await press("End");
    assert.equal(await text_of(".row[aria-selected=true] .pair"), expected.at(-1));
    assert.equal(
      await page.locator(".edge-list").getAttribute("aria-activedescendant"),
      await page.locator(".row[aria-selected=true]").getAttribute("id"),
    );
    await page.getByLabel("Order of the edges").selectOption("patches");
    await page.getByLabel("Edges in the list").selectOption("assembly");
    const first = scene.edges.find(([, , level]) => level === 1);
    assert.equal((await rows())[0], `${first[0]} – ${first[1]}`);
  }));

test("the objects are listed, the largest first, in the colours of overlay.png", () =>
  on_page(async () => {
    const { labels, background } = scene.solver.cuts[0];
    const objects = [...new Set(labels)].filter((label) => !background.includes(label));
    const listed = await page.locator(".object").evaluateAll((rows) =>
      rows.map((row) => ({
        label: Number(row.querySelector("b").innerText.replace("Object ", "")),
        pixels: Number(row.querySelector(".dim").innerText.replace(/ pixel.*|,/g, "")),
        colour: getComputedStyle(row.querySelector(".swatch")).backgroundColor,
      })),
    );
    assert.deepEqual(listed.map(({ label }) => label).sort(), objects.sort());
    for (const [i, { label, pixels, colour }] of listed.entries()) {
      const patches = scene.patches.filter((_, patch) => labels[patch] === label);
      assert.equal(
        pixels,
        patches.reduce((sum, patch) => sum + patch.pixels, 0),
      );
      assert(i === 0 || pixels <= listed[i - 1].pixels);
      assert.equal(colour, `rgb(${scene.colours[label - 1].join(", ")})`);
    }
    await page.locator(".object").first().click();
    assert.match(await text_of(".panel"), new RegExp(`${listed[0].label}, object of`));
  }));

test("3D keeps its proportions when the window changes", () =>
  on_page(async () => {
    await press("v");
    for (const size of [
      { width: 1000, height: 700 },
      { width: 1400, height: 620 },
    ]) {
      await page.setViewportSize(size);
      await settled();
      const [drawn, shown] = await page
        .locator(".stage-3d")
        .evaluate((canvas) => [canvas.width / canvas.height, canvas.clientWidth / canvas.clientHeight]);
      assert(Math.abs(drawn - shown) < 0.01, `${drawn} instead of ${shown}`);
    }
  }));

test("everything fits into a window of 1000 by 700", () =>
  on_page(async () => {
    await page.setViewportSize({ width: 1000, height: 700 });
    await settled();
    for (const part of ["html", "aside.left", "aside.right", ".edge-list", ".object-list"])
      assert(await page.locator(part).evaluate((node) => node.scrollWidth <= node.clientWidth), part);
    for (const part of [".stage-2d", ".object-list", ".edge-list", ".solver"])
      assert(await page.locator(part).isVisible(), part);
  }));

test("the slider cuts the graph again, as the solver does", () =>
  on_page(async () => {
    const { sweeps, cuts } = scene.solver;
    assert.deepEqual(
      sweeps.map(({ name }) => name),
      ["k", "probability"],
    );
    const sweep = sweeps[1],
      slider = page.getByLabel("Value of the parameter");
    assert.equal(await text_of(".solver .value"), String(sweep.current));
    await press("Shift+Digit8");
    const objects = (cut) => new Set(cut.labels.filter((label) => !cut.background.includes(label))).size;
    const pictures = new Map();
    for (const index of [0, 20, sweep.values.indexOf(sweep.current), 50, sweep.values.length - 1]) {
      await slider.fill(String(index));
      await settled();
      const cut = sweep.cuts[index];
      assert.match(await text_of(".outcome"), new RegExp(`^${objects(cuts[cut])} object`));
      const picture = await stage_of();
      for (const [other, its] of pictures) assert.equal(picture.equals(its), other === cut, `${other} ${cut}`);
      pictures.set(cut, picture);
    }
    assert(pictures.size > 1);
    await press("\\");
    assert.equal(await text_of(".solver .value"), String(sweep.current));
    await press("]");
    const next = sweep.cuts.findIndex((cut, i) => i > sweep.values.indexOf(sweep.current) && cut !== 0);
    assert.equal(Number(await slider.inputValue()), next);
    await press("[");
    assert.equal(sweep.cuts[Number(await slider.inputValue())], 0);

    // The same by the command itself.
    const index = 15,
      out = join(folder, "recut");
    gestalt(
      "segment",
      join(folder, "scenes", scene.name),
      "--output",
      out,
      "--set",
      "decision.solver=group_linkage",
      `decision.solver.params.probability=${sweep.values[index]}`,
    );
    gestalt("inspect", join(out, scene.name), "--output", join(folder, "recut.html"));
    assert.deepEqual(data_of(join(folder, "recut.html"))[0].solver.cuts[0], cuts[sweep.cuts[index]]);
  }));

test("wheel, drag and double click move the scene", () =>
  on_page(async () => {
    const before = await stage_of(),
      [x, y] = await place_of([160, 120]);
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, -300);
    await page.mouse.down();
    await page.mouse.move(x + 60, y + 40, { steps: 4 });
    await page.mouse.up();
    await page.mouse.move(5, 5);
    await settled();
    assert(!(await is_same(before)));
    assert.match(await text_of(".panel"), /Nothing is pinned/);
    await page.mouse.dblclick(x, y);
    await page.locator(".stage-2d").blur();
    await page.mouse.move(5, 5);
    await settled();
    assert(await is_same(before));
  }));

test("light and dark follow the system, and a key changes them", async () => {
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const grounds = {};
  for (const colorScheme of ["light", "dark"])
    await on_page(
      async () => {
        grounds[colorScheme] = await ground();
        await press("t");
        grounds[`${colorScheme}_changed`] = await ground();
        await press("t");
        assert.equal(await ground(), grounds[colorScheme]);
      },
      { colorScheme },
    );
  assert.notEqual(grounds.light, grounds.dark);
  assert.equal(grounds.light_changed, grounds.dark);
  assert.equal(grounds.dark_changed, grounds.light);
});

test("points and surfaces in 3D turn by mouse and by key and tell their patch", () =>
  on_page(async () => {
    await press("v");
    assert.equal(await page.locator(".message").isVisible(), false);
    const both = await stage_of();
    await page.getByLabel("Points", { exact: true }).click();
    await settled();
    const surfaces = await stage_of();
    await page.getByLabel("Points", { exact: true }).click();
    await page.getByLabel("Fitted surfaces").click();
    await settled();
    const points = await stage_of();
    assert(!both.equals(surfaces) && !both.equals(points) && !points.equals(surfaces));
    const box = await page.locator(".stage-3d").boundingBox(),
      middle = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(...middle);
    await settled();
    assert.match(await text_of(".tooltip"), /^Patch \d+/);
    await page.mouse.down();
    await page.mouse.move(middle[0] + 80, middle[1], { steps: 4 });
    await page.mouse.up();
    await page.mouse.move(5, 5);
    await settled();
    const turned = await stage_of();
    assert(!turned.equals(points));
    await page.locator(".stage-3d").focus();
    await press("ArrowRight", "ArrowUp");
    assert(!(await is_same(turned)));
    await press("0");
    await page.locator(".stage-3d").blur();
    await settled();
    assert(await is_same(points));
    await page.getByLabel("Colour of the points").selectOption("segments");
    await settled();
    assert(!(await is_same(points)));
  }));

test("without WebGL the layers work, and 3D says why it does not", async () => {
  const plain = await launch({ webgl: false });
  try {
    page = await open(plain, made.file);
    await press("v");
    assert.match(await text_of(".message"), /WebGL/);
    await press("v");
    await point_at(scene.patches.find(({ pixels }) => pixels > 500).anchor);
    assert.match(await text_of(".tooltip"), /^Patch/);
    assert.deepEqual(
      page.problems.filter((text) => !/WebGL/.test(text)),
      [],
    );
  } finally {
    await plain.close();
  }
});

test("several scenes can be chosen", () =>
  on_page(async () => {
    const first = await stage_of();
    await page.getByLabel("Scene", { exact: true }).selectOption(made.scenes[1].name);
    await page.waitForSelector("html[data-ready='1']");
    assert.match(await text_of(".scene-facts"), new RegExp(`${made.scenes[1].patches.length} patches`));
    assert(!(await is_same(first)));
    await page.locator(".chooser").blur();
    await press("n");
    await page.waitForSelector("html[data-ready='0']");
    await settled();
    assert(await is_same(first));
  }));

test("help opens by key and closes", () =>
  on_page(async () => {
    await press("?");
    assert(await page.locator("dialog.help").isVisible());
    const text = await page.locator("dialog.help").innerText();
    assert.match(text, /show or hide a layer/);
    assert.doesNotMatch(text, /\[object/);
    await press("Escape");
    assert(!(await page.locator("dialog.help").isVisible()));
  }));

test("everything can be reached and has a name", () =>
  on_page(async () => {
    const nameless = await page
      .locator("button, input, select, [tabindex='0']")
      .evaluateAll((all) =>
        all
          .filter(
            (one) =>
              one.offsetParent !== null &&
              !(one.getAttribute("aria-label") || one.labels?.length || one.textContent.trim()),
          )
          .map((one) => one.outerHTML),
      );
    assert.deepEqual(nameless, []);
    const reached = new Set();
    for (let i = 0; i < 60; ++i) {
      await page.keyboard.press("Tab");
      reached.add(
        await page.evaluate(
          () =>
            document.activeElement.className ||
            document.activeElement.id ||
            document.activeElement.getAttribute("aria-label"),
        ),
      );
    }
    for (const wanted of ["stage-2d", "edge-list", "layer-graph", "Value of the parameter"])
      assert(reached.has(wanted), `${wanted} not in ${[...reached]}`);
  }));

test("an untrusted name stays a name", async () => {
  const name = `<img src=x onerror=alert(1)><!--<script>"'&`;
  const odd = join(folder, "odd", name);
  mkdirSync(join(folder, "odd"), { recursive: true });
  cpSync(join(folder, "scenes", scene.name), odd, { recursive: true });
  cpSync(join(folder, "scenes", "camera.yaml"), join(odd, "camera.yaml"));
  const out = join(folder, "odd_results");
  gestalt("segment", odd, "--output", out);
  const file = join(folder, "odd.html");
  gestalt("inspect", join(out, name), "--output", file);
  await on_page(
    async () => {
      assert.equal(await text_of(".chooser"), name);
      assert.equal(await page.locator("#app img").count(), 0);
    },
    {},
    file,
  );
});

test("scenes without ground truth or colour are shown too", async () => {
  const bare = join(folder, "bare", "bare");
  cpSync(join(folder, "scenes", scene.name), bare, {
    recursive: true,
    filter: (path) => !/(label|rgb)\.png$/.test(path),
  });
  cpSync(join(folder, "scenes", "camera.yaml"), join(bare, "camera.yaml"));
  const model = join(folder, "bare.json"),
    config = [
      "structural.relations.colour_histogram",
      "structural.relations.texture_quantity",
      "structural.relations.gabor",
      "structural.relations.fourier",
      "structural.relations.border_colour",
      "assembly.relations.colour_histogram",
    ].flatMap((relation) => ["--set", `${relation}=off`]);
  gestalt("train", join(folder, "scenes"), "--output", model, ...config);
  const { file, scenes } = page_of("bare", [bare], [...config, "--set", `model=${model}`]);
  await on_page(
    async () => {
      assert(await page.locator("#layer-truth").isDisabled());
      assert(await page.locator("#layer-colour").isDisabled());
      assert(await page.locator("#layer-edges").isDisabled());
      assert.match(await text_of(".scene-facts"), /no ground truth/);
      const [a, b] = scenes[0].edges
        .map((edge, i) => [edge, i])
        .sort(([x, i], [y, j]) => Math.abs(x[3] - 0.5) - Math.abs(y[3] - 0.5) || i - j)[0][0];
      assert.equal((await rows())[0], `${a} – ${b}`);
      await press("v");
      await settled();
    },
    {},
    file,
  );
});
