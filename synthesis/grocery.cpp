// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "grocery.h"

#include <opencv2/imgproc.hpp>

#include "shapes.h"

namespace gestalt::synthesis {

namespace {

/// Packing tape along the face's longer middle, and a label.
void tape_and_label(cv::Mat_<cv::Vec3b>& face, Random& random) {
  const auto across = [&](int length, double share) { return std::max(1, int(share * length)); };
  if (random.chance(0.7)) {
    const bool lying = face.cols >= face.rows;
    const cv::Rect tape = lying ? cv::Rect(0, across(face.rows, 0.4), face.cols, across(face.rows, 0.2))
                                : cv::Rect(across(face.cols, 0.4), 0, across(face.cols, 0.2), face.rows);
    cv::Mat strip = face(tape & cv::Rect({0, 0}, face.size()));
    strip.convertTo(strip, -1, 1, random.uniform(8, 30));
  }
  if (random.chance(0.5)) {
    const cv::Rect label(across(face.cols, random.uniform(0.05, 0.5)), across(face.rows, random.uniform(0.05, 0.5)),
                         across(face.cols, 0.4), across(face.rows, 0.4));
    cv::rectangle(face, label, {225, 228, 230}, cv::FILLED);
    for (int y = label.y + 3; y + 2 < label.y + label.height; y += 5)
      cv::line(face, {label.x + 2, y}, {label.x + across(label.width, random.uniform(0.4, 0.9)), y}, {60, 60, 60});
  }
}

Texture face_of(double width, double height, bool bare, const Palette& palette, Random& random) {
  Texture face = bare ? glaze(width, height, palette, random) : print(width, height, palette, random);
  if (bare) tape_and_label(face.image, random);
  const double shade = random.uniform(0.6, 1.15);
  const cv::Scalar edge = shade * cv::Scalar(palette.ground);
  cv::rectangle(face.image, cv::Rect({0, 0}, face.image.size()), edge, 1);
  return face;
}

Body tub(const Palette& palette, Random& random) {
  const double bottom = random.uniform(0.035, 0.06), top = bottom * random.uniform(1.05, 1.35);
  const double height = random.uniform(0.05, 0.13);
  return made_of(cone(bottom, top, height),
                 {print(turn * top, height, palette, random), print(turn * top, top, palette, random)});
}

/// Flat bottles of sauce and soap.
Body flask(const Palette& palette, Random& random) {
  const double height = random.uniform(0.1, 0.17), width = random.uniform(0.025, 0.045);
  Mesh mesh = superellipsoid({width, width * random.uniform(0.5, 0.9), height / 2}, random.uniform(0.2, 0.5),
                             random.uniform(0.4, 1));
  const double cap = random.uniform(0.01, 0.018);
  Eigen::Isometry3d above = Eigen::Isometry3d::Identity();
  above.translation().z() = 0.99 * height;
  join(mesh, cone(cap, cap * random.uniform(0.4, 1), random.uniform(0.02, 0.05)), above, 1);
  return made_of(std::move(mesh), {print(turn * width, height, palette, random), plain(palette.accent)});
}

Body lying_bag(const Palette& palette, Random& random) {
  const Eigen::Vector3d size{random.uniform(0.1, 0.2), random.uniform(0.13, 0.26), random.uniform(0.025, 0.07)};
  return made_of(pillow(size), {print(size.x(), size.y(), palette, random), plain(palette.band)});
}

Body standing_bag(const Palette& palette, Random& random) {
  const Eigen::Vector3d size{random.uniform(0.09, 0.17), random.uniform(0.05, 0.09), random.uniform(0.13, 0.24)};
  return made_of(pouch(size), {print(size.x(), size.z(), palette, random), print(size.x(), size.z(), palette, random),
                               plain(palette.ground)});
}

}  // namespace

Body package(const Eigen::Vector3d& size, bool bare, const Palette& palette, Random& random) {
  const Eigen::Vector2d faces[] = {{size.x(), size.z()}, {size.y(), size.z()}, {size.x(), size.y()}};
  std::vector<Texture> parts;
  for (const Eigen::Vector2d& face : faces)
    for (int side = 0; side < 2; ++side) parts.push_back(face_of(face.x(), face.y(), bare, palette, random));
  return made_of(box(size), std::move(parts));
}

namespace {

Body dull_grocery(const Palette& palette, Random& random) {
  const double kind = random.uniform();
  if (kind < 0.36) return random_body(Kind::carton, palette, random);
  if (kind < 0.58) return random_body(Kind::can, palette, random);
  if (kind < 0.7) return random_body(Kind::bottle, palette, random);
  if (kind < 0.78) return flask(palette, random);
  if (kind < 0.84) return tub(palette, random);
  if (kind < 0.92) return standing_bag(palette, random);
  return lying_bag(palette, random);
}

}  // namespace

Body random_grocery(const Palette& palette, Random& random) {
  Body body = dull_grocery(palette, random);
  body.paint.gloss = random.chance(0.5) ? float(random.uniform(0, 0.7)) : 0.f;
  return body;
}

}  // namespace gestalt::synthesis
