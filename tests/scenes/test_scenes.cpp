// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/tests/scenes/test_scenes.h"

#include <nlohmann/json.hpp>

#include "gestalt/core/pipeline/surface_modelling.h"

namespace gestalt::test {

namespace {

class ExactPlane final : public SurfaceModel {
 public:
  ExactPlane(const Eigen::Vector3f& point, Eigen::Vector3f normal) {
    normal.normalize();
    if (normal.dot(point) > 0) normal = -normal;
    plane_ = {normal, point};
  }
  std::string type() const override { return "plane"; }
  Foot foot(const Eigen::Vector3f& p) const override { return {plane_.projection(p), plane_.normal()}; }
  nlohmann::json to_json() const override { return {{"type", "plane"}}; }

 private:
  Eigen::Hyperplane<float, 3> plane_;
};

}  // namespace

Camera kinect(int width, int height) {
  const double scale = width / 640.0;
  return {width, height, 525 * scale, 525 * scale, (width - 1) / 2.0, (height - 1) / 2.0};
}

std::shared_ptr<const SurfaceModel> exact_plane(const Eigen::Vector3f& point, Eigen::Vector3f normal) {
  return std::make_shared<ExactPlane>(point, std::move(normal));
}

KnownScene render(const std::vector<PlanarPatch>& patches, const Camera& camera) {
  cv::Mat_<float> depth(camera.height, camera.width, 0.f);
  cv::Mat colour(depth.size(), CV_8UC3, cv::Scalar::all(0));
  cv::Mat_<int> source(depth.size(), 0);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const PlanarPatch& patch = patches[i];
    const cv::Rect area = patch.pixels & cv::Rect(0, 0, camera.width, camera.height);
    for (int v = area.y; v < area.y + area.height; ++v)
      for (int u = area.x; u < area.x + area.width; ++u) {
        const Eigen::Vector3f ray(float((u - camera.cx) / camera.fx), float((v - camera.cy) / camera.fy), 1);
        const float z = patch.normal.dot(patch.point) / patch.normal.dot(ray);
        if (!(z > 0)) continue;
        depth(v, u) = z;
        colour.at<cv::Vec3b>(v, u) = patch.colour;
        source(v, u) = int(i) + 1;
      }
  }

  KnownScene scene{make_frame("known", colour, depth, camera), {}, {}};
  scene.patches.labels = cv::Mat_<int>(depth.size(), 0);
  scene.patches.normals = cv::Mat_<cv::Vec3f>(depth.size(), cv::Vec3f());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    Surface surface{{}, exact_plane(patches[i].point, patches[i].normal)};
    const Eigen::Vector3f n = surface.model->foot(patches[i].point).normal;
    for (int pixel = 0; pixel < int(source.total()); ++pixel) {
      if (source(pixel) != int(i) + 1) continue;
      surface.pixels.push_back(pixel);
      scene.patches.labels(pixel) = scene.patches.count + 1;
      scene.patches.normals(pixel) = {n.x(), n.y(), n.z()};
    }
    if (surface.pixels.empty()) continue;
    ++scene.patches.count;
    scene.surfaces.surfaces.push_back(std::move(surface));
  }
  scene.surfaces.labels = scene.patches.labels.clone();
  scene.surfaces.adjacencies = find_adjacencies(scene.frame, scene.surfaces.labels, {});
  return scene;
}

KnownScene moved(const KnownScene& scene, const Eigen::Isometry3f& motion) {
  KnownScene result = scene;
  result.frame.points = scene.frame.points.clone();
  result.patches.normals = scene.patches.normals.clone();
  for (Surface& surface : result.surfaces.surfaces) {
    const SurfaceModel::Foot foot = surface.model->foot(scene.frame.point(surface.pixels.front()));
    surface.model = exact_plane(motion * foot.point, motion.linear() * foot.normal);
    for (const int pixel : surface.pixels) {
      cv::Vec3f& point = result.frame.points.ptr<cv::Vec3f>()[pixel];
      cv::Vec3f& normal = result.patches.normals.ptr<cv::Vec3f>()[pixel];
      const Eigen::Vector3f p = motion * scene.frame.point(pixel);
      const Eigen::Vector3f n = motion.linear() * Eigen::Vector3f(normal[0], normal[1], normal[2]);
      point = {p.x(), p.y(), p.z()};
      normal = {n.x(), n.y(), n.z()};
    }
  }
  return result;
}

Eigen::Isometry3f some_motion() {
  return Eigen::Translation3f(0.03f, -0.02f, 0.01f) * Eigen::AngleAxisf(0.3f, Eigen::Vector3f(1, 2, -1).normalized());
}

KnownScene ridge(bool convex) {
  const float side = convex ? 1.f : -1.f;
  return render({{{220, 140, 100, 200}, {0, 0, 1}, {-side, 0, -1}, {40, 40, 200}},
                 {{320, 140, 100, 200}, {0, 0, 1}, {side, 0, -1}, {200, 40, 40}}});
}

KnownScene rectangle_before_wall() {
  return render({{{100, 100, 440, 280}, {0, 0, 1.5f}, {0, 0, -1}, {90, 90, 90}},
                 {{260, 180, 120, 120}, {0, 0, 1}, {0, 0, -1}, {30, 160, 220}}});
}

}  // namespace gestalt::test
