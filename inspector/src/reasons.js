// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Why the classifier takes two patches for one object or not, in words: what each relation value says, with its
// contribution.

const millimetres = (metres) => `${(1000 * metres).toFixed(metres < 0.01 ? 1 : 0)} mm`;
const degrees = (radians) => `${Math.round((180 / Math.PI) * radians)}°`;
const percent = (share) => `${Math.round(100 * share)} %`;
const either = (yes, text, other) => (yes ? text : other);

/// What a value says, by the value's name (docs/method.md).
const phrases = {
  r_co: (x) => either(x >= 0.75, "similar colours", either(x >= 0.45, "partly the same colours", "different colours")),
  r_rs: (x) => either(x >= 0.5, "similar sizes", either(x >= 0.1, "different sizes", "very different sizes")),
  r_tr: (x) => either(x < 0.05, "equally textured", "one more textured than the other"),
  r_ga: (x) => either(x < 0.5, "similar texture", "different texture"),
  r_fo: (x) => either(x >= 0.85, "similar fine texture", "different fine texture"),
  r_co3: (x) => either(x === 0, "no common border", either(x >= 0.97, "same colour along the border", "other colour across the border")),
  r_cu3: (x) => either(Math.abs(x) < 0.1, "flat border", `${either(x > 0, "convex", "concave")} border of ${degrees(Math.abs(x))}`),
  r_cv3: (x) => either(x < 0.05, "even border", "border that bends in and out"),
  r_di2: (x) => either(x < 0.003, "no step in depth at the border", `step in depth of ${millimetres(x)} at the border`),
  r_vd2: (x) => either(x < 1e-5, "even depth along the border", "depth step that varies along the border"),
  r_th: (x) => either(x < 0.01, "tops at one height", `tops ${millimetres(x)} apart in height`),
  r_md: (x) => either(x < 0.002, "touching", `${millimetres(x)} apart`),
  r_nm: (x) => either(x < 0.15, "parallel faces", either(Math.abs(x - Math.PI / 2) < 0.15, "perpendicular faces", `faces at ${degrees(x)}`)),
  r_nv: (x) => either(x < 0.05, "equally curved", "one more curved than the other"),
  r_ac: (x) => either(x < 0.15, "near contours that face alike", `near contours that face ${degrees(x)} apart`),
  r_dn: (x) => either(x < 0.005, "near contours at one level", `near contours ${millimetres(x)} apart in level`),
  r_ex: (x) => `${millimetres(x)} long together`,
  r_go: (x) => either(x === 0, "no gap", either(x > 0, "gap hidden by something nearer", "open gap")),
  r_gl: (x) => either(x < 0.1, "nothing level in the gap", `${percent(x)} of the gap filled by another surface`),
  r_hb: (x) => either(x < 0.05, "nothing seen through the common hull", `background in ${percent(x)} of the common hull`),
  r_ho: (x) => either(x < 0.05, "nothing far behind the common hull", `something far behind in ${percent(x)} of the common hull`),
  r_hn: (x) => either(x < 0.5, "other surfaces in front of the common hull", "other surfaces behind the common hull"),
  r_hh: (x) => either(x < 0.05, "solid common hull", `common hull hollow by ${percent(x)}`),
  r_cc: (x) => either(Math.abs(x) < 0.1, "parallel at their centres", either(x > 0, "facing apart", "facing each other")),
  r_cd: (x) => either(x < 0.8, "side by side", either(x > 2.3, "one behind the other", "obliquely behind each other")),
  r_sp: (x) => either(x < 0.005, "one continues the other's surface", `${millimetres(x)} off each other's surface`),
  r_cs: (x) => either(x >= 2, "no continued outline", either(x < 0.3, "outlines continue each other", "outlines that bend")),
  r_oc: (x) => either(x < 0, "gap between outlines not occluded", "gap between outlines occluded"),
  r_ls: (x) => either(x === 0, "no closed contour", `${percent(x)} of their outlines in a closed contour`),
  r_as: (x) => either(x === 0, "not enclosed by a contour", `${percent(x)} enclosed by a contour`),
  r_lg: (x) => either(x >= 1, "no closed contour", `closed contour with ${percent(x)} gaps`),
};

/// A value in words. other: what to say of a relation that is not known here, one of your own.
export const phrase = (name, value, other) => (Object.hasOwn(phrases, name) ? phrases[name](value) : other);

const least = 0.02; // contribution that is mentioned
const most = 3;

const part = ({ text, contribution }) => `${text} ${contribution > 0 ? "+" : "−"}${Math.abs(contribution).toFixed(2)}`;

/// "One object: similar colours +0.21, tops at one height +0.10; against it: 32 mm apart −0.05".
export const reasons = (scene, edge, number_text) => {
  const { values } = scene.levels[edge.level];
  const all = values
    .map(({ name, relation }, i) => ({
      text: phrase(name, edge.values[i], `${relation.replaceAll("_", " ")} ${number_text(edge.values[i])}`),
      contribution: edge.contributions[i],
    }))
    .filter(({ contribution }) => Math.abs(contribution) >= least)
    .sort((x, y) => Math.abs(y.contribution) - Math.abs(x.contribution));
  const one = edge.p >= 0.5;
  const supporting = all.filter(({ contribution }) => contribution > 0 === one).slice(0, most);
  const opposing = all.filter(({ contribution }) => contribution > 0 !== one).slice(0, most);
  const claim = one ? "One object" : "Two objects";
  const because = supporting.length ? supporting.map(part).join(", ") : "no value decides alone";
  return `${claim}: ${because}${opposing.length ? `; against it: ${opposing.map(part).join(", ")}` : ""}`;
};
