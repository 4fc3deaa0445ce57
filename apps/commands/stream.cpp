// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <future>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "gestalt/apps/counted.h"
#include "gestalt/apps/interruption.h"
#include "gestalt/apps/number_in.h"
#include "gestalt/apps/scene_batch.h"
#include "gestalt/apps/scene_segmenter.h"
#include "gestalt/apps/stream/frame_queue.h"
#include "gestalt/apps/stream/frame_source.h"
#include "gestalt/apps/stream/scene_tracker.h"
#include "gestalt/core/base/quantile.h"

namespace gestalt::app::stream_command {

namespace {

struct Options {
  std::filesystem::path source;
  bool follow = false;
  bool drop = false;
  std::size_t queue = 8;
  double idle = 0;  ///< seconds; 0: for ever
  bool track = false;
  int keep = TrackerParams().keep;  ///< frames
  std::filesystem::path poses;      ///< of the camera; may be empty
  SegmenterOptions segmenter;
};

/// To a microsecond.
double milliseconds(Clock::duration duration) {
  return double(std::chrono::duration_cast<std::chrono::microseconds>(duration).count()) / 1000;
}

/// Puts what comes into the queue until nothing more comes or the run is to end, and closes it.
void feed(FrameQueue& queue, FrameSource& source, const Interruption& interruption, double idle_seconds) {
  Clock::time_point last = Clock::now();
  while (!queue.closed()) {
    if (interruption.requested()) return queue.abandon();
    const std::size_t room = queue.wait_for_room(FrameSource::patience);
    if (room == 0) continue;
    const auto scenes = source.next(room);
    if (!scenes) return queue.close();
    if (!scenes->empty()) {
      queue.put(*scenes);
      last = Clock::now();
    } else if (idle_seconds > 0 && milliseconds(Clock::now() - last) > 1000 * idle_seconds) {
      return queue.close();
    }
  }
}

/// How the frames of a run fared.
class Summary {
 public:
  void segmented(double latency) { latencies_.push_back(latency); }
  void failed() { ++failed_; }
  bool any_failed() const { return failed_ > 0; }

  void print(std::size_t dropped) const {
    std::cerr << "gestalt: " << counted(latencies_.size(), "frame") << ", " << dropped << " dropped, " << failed_
              << " failed";
    if (!latencies_.empty())
      std::cerr << std::fixed << std::setprecision(1) << "; latency: median " << quantile(latencies_, 0.5)
                << " ms, 99th percentile " << quantile(latencies_, 0.99) << " ms";
    std::cerr << '\n';
  }

 private:
  std::vector<double> latencies_;  ///< of the segmented frames, milliseconds
  std::size_t failed_ = 0;
};

/// One frame at a time with all threads: several at once would all be later.
void segment_all(FrameQueue& queue, const SceneSegmenter& segmenter, SceneTracker* tracker, Summary& summary) {
  while (const auto frame = queue.take()) {
    const Clock::time_point taken = Clock::now();
    try {
      const SegmentedScene done = segmenter.segment(frame->scene, tracker);
      const double latency = milliseconds(Clock::now() - frame->arrived);
      summary.segmented(latency);
      nlohmann::ordered_json line{{"frame", done.folder.filename().string()},
                                  {"result", done.folder.string()},
                                  {"objects", done.objects},
                                  {"latency_ms", latency},
                                  {"queued_ms", milliseconds(taken - frame->arrived)},
                                  {"dropped", queue.dropped()}};
      if (tracker) line["tracks"] = done.tracks;
      std::cout << line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << std::endl;
      if (!std::cout) return;  // nobody listens any more
    } catch (const std::exception& error) {
      summary.failed();
      std::cerr << "gestalt: error: " << failure_message(frame->scene, error) << '\n';
    }
  }
}

int stream(const Options& options) {
  const ThreadLimit limit(options.segmenter.pipeline.threads);
  const std::unique_ptr<FrameSource> source = open_source(options.source, options.follow);
  std::optional<SceneTracker> tracker;
  if (options.track) tracker.emplace(options.keep, options.poses);
  const SceneSegmenter segmenter(options.segmenter);
  const Interruption interruption;
  FrameQueue queue(options.drop ? std::nullopt : std::optional(options.queue));
  auto feeding = std::async(std::launch::async, [&] {
    try {
      feed(queue, *source, interruption, options.idle);
    } catch (...) {
      queue.close();
      throw;
    }
  });
  Summary summary;
  segment_all(queue, segmenter, tracker ? &*tracker : nullptr, summary);
  queue.abandon();
  summary.print(queue.dropped());
  feeding.get();
  return summary.any_failed() ? run_failed : success;
}

void add_stream(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("stream", "Segment frames as they arrive, for instance from a camera driver");
  command
      ->add_option("source", options->source,
                   "A folder of scenes, a file or named pipe with one path a line, or - for standard input")
      ->required()
      ->type_name("SOURCE");
  command->add_flag("--follow", options->follow, "Wait for more scenes in the folder, until SIGINT, SIGTERM or --idle");
  command->add_option("--idle", options->idle, "Exit after this many seconds without a frame; 0: never")
      ->check(number_in(0.0, 1e6))
      ->capture_default_str()
      ->type_name("SECONDS");
  CLI::Option* queue =
      command
          ->add_option("--queue", options->queue,
                       "Largest number of waiting frames; the source is blocked while the queue is full")
          ->check(number_in(std::size_t{1}, std::size_t{1000000}))
          ->capture_default_str()
          ->type_name("N");
  command->add_flag("--drop", options->drop, "Keep only the newest waiting frame and drop older ones")->excludes(queue);
  CLI::Option* track =
      command->add_flag("--track", options->track, "Give objects numbers that they keep from frame to frame");
  command->add_option("--keep", options->keep, "Frames for which the number of an object that is not seen is kept")
      ->check(number_in(0, 1000000))
      ->capture_default_str()
      ->needs(track)
      ->type_name("N");
  command
      ->add_option(
          "--poses", options->poses,
          "Lines `frame tx ty tz qx qy qz qw`: from the camera's frame to one that does not move, in metres, by "
          "the frame's name, so that the camera's own motion is accounted for")
      ->needs(track)
      ->type_name("FILE");
  add_segmenter_options(*command, options->segmenter);
  command->footer(
      "Prints one line of JSON a frame; latency runs from a frame's arrival until its result is written.\n"
      "Example: my_driver | gestalt stream - --drop --output out");
  command->callback([options, &run] { run = [options] { return stream(*options); }; });
}

const Subcommand subcommand(20, add_stream);

}  // namespace

}  // namespace gestalt::app::stream_command
