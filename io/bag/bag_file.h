// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "gestalt/io/bag/bag.h"

namespace gestalt {

inline constexpr std::string_view ros1_magic = "#ROSBAG V2.0\n", mcap_magic{"\x89MCAP0\r\n", 8},
                                  sqlite_magic{"SQLite format 3\0", 16};

/// Bytes of a large file by their place. May be used from many threads at once.
class BagFile {
 public:
  /// Throws InputError when the file cannot be opened or is not a regular file.
  explicit BagFile(std::filesystem::path file);
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  std::uint64_t size() const { return size_; }

  /// So many bytes from there on. Throws InputError where the file ends before, and for more than 256 MiB.
  std::string read(std::uint64_t place, std::uint64_t count) const;

  /// Throws InputError that names the file and the place.
  [[noreturn]] void fail(std::uint64_t place, const std::string& what) const;

 private:
  const std::filesystem::path file_;
  int descriptor_;
  std::uint64_t size_ = 0;
};

std::unique_ptr<Bag> make_ros1_bag(const std::filesystem::path& file);
std::unique_ptr<Bag> make_mcap_bag(const std::filesystem::path& file);
std::unique_ptr<Bag> make_sqlite_bag(const std::filesystem::path& file);

/// The type of a message as ROS 1 names it: "sensor_msgs/msg/Image" and "sensor_msgs/Image" are one.
std::string message_type(std::string_view name);

}  // namespace gestalt
