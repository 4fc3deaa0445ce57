// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "object_json.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "gestalt/core/objects/object_description.h"
#include "gestalt/io/scene/labelled_files.h"

namespace gestalt {

namespace {

using Json = nlohmann::json;

/// To 10 micrometres, or as much of a unit vector.
double fine(double value) { return std::round(value * 1e5) / 1e5 + 0.0; }  // no -0

Json vector_json(const Eigen::Vector3d& v) { return {fine(v.x()), fine(v.y()), fine(v.z())}; }

Json box_json(const OrientedBox& box) {
  Json axes = Json::array();
  for (int i = 0; i < 3; ++i) axes.push_back(vector_json(box.axes.col(i)));
  return {{"centre", vector_json(box.centre)}, {"axes", std::move(axes)}, {"size", vector_json(box.size)}};
}

Json support_json(const Support& support) {
  return {{"patch", support.patch},
          {"normal", vector_json(support.normal)},
          {"offset", fine(support.offset)},
          {"bottom", fine(support.bottom)},
          {"top", fine(support.top)}};
}

Json face_json(const Face& face) {
  return {{"patch", face.patch},
          {"centre", vector_json(face.centre)},
          {"normal", vector_json(face.normal)},
          {"area", std::round(face.area * 1e7) / 1e7}};
}

Json colour_json(const Colour& colour) {
  const auto tenths = [](const Eigen::Vector3d& v) {
    return Json{std::round(10 * v.x()) / 10, std::round(10 * v.y()) / 10, std::round(10 * v.z()) / 10};
  };
  return {{"mean", tenths(colour.mean)}, {"deviation", tenths(colour.deviation)}};
}

Json doubts_json(const std::vector<Doubt>& doubts) {
  Json all = Json::array();
  for (const Doubt& doubt : doubts) all.push_back({{"a", doubt.a}, {"b", doubt.b}, {"p", doubt.probability}});
  return all;
}

/// By label, as COCO has them.
std::map<int, Json> masks_of(const Segmentation& segmentation) {
  std::map<int, Json> masks;
  const auto instances = coco_instances(object_labels(segmentation), "");
  for (const auto& annotation : instances.at("annotations"))
    masks[annotation.at("id").get<int>()] = annotation.at("segmentation");
  return masks;
}

}  // namespace

Json objects_json(const SegmentedFrame& found) {
  const std::map<int, Json> masks = masks_of(found.segmentation);
  Json all = Json::array();
  for (const ObjectDescription& object : describe_objects(found)) {
    const auto mask = masks.find(object.label);
    all.push_back({{"label", object.label},
                   {"pixels", object.pixels},
                   {"box", {object.box.x, object.box.y, object.box.width, object.box.height}},
                   {"mask", mask == masks.end() ? Json() : mask->second},
                   {"centroid", vector_json(object.centroid)},
                   {"oriented_box", box_json(object.oriented_box)},
                   {"support", object.support ? support_json(*object.support) : Json()},
                   {"kind", name_of(object.kind)},
                   {"largest_face", object.largest_face ? face_json(*object.largest_face) : Json()},
                   {"colour", object.colour ? colour_json(*object.colour) : Json()},
                   {"confidence", std::round(object.confidence * 1e4) / 1e4},
                   {"doubtful_joins", doubts_json(object.joins)},
                   {"doubtful_cuts", doubts_json(object.cuts)}});
  }
  return all;
}

}  // namespace gestalt
