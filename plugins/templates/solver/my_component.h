#pragma once

#include <gestalt/core/plugin/parameters.h>
#include <gestalt/core/plugin/solver.h>

/// Joins patches from the most probable edge down, unless the two groups have an edge that speaks surely against it.
class MyComponent final : public gestalt::Solver {
 public:
  struct Params {
    double join = 0.5;  ///< an edge of less probability does not join
    double veto = 0.1;  ///< an edge of less probability keeps the groups of its patches apart
  };
  static const gestalt::Parameters<Params>& parameters();

  explicit MyComponent(const Params& params) : params_(params) {}
  std::vector<int> solve(const gestalt::Graph& graph) const override;

 private:
  Params params_;
};
