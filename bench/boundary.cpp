// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// What it costs that components are plugins: whole frames of the default config with its plugins, and with the same
// classes linked into this program, in turn frame by frame. One thread, as the boundary is crossed in all of them
// alike.

#include <iostream>

#include "border_colour.h"
#include "border_curvature.h"
#include "border_depth.h"
#include "centre_curvature.h"
#include "colour_histogram.h"
#include "common_height.h"
#include "common_surface.h"
#include "configs.h"
#include "fourier.h"
#include "frames.h"
#include "gabor.h"
#include "gap_occlusion.h"
#include "gestalt/core/plugin/plugin.h"
#include "hull_view.h"
#include "joint_extent.h"
#include "mean_normals.h"
#include "minimum_distance.h"
#include "multicut.h"
#include "normals.h"
#include "options.h"
#include "plane.h"
#include "random_forest.h"
#include "relative_size.h"
#include "texture_quantity.h"
#include "times.h"

namespace {

using namespace gestalt;
using namespace gestalt::bench;

template <class Component>
void add(Registry& registry, const char* name) {
  using Kind = KindOf<Component>;
  registry.add<Kind>({"", name, "", "", "linked"}, *static_cast<const Factory<Kind>*>(factory_of<Component>()));
}

/// What the default config names.
Registry linked() {
  Registry registry(std::vector<std::filesystem::path>{});
  add<Normals>(registry, "normals");
  add<Plane>(registry, "plane");
  add<ColourHistogram>(registry, "colour_histogram");
  add<RelativeSize>(registry, "relative_size");
  add<TextureQuantity>(registry, "texture_quantity");
  add<Gabor>(registry, "gabor");
  add<Fourier>(registry, "fourier");
  add<BorderColour>(registry, "border_colour");
  add<BorderCurvature>(registry, "border_curvature");
  add<BorderDepth>(registry, "border_depth");
  add<CommonHeight>(registry, "common_height");
  add<MinimumDistance>(registry, "minimum_distance");
  add<MeanNormals>(registry, "mean_normals");
  add<JointExtent>(registry, "joint_extent");
  add<GapOcclusion>(registry, "gap_occlusion");
  add<HullView>(registry, "hull_view");
  add<CentreCurvature>(registry, "centre_curvature");
  add<CommonSurface>(registry, "common_surface");
  add<RandomForest>(registry, "random_forest");
  add<Multicut>(registry, "multicut");
  return registry;
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Times frames with plugins and with the same components linked"};
  Options options;
  options.repeats = 10;
  add_scenes(app, options);
  add_measuring(app, options);
  CLI11_PARSE(app, argc, argv);

  const ThreadLimit limit(1);
  const Segmenter plugins(default_config());
  const Segmenter direct(LoadedConfig(ConfigTree(default_config(), {}), linked()));
  const std::vector<Frame> frames = Frames(options.scenes, options.synthetic).all();
  std::vector<double> with_plugins, with_links, ratios;
  for (int repeat = 0; repeat <= options.repeats; ++repeat)
    for (const Frame& frame : frames) {
      const double crossed = plugins.segment(frame).times.total(), called = direct.segment(frame).times.total();
      if (repeat == 0) continue;  // to warm up
      with_plugins.push_back(crossed);
      with_links.push_back(called);
      ratios.push_back(crossed / called);
    }
  const double share = 100 * (median(ratios) - 1);
  write_report(options, {{"frames", frames.size()},
                         {"repeats", options.repeats},
                         {"milliseconds", {{"plugins", median(with_plugins)}, {"linked", median(with_links)}}},
                         {"boundary_percent", share}});
  std::cout << frames.size() << " frames, " << options.repeats << " runs each: " << median(with_plugins)
            << " ms with plugins, " << median(with_links) << " ms linked, " << share << " % more with plugins\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bench_boundary: error: " << error.what() << '\n';
  return 1;
}
