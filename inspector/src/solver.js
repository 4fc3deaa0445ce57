// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The slider of the solver's parameter. The cuts were computed by the solver itself when the page was written; here one
// is only chosen.

import { element } from "./dom.js";
import { against_truth } from "./scene.js";
import { number_text } from "./relations.js";

const many = (count, one, more = `${one}s`) => `${count} ${count === 1 ? one : more}`;

/// change(index of the cut in scene.cuts)
export const make_solver = (change) => {
  let scene = null,
    sweep = null;
  const name = element("span", { class: "dim" });
  const which = element("select", { "aria-label": "Parameter of the solver", onchange: () => take(which.value) });
  const value = element("output", { class: "value" });
  const slider = element("input", {
    type: "range",
    min: 0,
    step: 1,
    "aria-label": "Value of the parameter",
    oninput: () => moved(),
  });
  const bands = element("div", { class: "bands", "aria-hidden": "true" });
  const outcome = element("div", { class: "outcome", "aria-live": "polite" });
  const reset = element("button", { type: "button", class: "small", onclick: () => to_current() }, "Reset");
  const controls = element("div", {}, element("div", { class: "solver-head" }, which, value, reset), slider, bands);
  const root = element(
    "section",
    { class: "solver", "aria-label": "Solver" },
    element("h2", {}, "Solver ", name),
    controls,
    outcome,
  );

  const moved = () => {
    const index = sweep ? Number(slider.value) : 0,
      cut = sweep ? sweep.cuts[index] : 0;
    if (sweep) {
      const text = `${number_text(sweep.values[index])}${sweep.unit ? ` ${sweep.unit}` : ""}`;
      value.textContent = text;
      slider.setAttribute("aria-valuetext", text);
      reset.disabled = sweep.values[index] === sweep.current;
    }
    const { list, objects } = scene.cuts[cut];
    const against = scene.truth && against_truth(scene, scene.cuts[cut]);
    outcome.replaceChildren(
      element(
        "span",
        {},
        element("b", {}, String(objects)),
        objects === 1 ? " object" : " objects",
        `, ${list.length - objects} of background`,
      ),
      ...(against
        ? [
            element(
              "span",
              { class: against.joined + against.parted ? "bad" : "good" },
              against.joined + against.parted
                ? `${many(against.joined, "edge")} joined, ${against.parted} cut against ground truth`
                : "no edge joined or cut against ground truth",
            ),
          ]
        : []),
    );
    change(cut);
  };
  const to_current = () => {
    slider.value = sweep.values.indexOf(sweep.current);
    moved();
  };
  const take = (parameter) => {
    sweep = scene.solver.sweeps.find((one) => one.name === parameter) ?? null;
    controls.hidden = !sweep;
    if (!sweep) return moved();
    which.title = sweep.text;
    slider.max = sweep.values.length - 1;
    // Where neighbouring values give the same cut, one band; that of the config is marked.
    const widths = [];
    sweep.cuts.forEach((cut, i) =>
      i && cut === sweep.cuts[i - 1] ? ++widths.at(-1).steps : widths.push({ cut, steps: 1 }),
    );
    bands.replaceChildren(
      ...widths.map(({ cut, steps }) =>
        element("span", { class: cut === 0 ? "own" : "", style: { "flex-grow": steps } }),
      ),
    );
    bands.title = `${many(widths.length, "stretch", "stretches")} of values with one cut each`;
    to_current();
  };

  return {
    root,
    open: (opened) => {
      scene = opened;
      name.textContent = scene.solver.plugin;
      const sweeps = scene.solver.sweeps;
      which.replaceChildren(...sweeps.map((one) => element("option", { value: one.name }, one.name)));
      // The last is the one that decides what is joined at the end.
      const first = sweeps.at(-1)?.name;
      if (first) which.value = first;
      take(first);
    },
    /// To the next value, up or down, where the cut changes.
    step: (direction) => {
      if (!sweep) return;
      let index = Number(slider.value);
      const from = sweep.cuts[index];
      while (sweep.cuts[index + direction] !== undefined) {
        index += direction;
        if (sweep.cuts[index] !== from) break;
      }
      slider.value = index;
      moved();
    },
    reset: () => sweep && to_current(),
  };
};
