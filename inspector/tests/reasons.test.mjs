// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The words for relation values.

import assert from "node:assert/strict";
import { test } from "node:test";
import { phrase, reasons } from "../src/reasons.js";

test("values have words, and relations that are not known their name", () => {
  assert.equal(phrase("r_co", 0.9, ""), "similar colours");
  assert.equal(phrase("r_co", 0.1, ""), "different colours");
  assert.equal(phrase("r_cu3", 0.5, ""), "convex border of 29°");
  assert.equal(phrase("r_cu3", -0.5, ""), "concave border of 29°");
  assert.equal(phrase("r_cu3", 0, ""), "flat border");
  assert.equal(phrase("r_md", 0.0321, ""), "32 mm apart");
  assert.equal(phrase("r_di2", 0.0042, ""), "step in depth of 4.2 mm at the border");
  assert.equal(phrase("r_nm", Math.PI / 2, ""), "perpendicular faces");
  assert.equal(phrase("r_own", 3, "own 3"), "own 3");
  assert.equal(phrase("toString", 3, "own 3"), "own 3");
});

test("reasons give the strongest contributions for the decision, then those against it", () => {
  const values = ["r_co", "r_th", "r_md", "r_rs", "r_own"].map((name) => ({ name, relation: "own_gap" }));
  const scene = { levels: [{ values }] };
  const edge = { level: 0, p: 0.9, values: [0.9, 0, 0.032, 1, 7], contributions: [0.214, 0.3, -0.05, 0.01, 0.1] };
  assert.equal(
    reasons(scene, edge, String),
    "One object: tops at one height +0.30, similar colours +0.21, own gap 7 +0.10; against it: 32 mm apart −0.05",
  );
  edge.p = 0.1;
  assert.match(reasons(scene, edge, String), /^Two objects: 32 mm apart −0.05; against it: tops/);
  edge.contributions = [0, 0, 0, 0, 0];
  assert.equal(reasons(scene, edge, String), "Two objects: no value decides alone");
});

test("every value of the default and the paper's relations has words", () => {
  for (const name of "r_co r_rs r_tr r_ga r_fo r_co3 r_cu3 r_cv3 r_di2 r_vd2 r_th r_md r_nm r_nv r_ac r_dn r_ex r_go r_gl r_hb r_ho r_hn r_hh r_cc r_cd r_sp r_cs r_oc r_ls r_as r_lg".split(" "))
    for (const value of [-1, 0, 0.01, 0.5, 1, 3]) {
      const text = phrase(name, value, undefined);
      assert(typeof text === "string" && text.length > 4 && !/NaN|undefined/.test(text), `${name} ${value}: ${text}`);
    }
});
