// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/experiment/peer.h"

#include <algorithm>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/for_all.h"
#include "gestalt/evaluation/score/scene_sets.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

constexpr const char* label_image = "labels.png";

std::vector<ImageScore> score(const Peer& peer, const std::vector<fs::path>& scenes, const ReadOptions& read) {
  std::vector<ImageScore> scores(scenes.size());
  for_all(scenes.size(), [&](std::size_t i) {
    const cv::Mat_<std::uint16_t> truth = read_ground_truth(scenes[i], read);
    scores[i] = score_image(truth, read_prediction(peer.folder, scene_name(scenes[i]), label_image, truth.size()));
  });
  return scores;
}

}  // namespace

PeerScores score_peer(const Peer& peer, const Protocol& protocol) {
  std::error_code error;
  if (!fs::is_directory(peer.folder, error))
    throw InputError(peer.folder.string() + ": is not a folder; give the folder of the label images of " + peer.name);
  const std::vector<fs::path>& scenes = protocol.test.empty() ? protocol.learn : protocol.test;
  PeerScores result{peer.name, category_scores(score(peer, scenes, protocol.read), scene_categories(scenes)), {}};
  for (const FurtherSet& set : protocol.further) {
    const bool has_any = std::any_of(set.scenes.begin(), set.scenes.end(), [&](const fs::path& scene) {
      return has_prediction(peer.folder, scene_name(scene), label_image);
    });
    if (!has_any) continue;
    CategoryScore row =
        category_scores(score(peer, set.scenes, protocol.read), std::vector<std::string>(set.scenes.size())).back();
    row.category = set.name;
    result.further.push_back(std::move(row));
  }
  return result;
}

}  // namespace gestalt
