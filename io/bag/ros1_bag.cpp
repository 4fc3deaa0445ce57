// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Bags of ROS 1, version 2.0: http://wiki.ros.org/Bags/Format/2.0

#include <map>
#include <optional>

#include "bag_file.h"
#include "byte_reader.h"
#include "decompression.h"

namespace gestalt {

namespace {

enum class RecordKind : std::uint8_t { message = 2, bag_header = 3, chunk = 5, connection = 7 };

/// The fields of a record's header, by name.
std::map<std::string, std::string_view, std::less<>> fields_of(std::string_view header) {
  std::map<std::string, std::string_view, std::less<>> fields;
  for (ByteReader reader(header); !reader.ended();) {
    const std::string_view field = reader.text();
    const std::size_t equals = field.find('=');
    if (equals == field.npos) throw InputError("a header's field has no '='");
    fields[std::string(field.substr(0, equals))] = field.substr(equals + 1);
  }
  return fields;
}

class Record {
 public:
  /// One that lies at the reader's place.
  explicit Record(ByteReader& reader)
      : fields_(fields_of(reader.text())),
        size_(reader.number<std::uint32_t>()),
        place_(reader.place()),
        data_(reader.bytes(size_)) {}

  RecordKind kind() const { return RecordKind(number<std::uint8_t>("op")); }
  std::string_view data() const { return data_; }
  std::size_t place() const { return place_; }  ///< of the data

  std::string_view text(const char* name) const {
    const auto found = fields_.find(name);
    if (found == fields_.end()) throw InputError("a record's header has no field '" + std::string(name) + "'");
    return found->second;
  }

  template <class Number>
  Number number(const char* name) const {
    return ByteReader(text(name)).number<Number>();
  }

 private:
  std::map<std::string, std::string_view, std::less<>> fields_;
  std::uint32_t size_;
  std::size_t place_;
  std::string_view data_;
};

class Ros1Bag final : public Bag {
 public:
  explicit Ros1Bag(const std::filesystem::path& file) : file_(file) {}

  void scan(const Take& take) override {
    for (std::uint64_t place = ros1_magic.size(); place < file_.size();) {
      std::optional<Extent> record;
      try {
        record = extent(place);
      } catch (const InputError&) {
        broken_off_ = "byte " + std::to_string(place) + ": the last record is incomplete";  // as it was being written
        return;
      }
      const std::string bytes = file_.read(place, record->size);
      try {
        ByteReader reader(bytes);
        const Record read(reader);
        if (read.kind() == RecordKind::chunk) scan_chunk(place, decompressed(read), take);
        if (read.kind() == RecordKind::connection) add_connection(read);
      } catch (const InputError& error) {
        file_.fail(place, error.what());
      }
      place += record->size;
    }
  }

  std::string read(const MessagePlace& place) const override {
    const std::string bytes = file_.read(place.chunk, extent(place.chunk).size);
    ByteReader reader(bytes);
    const std::string chunk = decompressed(Record(reader));
    return chunk.substr(std::size_t(place.offset), std::size_t(place.size));
  }

 private:
  struct Extent {
    std::uint64_t size;
  };

  /// Of the record there, by the lengths of its two parts.
  Extent extent(std::uint64_t place) const {
    const auto length = [&](std::uint64_t at) { return ByteReader(file_.read(at, 4)).number<std::uint32_t>(); };
    const std::uint64_t header = length(place), data = length(place + 4 + header);
    const std::uint64_t size = 8 + header + data;
    if (size > file_.size() - place) file_.fail(place, "the last record is incomplete");
    return {size};
  }

  static std::string decompressed(const Record& chunk) {
    return gestalt::decompressed(chunk.data(), chunk.text("compression"), chunk.number<std::uint32_t>("size"));
  }

  void scan_chunk(std::uint64_t place, const std::string& chunk, const Take& take) {
    for (ByteReader reader(chunk); !reader.ended();) {
      const Record record(reader);
      if (record.kind() == RecordKind::connection) add_connection(record);
      if (record.kind() != RecordKind::message) continue;
      const auto known = topic_of_.find(record.number<std::uint32_t>("conn"));
      if (known == topic_of_.end()) throw InputError("a message has no connection");
      BagTopic& topic = topics_[known->second];
      ++topic.messages;
      take(topic, {place, record.place(), record.data().size(), true}, record.data());
    }
  }

  void add_connection(const Record& record) {
    const auto number = record.number<std::uint32_t>("conn");
    if (topic_of_.contains(number)) return;
    const auto fields = fields_of(record.data());
    const auto type = fields.find("type");
    const std::string name(record.text("topic"));
    for (std::size_t i = 0; i < topics_.size(); ++i)
      if (topics_[i].name == name) {
        topic_of_[number] = i;  // of another publisher
        return;
      }
    topic_of_[number] = topics_.size();
    topics_.push_back({name, type == fields.end() ? "" : std::string(type->second), MessageEncoding::ros1, 0});
  }

  const BagFile file_;
  std::map<std::uint32_t, std::size_t> topic_of_;
};

}  // namespace

std::unique_ptr<Bag> make_ros1_bag(const std::filesystem::path& file) { return std::make_unique<Ros1Bag>(file); }

}  // namespace gestalt
