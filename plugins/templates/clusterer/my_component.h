#pragma once

#include <gestalt/core/plugin/clusterer.h>
#include <gestalt/core/plugin/parameters.h>

/// Connected pixels whose normals are like that of the first of them, and between which depth does not jump.
class MyComponent final : public gestalt::Clusterer {
 public:
  struct Params {
    int radius = 4;      ///< a normal is taken from the pixels at this distance
    double angle = 0.5;  ///< largest angle of a normal to that of the patch's first pixel
    double jump = 0.01;  ///< neighbours whose depths differ by more than this share of their depth are not connected
  };
  static const gestalt::Parameters<Params>& parameters();

  explicit MyComponent(const Params& params) : params_(params) {}
  gestalt::PatchMap cluster(const gestalt::Frame& frame) const override;

 private:
  Params params_;
};
