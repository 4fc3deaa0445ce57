#pragma once

#include <gestalt/core/plugin/parameters.h>
#include <gestalt/core/plugin/relation.h>

/// r_my_component: difference of the two patches' mean brightness.
class MyComponent final : public gestalt::Relation {
 public:
  struct Params {
    double contrast = 1;  ///< factor of the difference
  };
  static const gestalt::Parameters<Params>& parameters();

  explicit MyComponent(const Params& params) : params_(params) {}
  const std::vector<gestalt::RelationValue>& values() const override;
  bool needs_colour() const override { return true; }
  std::unique_ptr<gestalt::Measure> bind(const gestalt::Scene& scene) const override;

 private:
  Params params_;
};
