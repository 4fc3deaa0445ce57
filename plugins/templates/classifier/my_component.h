#pragma once

#include <gestalt/core/plugin/classifier.h>
#include <gestalt/core/plugin/parameters.h>

/// p(same) by how far a row of values lies along the line from the mean of the negative pairs to that of the positive
/// ones: 1/2 in the middle between them.
class MyComponent final : public gestalt::Classifier {
 public:
  struct Params {
    double sharpness = 4;  ///< log odds at the mean of the positive pairs
  };
  static const gestalt::Parameters<Params>& parameters();

  explicit MyComponent(const Params& params) : params_(params) {}
  std::unique_ptr<gestalt::Predictor> train(const gestalt::Samples& samples) const override;
  std::unique_ptr<gestalt::Predictor> restore(const nlohmann::json& state, std::size_t columns) const override;

 private:
  Params params_;
};
