// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// How a message's bytes are laid out.
enum class MessageEncoding { ros1, cdr };

struct BagTopic {
  std::string name;
  std::string type;  ///< "sensor_msgs/Image", as in ROS 1
  MessageEncoding encoding = MessageEncoding::ros1;
  std::uint64_t messages = 0;
};

/// Where a message is in its bag.
struct MessagePlace {
  std::uint64_t chunk = 0;   ///< offset of the chunk's record in the file
  std::uint64_t offset = 0;  ///< of the message's bytes in the decompressed chunk, or in the file outside of chunks
  std::uint64_t size = 0;    ///< bytes
  bool in_chunk = true;
};

/// A recording of ROS: a bag of ROS 1 (version 2.0); an MCAP file of ROS 1 or 2, chunks uncompressed or by bz2, lz4 or
/// zstd; or the database of rosbag2. A file may be larger than memory: one chunk of it is held at a time. May be used
/// from many threads at once. Files may be untrusted: all methods throw InputError naming the file, the place and what
/// is wrong.
class GESTALT_EXPORT Bag {
 public:
  using Take = std::function<void(const BagTopic& topic, const MessagePlace& place, std::string_view message)>;

  virtual ~Bag();

  /// By name. Filled by scan().
  const std::vector<BagTopic>& topics() const { return topics_; }

  /// Every message once, in the order of the file. Called once, by open_bag().
  virtual void scan(const Take& take) = 0;

  /// The bytes of a message that scan() has given.
  virtual std::string read(const MessagePlace& place) const = 0;

  /// Where the recording breaks off, as of a recorder that was killed: the messages before are read. "": it is
  /// complete.
  const std::string& broken_off() const { return broken_off_; }

 protected:
  std::vector<BagTopic> topics_;
  std::string broken_off_;
};

/// Whether a file begins as a recording, or a folder is one of rosbag2.
GESTALT_EXPORT bool is_bag(const std::filesystem::path& file);

/// Opens a recording and scans it.
GESTALT_EXPORT std::unique_ptr<Bag> open_bag(const std::filesystem::path& file, const Bag::Take& take);

}  // namespace gestalt
