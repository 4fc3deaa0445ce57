// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Recordings of rosbag2 with the storage sqlite3: the tables topics and messages.

#include <sqlite3.h>

#include <map>

#include "bag_file.h"
#include "decompression.h"
#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

class Statement {
 public:
  Statement(sqlite3* database, const char* query) : database_(database) {
    if (sqlite3_prepare_v2(database, query, -1, &statement_, nullptr) != SQLITE_OK) fail();
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  void bind(std::int64_t value) { sqlite3_bind_int64(statement_, 1, value); }

  /// The next row; false: there are no more.
  bool step() {
    const int code = sqlite3_step(statement_);
    if (code != SQLITE_ROW && code != SQLITE_DONE) fail();
    return code == SQLITE_ROW;
  }

  std::int64_t number(int column) { return sqlite3_column_int64(statement_, column); }

  std::string_view bytes(int column) {
    const void* const data = sqlite3_column_blob(statement_, column);
    return {static_cast<const char*>(data), data ? std::size_t(sqlite3_column_bytes(statement_, column)) : 0};
  }

 private:
  [[noreturn]] void fail() const {
    throw InputError(std::string("the database cannot be read: ") + sqlite3_errmsg(database_));
  }

  sqlite3* database_;
  sqlite3_stmt* statement_ = nullptr;
};

class SqliteBag final : public Bag {
 public:
  explicit SqliteBag(std::filesystem::path file) : file_(std::move(file)) {
    // Not by its name, which may have characters that an URI takes for its own.
    const int code = sqlite3_open_v2(file_.c_str(), &database_, SQLITE_OPEN_READONLY | SQLITE_OPEN_FULLMUTEX, nullptr);
    if (code != SQLITE_OK) {
      const std::string why = database_ ? sqlite3_errmsg(database_) : "out of memory";
      sqlite3_close(database_);
      throw InputError(file_.string() + ": cannot be opened: " + why);
    }
    sqlite3_limit(database_, SQLITE_LIMIT_LENGTH, int(largest_chunk - 1));
    sqlite3_db_config(database_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(database_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  }
  ~SqliteBag() override { sqlite3_close(database_); }
  SqliteBag(const SqliteBag&) = delete;
  SqliteBag& operator=(const SqliteBag&) = delete;

  void scan(const Take& take) override {
    of_file([&] {
      require_table("topics");
      require_table("messages");
      std::map<std::int64_t, std::size_t> topic_of;
      Statement topics(database_, "SELECT id, name, type, serialization_format FROM topics ORDER BY id");
      while (topics.step()) {
        const bool is_cdr = topics.bytes(3) == "cdr";
        topic_of[topics.number(0)] = topics_.size();
        topics_.push_back({std::string(topics.bytes(1)), message_type(topics.bytes(2)),
                           is_cdr ? MessageEncoding::cdr : MessageEncoding::ros1, 0});
      }
      Statement messages(database_, "SELECT id, topic_id, data FROM messages ORDER BY id");
      while (messages.step()) {
        const auto known = topic_of.find(messages.number(1));
        if (known == topic_of.end()) throw InputError("a message is of no topic");
        BagTopic& topic = topics_[known->second];
        ++topic.messages;
        const std::string_view data = messages.bytes(2);
        take(topic, {0, std::uint64_t(messages.number(0)), data.size(), false}, data);
      }
    });
  }

  std::string read(const MessagePlace& place) const override {
    std::string data;
    of_file([&] {
      Statement message(database_, "SELECT data FROM messages WHERE id = ?");
      message.bind(std::int64_t(place.offset));
      if (!message.step()) throw InputError("the message " + std::to_string(place.offset) + " is gone");
      data = message.bytes(0);
    });
    return data;
  }

 private:
  template <class Work>
  void of_file(const Work& work) const {
    try {
      work();
    } catch (const InputError& error) {
      throw InputError(file_.string() + ": " + error.what());
    }
  }

  /// A view of that name could compute without end.
  void require_table(const std::string& name) const {
    Statement tables(database_, "SELECT name, sql FROM sqlite_master WHERE type = 'table'");
    while (tables.step())
      if (tables.bytes(0) == name && tables.bytes(1).starts_with("CREATE TABLE")) return;
    throw InputError("has no table '" + name + "'; it is not a recording of rosbag2");
  }

  const std::filesystem::path file_;
  sqlite3* database_ = nullptr;
};

}  // namespace

std::unique_ptr<Bag> make_sqlite_bag(const std::filesystem::path& file) { return std::make_unique<SqliteBag>(file); }

}  // namespace gestalt
