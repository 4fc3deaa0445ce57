// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// MCAP files: https://mcap.dev/spec

#include <boost/crc.hpp>
#include <map>
#include <optional>

#include "bag_file.h"
#include "byte_reader.h"
#include "decompression.h"

namespace gestalt {

namespace {

enum class Op : std::uint8_t { footer = 2, schema = 3, channel = 4, message = 5, chunk = 6, data_end = 15 };

constexpr std::uint64_t head = 9;                 // bytes of a record's op and length
constexpr std::size_t message_head = 2 + 4 + 16;  // channel, sequence, two times

class McapBag final : public Bag {
 public:
  explicit McapBag(const std::filesystem::path& file) : file_(file) {}

  void scan(const Take& take) override {
    for (std::uint64_t place = mcap_magic.size(); place < file_.size();) {
      if (file_.size() - place < head) return end_early(place);
      const std::string start = file_.read(place, head);
      ByteReader reader(start);
      const auto op = Op(reader.number<std::uint8_t>());
      const auto size = reader.number<std::uint64_t>();
      if (op == Op::footer || op == Op::data_end) return;
      if (size > file_.size() - place - head) return end_early(place);
      if (op == Op::schema || op == Op::channel || op == Op::message || op == Op::chunk) {
        const std::string content = file_.read(place + head, size);
        try {
          read_record(op, place, content, take);
        } catch (const InputError& error) {
          file_.fail(place, error.what());
        }
      }
      place += head + size;
    }
    broken_off_ = "the file ends without a footer";
  }

  std::string read(const MessagePlace& place) const override {
    if (!place.in_chunk) return file_.read(place.offset, place.size);
    const auto size = ByteReader(file_.read(place.chunk + 1, 8)).number<std::uint64_t>();
    return decompressed(file_.read(place.chunk + head, size))
        .substr(std::size_t(place.offset), std::size_t(place.size));
  }

 private:
  void end_early(std::uint64_t place) {
    broken_off_ = "byte " + std::to_string(place) + ": the last record is incomplete";
  }

  void read_record(Op op, std::uint64_t place, const std::string& content, const Take& take) {
    if (op == Op::chunk)
      scan_chunk(place, decompressed(content), take);
    else
      read_content(op, content, {place, place + head, 0, false}, take);
  }

  static std::string decompressed(std::string_view chunk) {
    ByteReader reader(chunk);
    reader.bytes(16);  // times
    const auto size = reader.number<std::uint64_t>();
    const auto expected = reader.number<std::uint32_t>();
    const std::string_view compression = reader.text();
    const auto stored = reader.number<std::uint64_t>();
    std::string records = gestalt::decompressed(reader.bytes(stored), compression, size);
    boost::crc_32_type checksum;
    checksum.process_bytes(records.data(), records.size());
    if (expected != 0 && expected != checksum.checksum())  // 0: the writer has computed none
      throw InputError("a chunk's checksum is not that of its data; the file is damaged, copy it again");
    return records;
  }

  void scan_chunk(std::uint64_t place, const std::string& chunk, const Take& take) {
    for (ByteReader reader(chunk); !reader.ended();) {
      const auto op = Op(reader.number<std::uint8_t>());
      const auto size = reader.number<std::uint64_t>();
      const std::uint64_t begin = reader.place();
      read_content(op, reader.bytes(size), {place, begin, 0, true}, take);
    }
  }

  /// place.offset: of the content.
  void read_content(Op op, std::string_view content, MessagePlace place, const Take& take) {
    ByteReader reader(content);
    if (op == Op::schema) {
      const auto number = reader.number<std::uint16_t>();
      type_of_[number] = message_type(reader.text());
    } else if (op == Op::channel) {
      add_channel(reader);
    } else if (op == Op::message) {
      const auto known = topic_of_.find(reader.number<std::uint16_t>());
      if (known == topic_of_.end()) throw InputError("a message has no channel");
      reader.bytes(message_head - 2);
      place.offset += message_head;
      place.size = reader.left();
      BagTopic& topic = topics_[known->second];
      ++topic.messages;
      take(topic, place, reader.bytes(place.size));
    }
  }

  void add_channel(ByteReader& reader) {
    const auto number = reader.number<std::uint16_t>(), schema = reader.number<std::uint16_t>();
    if (topic_of_.contains(number)) return;
    const std::string name(reader.text());
    const bool is_cdr = reader.text() == "cdr";
    const auto type = type_of_.find(schema);
    topic_of_[number] = topics_.size();
    topics_.push_back(
        {name, type == type_of_.end() ? "" : type->second, is_cdr ? MessageEncoding::cdr : MessageEncoding::ros1, 0});
  }

  const BagFile file_;
  std::map<std::uint16_t, std::string> type_of_;
  std::map<std::uint16_t, std::size_t> topic_of_;
};

}  // namespace

std::unique_ptr<Bag> make_mcap_bag(const std::filesystem::path& file) { return std::make_unique<McapBag>(file); }

}  // namespace gestalt
