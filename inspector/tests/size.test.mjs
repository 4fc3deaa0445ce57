// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// How large a page is, how soon it shows something, and how it answers with 500 patches: times are printed, for
// docs/inspector.md.

import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launch, open } from "./browser.mjs";
import { facets, folder, gestalt, page_of } from "./scenes.mjs";

const largest_page = 5e6; // bytes a scene

let browser, usual, large;

before(async () => {
  gestalt("synthesize", "--category", "complex_scene", "--seed", "1", "--output", join(folder, "usual"));
  usual = page_of("usual", [join(folder, "usual", "complex_scene_1_000")]);
  large = page_of("large", [facets(25, 20)]);
  browser = await launch();
  await (await open(browser, usual.file)).context().close(); // the browser's own start is not the page's
});
after(() => browser?.close());

for (const [name, page_made] of [
  ["a usual scene", () => usual],
  ["500 patches", () => large],
])
  test(`${name}: size and time to the first picture`, async (t) => {
    const { file, scenes } = page_made(),
      size = statSync(file).size;
    const times = [];
    for (let i = 0; i < 5; ++i) {
      const page = await open(browser, file);
      times.push(
        await page.evaluate(async () => {
          // When the browser has painted the picture, as it tells itself.
          const picture = await new Promise((done) =>
            new PerformanceObserver((list) => done(list.getEntries()[0].renderTime)).observe({
              type: "element",
              buffered: true,
            }),
          );
          return [picture, performance.getEntriesByName("ready")[0].startTime];
        }),
      );
      await page.context().close();
    }
    const [picture, ready] = [0, 1].map((k) => times.map((pair) => pair[k]).sort((a, b) => a - b)[2]);
    t.diagnostic(
      `${scenes[0].patches.length} patches, ${scenes[0].edges.length} edges, ${(size / 1e6).toFixed(2)} MB, first picture ${picture.toFixed(0)} ms, complete ${ready.toFixed(0)} ms (medians of 5)`,
    );
    assert(size <= largest_page);
  });

/// Milliseconds from an event to the first frame after it that has been painted, the median of several; do(i) sends the
/// event from within the page.
const answer_of = (page, send) =>
  page.evaluate(async (source) => {
    const act = new Function("i", source);
    const times = [];
    for (let i = 0; i < 15; ++i) {
      await new Promise((done) => setTimeout(done, 30));
      const start = performance.now();
      act(i);
      // What follows the second frame's begin has seen the first one painted.
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      times.push(performance.now() - start);
    }
    times.sort((a, b) => a - b);
    return { median: times[7], worst: times.at(-1) };
  }, send);

test("500 patches: every interaction is answered", async (t) => {
  assert(large.scenes[0].patches.length >= 500);
  const page = await open(browser, large.file);
  const interactions = {
    point: `const s = document.querySelector(".stage-2d"), b = s.getBoundingClientRect();
      s.dispatchEvent(new PointerEvent("pointermove", { clientX: b.left + b.width * (0.2 + 0.04 * i), clientY: b.top + b.height * 0.5, bubbles: true }));`,
    slider: `const s = document.querySelector(".solver input[type=range]"); s.value = (i * 4) % 62; s.dispatchEvent(new Event("input"));`,
    "list key": `document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowDown", bubbles: true }));`,
    "layer key": `document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "3", code: "Digit" + (3 + (i % 6)), bubbles: true }));`,
    zoom: `const s = document.querySelector(".stage-2d"), b = s.getBoundingClientRect();
      s.dispatchEvent(new WheelEvent("wheel", { deltaY: i % 2 ? 40 : -40, clientX: b.left + 300, clientY: b.top + 300, bubbles: true, cancelable: true }));`,
    "order of the list": `const s = document.querySelector(".edges-head select"); s.selectedIndex = i % s.options.length; s.dispatchEvent(new Event("change"));`,
  };
  const all_edges = `const s = document.querySelector(".layers select"); s.value = "all"; s.dispatchEvent(new Event("change"));`;
  await answer_of(page, all_edges);
  for (const [name, send] of Object.entries(interactions)) {
    const { median, worst } = await answer_of(page, send);
    t.diagnostic(`${name}: ${median.toFixed(0)} ms, at most ${worst.toFixed(0)} ms`);
  }
  assert.deepEqual(page.problems, []);
  await page.context().close();
});
