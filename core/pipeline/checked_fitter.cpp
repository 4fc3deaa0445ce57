// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "checked_fitter.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gestalt/core/plugin/component_call.h"

namespace gestalt {

namespace {

[[noreturn]] void broken(ComponentName fitter, const std::string& what) {
  throw PluginError(std::string(fitter) + " returned " + what +
                    "; report this to its author, or remove it from the config");
}

bool all_finite(const nlohmann::json& json) {  // NOLINT(misc-no-recursion): as deep as a fitter has made it
  if (json.is_structured()) return std::all_of(json.begin(), json.end(), all_finite);
  return !json.is_number_float() || std::isfinite(json.get<double>());
}

/// A fitter's surface. Points are asked for by the million: they do not count as calls of the component.
class CheckedSurface final : public SurfaceModel {
 public:
  CheckedSurface(ComponentName fitter, std::shared_ptr<const SurfaceModel> surface)
      : fitter_(fitter), surface_(std::move(surface)) {}
  ~CheckedSurface() override {
    const RunningComponent running(fitter_);
    surface_.reset();
  }

  const SurfaceModel& surface() const { return *surface_; }

  std::string type() const override { return surface_->type(); }

  Foot foot(const Eigen::Vector3f& p) const override {
    const Foot foot = blame_component(fitter_, [&] { return surface_->foot(p); });
    if (!(foot.point.allFinite() && foot.normal.allFinite()) && p.allFinite())
      broken(fitter_, "a surface whose closest point, or normal there, is not finite");
    return foot;
  }

  float squared_distance(const Eigen::Vector3f& p) const override {
    const float squared = blame_component(fitter_, [&] { return surface_->squared_distance(p); });
    if (!(squared >= 0 && std::isfinite(squared)) && p.allFinite())
      broken(fitter_, "a surface whose distance to a point is negative or not finite");
    return squared;
  }

  std::optional<Eigen::Vector2d> parameters(const Eigen::Vector3f& p) const override {
    const auto place = blame_component(fitter_, [&] { return surface_->parameters(p); });
    if (place && !place->allFinite() && p.allFinite()) broken(fitter_, "parameters of a point that are not finite");
    return place;
  }

  nlohmann::json to_json() const override {
    nlohmann::json json = call_component(fitter_, [&] { return surface_->to_json(); });
    if (!all_finite(json)) broken(fitter_, "a surface with a parameter that is not finite");
    return json;
  }

 private:
  ComponentName fitter_;
  std::shared_ptr<const SurfaceModel> surface_;
};

class CheckedFitter final : public Fitter {
 public:
  CheckedFitter(std::shared_ptr<const Fitter> fitter, ComponentName name) : name_(name), fitter_(std::move(fitter)) {}

  double parameter_count() const override {
    const double count = call_component(name_, [&] { return fitter_->parameter_count(); });
    if (!(count >= 0 && std::isfinite(count))) broken(name_, "a number of parameters that is negative or not finite");
    return count;
  }

  std::shared_ptr<const SurfaceModel> fit(std::span<const Eigen::Vector3f> points) const override {
    return checked(call_component(name_, [&] { return fitter_->fit(points); }));
  }

  std::shared_ptr<const SurfaceModel> fit_merged(const SurfaceModel& a, std::span<const Eigen::Vector3f> points_a,
                                                 const SurfaceModel& b,
                                                 std::span<const Eigen::Vector3f> points_b) const override {
    return checked(call_component(name_, [&] { return fitter_->fit_merged(own(a), points_a, own(b), points_b); }));
  }

  std::string refusal(std::span<const Eigen::Vector3f> points) const override {
    return call_component(name_, [&] { return fitter_->refusal(points); });
  }

 private:
  std::shared_ptr<const SurfaceModel> checked(std::shared_ptr<const SurfaceModel> surface) const {
    return surface ? std::make_shared<CheckedSurface>(name_, std::move(surface)) : nullptr;
  }

  static const SurfaceModel& own(const SurfaceModel& surface) {
    const auto* checked = dynamic_cast<const CheckedSurface*>(&surface);
    return checked ? checked->surface() : surface;
  }

  ComponentName name_;
  std::shared_ptr<const Fitter> fitter_;
};

}  // namespace

std::shared_ptr<const Fitter> checked_fitter(std::shared_ptr<const Fitter> fitter, const std::string& plugin) {
  return std::make_shared<CheckedFitter>(std::move(fitter), component_name("fitter", plugin));
}

}  // namespace gestalt
