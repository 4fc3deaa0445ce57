// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "relative_size.h"

#include <algorithm>

namespace gestalt {

namespace {

class RelativeSizeMeasure final : public Measure {
 public:
  explicit RelativeSizeMeasure(const SurfaceSet& surfaces) : surfaces_(surfaces) {}
  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    const auto [smaller, larger] = std::minmax({double(surfaces_.surfaces[std::size_t(pair.a)].pixels.size()),
                                                double(surfaces_.surfaces[std::size_t(pair.b)].pixels.size())});
    values[0] = smaller / larger;
  }

 private:
  const SurfaceSet& surfaces_;
};

}  // namespace

const Parameters<RelativeSize::Params>& RelativeSize::parameters() {
  static const Parameters<Params> none;
  return none;
}

const std::vector<RelationValue>& RelativeSize::values() const {
  static const std::vector<RelationValue> values{
      {"r_rs", 0, 1, "pixel count of the smaller patch over that of the larger, 1 for equal sizes"}};
  return values;
}

std::unique_ptr<Measure> RelativeSize::bind(const Scene& scene) const {
  return std::make_unique<RelativeSizeMeasure>(scene.surfaces());
}

}  // namespace gestalt
