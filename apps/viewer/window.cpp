// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "window.h"

#include <pcl/common/centroid.h>
#include <pcl/visualization/pcl_visualizer.h>

#include "viewed_result.h"

namespace gestalt::view {

namespace {

using pcl::visualization::KeyboardEvent;
using pcl::visualization::PCLVisualizer;

constexpr const char* keys =
    "m surfaces   i image   Page Down, Page Up scenes   r back to the start   h all keys   q end";

class Window {
 public:
  explicit Window(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {
    viewer_.setBackgroundColor(0.07, 0.08, 0.09);
    viewer_.setShowFPS(false);
    viewer_.setSize(1280, 960);
    viewer_.registerKeyboardCallback([this](const KeyboardEvent& event) { on_key(event); });
    open(0);
  }

  void run() { viewer_.spin(); }

  void save(const std::filesystem::path& picture) {
    viewer_.spinOnce();
    viewer_.saveScreenshot(picture.string());
  }

 private:
  void on_key(const KeyboardEvent& event) {
    if (!event.keyDown()) return;
    const std::string& key = event.getKeySym();
    if (key == "m") {
      surfaces_ = !surfaces_;
      draw();
    } else if (key == "i") {
      image_ = !image_;
      draw();
    } else if (key == "Next") {
      open(at_ + 1);
    } else if (key == "Prior") {
      open(at_ + folders_.size() - 1);
    }
  }

  void open(std::size_t number) {
    at_ = number % folders_.size();
    result_ = read_viewed_result(folders_[at_]);
    viewer_.setWindowName("gestalt: " + result_.name);
    draw();
    look();
  }

  /// From above the camera's place towards what it saw, as the segments of a frame are seen best from near there.
  void look() {
    Eigen::Vector4d centre = Eigen::Vector4d::Zero();
    pcl::compute3DCentroid(*result_.segments, centre);
    const double distance = centre.z();
    viewer_.setCameraPosition(0, -0.35 * distance, -0.3 * distance, centre.x(), centre.y(), distance, 0, -1, 0);
    viewer_.setCameraClipDistances(0.01, 20 * distance);
  }

  void draw() {
    viewer_.removeAllPointClouds();
    viewer_.removeAllShapes();
    // Points that lie on surfaces would flicker through them.
    const bool surfaces = surfaces_ && !result_.surfaces.polygons.empty();
    const bool image = image_ && !surfaces && !result_.colours->empty();
    viewer_.addPointCloud<pcl::PointXYZRGB>(surfaces ? result_.background
                                            : image  ? result_.colours
                                                     : result_.segments,
                                            "points");
    viewer_.setPointCloudRenderingProperties(pcl::visualization::PCL_VISUALIZER_POINT_SIZE, 3, "points");
    if (surfaces) viewer_.addPolygonMesh(result_.surfaces, "surfaces");
    const std::string title =
        result_.name + "  (" + std::to_string(at_ + 1) + " of " + std::to_string(folders_.size()) + ")";
    viewer_.addText(title, 12, 36, 18, 1, 1, 1, "title");
    viewer_.addText(keys, 12, 10, 14, 1, 1, 1, "keys");
  }

  std::vector<std::filesystem::path> folders_;
  std::size_t at_ = 0;
  ViewedResult result_;
  bool surfaces_ = false, image_ = false;
  PCLVisualizer viewer_{"gestalt"};
};

}  // namespace

void show(const std::vector<std::filesystem::path>& folders) { Window(folders).run(); }

void take_picture(const std::filesystem::path& folder, const std::filesystem::path& picture) {
  Window({folder}).save(picture);
}

}  // namespace gestalt::view
