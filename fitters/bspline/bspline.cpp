// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "bspline.h"

#include "surface_fit.h"

namespace gestalt {

namespace {

std::vector<WeightedPoint> weighted(std::span<const Eigen::Vector3f> points) {
  std::vector<WeightedPoint> result;
  result.reserve(points.size());
  for (const Eigen::Vector3f& p : points) result.push_back({p.cast<double>(), 1});
  return result;
}

std::vector<WeightedPoint> joined(std::span<const WeightedPoint> a, std::span<const WeightedPoint> b) {
  std::vector<WeightedPoint> both(a.begin(), a.end());
  both.insert(both.end(), b.begin(), b.end());
  return both;
}

}  // namespace

const Parameters<Bspline::Params>& Bspline::parameters() {
  using P = Params;
  static const auto parameters =
      Parameters<P>()
          .integer("degree", &P::degree, 1, BsplineBasis::largest_degree, "", "degree of the basis functions")
          .integer("control_points_xi", &P::control_points_xi, 2, 16, "",
                   "control points along the longest axis of a patch, more than the degree")
          .integer("control_points_eta", &P::control_points_eta, 2, 16, "",
                   "control points along the second axis, more than the degree")
          .integer("knot_insertions", &P::knot_insertions, 0, 8, "",
                   "knots to insert in each direction where the error is largest; each adds a control point")
          .integer("iterations", &P::iterations, 1, 100, "", "rounds of closest points and least squares")
          .real("smoothness", &P::smoothness, 1e-6, 1e6, "points",
                "w_s of Eq. 6: a surface is held flat as if so many points lay on its plane")
          .integer("cells", &P::cells, 4, 64, "",
                   "the points of a patch are kept as the means of this many cells in each direction");
  return parameters;
}

Bspline::Bspline(const Params& params) : params_(params) {
  const auto check = [&](const char* name, int count) {
    if (count <= params.degree)
      throw ConfigError(std::string(name) + " = " + std::to_string(count) +
                        " must be larger than degree = " + std::to_string(params.degree));
  };
  check("control_points_xi", params.control_points_xi);
  check("control_points_eta", params.control_points_eta);
  smoothness_ = smoothness_matrix({params.degree,
                                   clamped_knots(params.degree, params.control_points_xi),
                                   clamped_knots(params.degree, params.control_points_eta),
                                   {}});
}

double Bspline::parameter_count() const {
  return 3.0 * (params_.control_points_xi + params_.knot_insertions) *
         (params_.control_points_eta + params_.knot_insertions);
}

std::shared_ptr<const SurfaceModel> Bspline::fit(std::span<const Eigen::Vector3f> points) const {
  const std::vector<WeightedPoint> all = weighted(points);
  return fit_to(all, all);
}

std::shared_ptr<const SurfaceModel> Bspline::fit_merged(const SurfaceModel& a,
                                                        std::span<const Eigen::Vector3f> points_a,
                                                        const SurfaceModel& b,
                                                        std::span<const Eigen::Vector3f> points_b) const {
  const auto* model_a = dynamic_cast<const BsplineModel*>(&a);
  const auto* model_b = dynamic_cast<const BsplineModel*>(&b);
  if (!model_a || !model_b) return Fitter::fit_merged(a, points_a, b, points_b);
  return fit_to(joined(model_a->digest().means, model_b->digest().means),
                joined(model_a->digest().extremes, model_b->digest().extremes));
}

std::string Bspline::refusal(std::span<const Eigen::Vector3f> points) const {
  const std::vector<WeightedPoint> all = weighted(points);
  const auto frame = frame_of(all, all);
  const auto* reason = std::get_if<const char*>(&frame);
  return reason ? *reason : "";
}

std::variant<PrincipalFrame, const char*> Bspline::frame_of(std::span<const WeightedPoint> points,
                                                            std::span<const WeightedPoint> bounds) const {
  auto frame = principal_frame(points, bounds, parameter_count() / 3);
  const auto* found = std::get_if<PrincipalFrame>(&frame);
  if (found && is_folded(points, *found)) return "folded over its principal plane";
  return frame;
}

std::shared_ptr<const SurfaceModel> Bspline::fit_to(std::span<const WeightedPoint> points,
                                                    std::span<const WeightedPoint> bounds) const {
  const auto frame_or_reason = frame_of(points, bounds);
  const auto* frame = std::get_if<PrincipalFrame>(&frame_or_reason);
  if (!frame) return nullptr;
  PatchDigest digest{cell_means(points, *frame, params_.cells), extremes(bounds, *frame)};

  std::vector<Eigen::Vector2d> places;
  for (const WeightedPoint& mean : digest.means)
    places.push_back(frame->parameters(mean.point).cwiseMax(0.0).cwiseMin(1.0));
  BsplineSurface surface = flat_surface(*frame, params_.degree, params_.control_points_xi, params_.control_points_eta);
  if (!fit_surface(surface, digest.means, places, smoothness_, params_.smoothness, params_.iterations)) return nullptr;
  for (int i = 0; i < params_.knot_insertions; ++i) {
    insert_knots(surface, digest.means, places);
    if (!fit_surface(surface, digest.means, places, smoothness_matrix(surface), params_.smoothness, params_.iterations))
      return nullptr;
  }
  return std::make_shared<BsplineModel>(std::move(surface), *frame, std::move(digest));
}

}  // namespace gestalt
