// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "gestalt/core/objects/object_description.h"
#include "gestalt/core/scene/frame.h"

namespace gestalt {

/// What is seen. The first six have a table alone and are named as the categories of the paper's data set; the others
/// stand in a room that is measured too, before cameras from 0.3 to 2.2 m away.
enum class Category {
  boxes,              ///< 1-4 boxes standing apart
  stacked_boxes,      ///< 2-5 boxes, at least two of them on top of each other
  occluded_objects,   ///< a long object cut into two visible parts by one in front of it, and up to 2 more
  cylindric_objects,  ///< 2-6 cans, mugs, bowls and bottles
  mixed_objects,      ///< 5-9 things of every kind, some stacked, some side by side
  complex_scene,      ///< 15-20 things in a heap
  packages,           ///< cartons and parcels flush with each other in rows, blocks and stacks, others beside
  groceries,          ///< 5-18 boxes, cans, bottles and bags, in heaps, rows and stacks
  bin,                ///< 2-14 things in a tote or cardboard box, which is background
  thin_and_small,     ///< 4-14 flat, thin and small things
  shelf,              ///< 3-14 things in rows on a board between walls
};

/// In the order of the enumeration.
const std::vector<std::string>& category_names();

const std::string& name_of(Category category);

/// Throws ConfigError with the nearest name for an unknown one.
Category category_of(std::string_view name);

/// How depth is measured.
enum class SensorModel {
  structured_light,  ///< the first Kinect
  active_stereo,     ///< RealSense D415, D435
  time_of_flight,    ///< Azure Kinect, RealSense L515
};

/// In the order of the enumeration.
const std::vector<std::string>& sensor_model_names();

/// Throws ConfigError with the nearest name for an unknown one.
SensorModel sensor_model_of(std::string_view name);

/// A thing as it was laid out.
struct SyntheticObject {
  ShapeKind shape = ShapeKind::other;  ///< box, cylinder or other
  Eigen::Vector3d size =
      Eigen::Vector3d::Zero();  ///< metres, along the axes of its own frame, z up as it stands by itself
  Eigen::Isometry3d pose =
      Eigen::Isometry3d::Identity();  ///< from its frame, whose origin is its middle, to the camera's
};

/// A sensor's view of things with its ground truth.
struct SyntheticScene {
  Frame frame;                           ///< depth is whole millimetres; frame.name is <category>_<seed>_<index>,
                                         ///< the sensor's name before the seed unless it is structured_light
  cv::Mat_<std::uint16_t> ground_truth;  ///< 0 = no depth; 1-9 = disjoint parts of the background; 20-29 = disjoint
                                         ///< visible parts of the first object, largest first, 30-39 of the second, ...
  std::string category;
  std::vector<SyntheticObject> objects;                           ///< by number: the first has the labels 20-29
  Eigen::Isometry3d camera_pose = Eigen::Isometry3d::Identity();  ///< from the camera's frame to the world: z is up
};

/// The intrinsics of a Kinect (f = 525 px at a width of 640), scaled to the width.
Camera kinect_camera(int width = 640, int height = 480);

/// Lays out, renders and measures one scene. Equal arguments give equal images. Every object shows at least
/// smallest_object() pixels with depth. Throws InputError for a camera that sees less than 50 x 40 degrees, or in whose
/// view the objects could not be placed.
SyntheticScene synthesize(Category category, std::uint64_t seed, int index, const Camera& camera = kinect_camera(),
                          SensorModel sensor = SensorModel::structured_light);

/// A sequence of a scene: the first frame is that of synthesize(), named 0000. The camera swings by 10 degrees to
/// either side around the vertical axis through the things, once in 60 frames; the highest third of the things (at
/// least one) is lifted by 10 cm, carried to a place 12 cm away and back, once in 40 frames. Things keep their numbers,
/// may hide each other and may leave the image; noise is drawn for each frame. Throws as synthesize() does.
std::vector<SyntheticScene> synthesize_sequence(Category category, std::uint64_t seed, int index, int frames,
                                                const Camera& camera = kinect_camera(),
                                                SensorModel sensor = SensorModel::structured_light);

/// The name of a scene, which is that of its folder.
std::string scene_name(Category category, SensorModel sensor, std::uint64_t seed, int index);

/// Fewest pixels of an object: 300 for a Kinect, in proportion to fx fy otherwise, at least 1.
int smallest_object(const Camera& camera);

/// Writes rgb.png, depth.png (millimetres), label.png and objects.json (docs/synthesis.md) into folder/<name of the
/// scene>/. Throws OutputError.
void write_scene(const SyntheticScene& scene, const std::filesystem::path& folder);

/// Writes every frame of a sequence as write_scene() does, and the camera's poses to folder/poses.txt, as `gestalt
/// stream
/// --poses` reads them. Throws OutputError.
void write_sequence(const std::vector<SyntheticScene>& frames, const std::filesystem::path& folder);

}  // namespace gestalt
