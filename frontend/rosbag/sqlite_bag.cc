// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/sqlite_bag.h"

#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

#include "backend/text.h"
#include "frontend/rosbag/unpack.h"

namespace gmapping_spa::rosbag {
namespace {

// The name of a file in the way of a URI.
std::string Escaped(const std::string& path) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string escaped;
  for (const char c : path) {
    if (c == '%' || c == '?' || c == '#') {
      escaped += '%';
      escaped += kHex[static_cast<unsigned char>(c) >> 4];
      escaped += kHex[static_cast<unsigned char>(c) & 15];
    } else {
      escaped += c;
    }
  }
  return escaped;
}

class Database {
 public:
  explicit Database(const std::string& path) : path_(path) {
    // A log that was not yet merged into the database is read with it; else nothing is locked or
    // written, so that read-only folders will do.
    std::error_code ignored;
    const bool has_log = std::filesystem::exists(path + "-wal", ignored);
    // What follows two slashes alone would be the name of a machine.
    const std::string uri = (path.starts_with('/') ? "file://" : "file:") + Escaped(path) +
                            (has_log ? "?mode=ro" : "?mode=ro&immutable=1");
    sqlite3* opened = nullptr;
    const int status =
        sqlite3_open_v2(uri.c_str(), &opened, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
    connection_ = std::shared_ptr<sqlite3>(opened, &sqlite3_close);
    if (status != SQLITE_OK) Fail("cannot be opened as a database");
    bytes_ = static_cast<std::int64_t>(std::filesystem::file_size(path));
    if (has_log) bytes_ += static_cast<std::int64_t>(std::filesystem::file_size(path + "-wal"));
    LimitWhatAFileMayDo();
  }

  const std::string& path() const { return path_; }
  std::int64_t bytes() const { return bytes_; }
  sqlite3* get() const { return connection_.get(); }

  // Lets the next query take as many instructions as tables of this size can need: some 30 a row of
  // 10 bytes or more. Pages that are each other's or that many others share would have rows without
  // end.
  void BeginQuery() const { *rounds_left_ = (1'000'000 + 100 * bytes_) / kRound; }

  [[noreturn]] void Fail(const std::string& message) const {
    throw std::runtime_error(path_ + ": " + message + ": " +
                             backend::Printable(sqlite3_errmsg(connection_.get())));
  }

 private:
  static constexpr int kRound = 1000;  // instructions

  // A damaged or hostile file must not get further than an error.
  void LimitWhatAFileMayDo() {
    // Values are as long as the file, unless it computes them.
    const auto longest = std::min<std::int64_t>(kMaxChunkBytes, bytes_ + (1 << 20));
    sqlite3_limit(get(), SQLITE_LIMIT_LENGTH, static_cast<int>(longest));
    sqlite3_db_config(get(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(get(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    const auto count = [](void* rounds) {
      return --*static_cast<std::int64_t*>(rounds) < 0 ? 1 : 0;
    };
    sqlite3_progress_handler(get(), kRound, count, rounds_left_.get());
  }

  std::string path_;
  std::int64_t bytes_ = 0;
  std::shared_ptr<std::int64_t> rounds_left_ = std::make_shared<std::int64_t>(kRound);
  std::shared_ptr<sqlite3> connection_;
};

class Query {
 public:
  Query(const Database& database, const std::string& sql) : database_(database) {
    database_.BeginQuery();
    sqlite3_stmt* made = nullptr;
    if (sqlite3_prepare_v2(database.get(), sql.c_str(), -1, &made, nullptr) != SQLITE_OK) {
      database_.Fail("expected the tables of a ROS 2 bag");
    }
    statement_ = std::shared_ptr<sqlite3_stmt>(made, &sqlite3_finalize);
  }

  // Whether there is another row.
  bool Step() {
    if (is_done_) return false;  // SQLite would begin anew
    const int status = sqlite3_step(statement_.get());
    if (status == SQLITE_ROW) return true;
    if (status != SQLITE_DONE) database_.Fail("expected another row, found a damaged database");
    is_done_ = true;
    return false;
  }
  std::int64_t Integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  std::string_view Bytes(int column) const {
    const void* bytes = sqlite3_column_blob(statement_.get(), column);
    const int size = sqlite3_column_bytes(statement_.get(), column);
    if (bytes == nullptr || size <= 0) return {};
    return {static_cast<const char*>(bytes), static_cast<std::size_t>(size)};
  }

 private:
  Database database_;
  std::shared_ptr<sqlite3_stmt> statement_;
  bool is_done_ = false;
};

class SqliteBag : public MessageSource {
 public:
  explicit SqliteBag(const std::string& path) : database_(path) {
    // Views and triggers of a hostile file could run for ever.
    Query tables(database_,
                 "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND "
                 "name IN ('topics', 'messages') AND sql NOT LIKE 'CREATE VIRTUAL%'");
    if (!tables.Step() || tables.Integer(0) != 2) {
      throw std::runtime_error(path +
                               ": expected the tables 'topics' and 'messages' of a ROS 2 bag");
    }
    Query index(database_,
                "SELECT count(*) FROM sqlite_master WHERE type = 'index' AND tbl_name = "
                "'messages' AND sql LIKE '%(timestamp%'");
    has_time_index_ = index.Step() && index.Integer(0) > 0;
    ReadTopics();
    contents_.format = "ROS 2 bag (SQLite)";
    contents_.bytes = database_.bytes();
    Select(std::vector<bool>(contents_.topics.size(), true));
  }

  const BagContents& contents() const override { return contents_; }

  void Select(const std::vector<bool>& wanted) override {
    std::string ids;
    for (const auto& [id, topic] : topic_of_id_) {
      if (!wanted[topic]) continue;
      if (!ids.empty()) ids += ',';
      ids += std::to_string(id);
    }
    // A sort of messages could fill the memory.
    messages_.emplace(database_,
                      "SELECT rowid, topic_id, timestamp, data FROM messages WHERE "
                      "topic_id IN (" +
                          ids + ") ORDER BY " + (has_time_index_ ? "timestamp, rowid" : "rowid"));
  }

  std::optional<BagMessage> Next() override {
    if (!messages_->Step()) return std::nullopt;
    const auto topic = topic_of_id_.find(messages_->Integer(1));
    if (topic == topic_of_id_.end()) {  // which only a damaged index gives
      throw std::runtime_error(database_.path() + ": row " + std::to_string(messages_->Integer(0)) +
                               ": expected a message of a topic that was asked for");
    }
    return BagMessage{topic->second, messages_->Integer(2), messages_->Bytes(3), &database_.path(),
                      "row",         messages_->Integer(0)};
  }

 private:
  void ReadTopics() {
    Query topics(database_, "SELECT id, name, type, serialization_format FROM topics ORDER BY id");
    while (topics.Step()) {
      BagTopic topic;
      topic.name = topics.Bytes(1);
      topic.type = Ros1TypeName(topics.Bytes(2));
      if (topics.Bytes(3) == "cdr") topic.encoding = Encoding::kCdr;
      topic_of_id_[topics.Integer(0)] = contents_.topics.size();
      contents_.topics.push_back(std::move(topic));
    }
    Query counts(database_,
                 "SELECT topic_id, count(*), min(timestamp), max(timestamp) FROM messages GROUP "
                 "BY topic_id");
    bool is_first = true;
    while (counts.Step()) {
      const auto found = topic_of_id_.find(counts.Integer(0));
      if (found == topic_of_id_.end()) continue;
      contents_.topics[found->second].messages = counts.Integer(1);
      const std::int64_t first = counts.Integer(2), last = counts.Integer(3);
      contents_.first_ns = is_first ? first : std::min(contents_.first_ns, first);
      contents_.last_ns = is_first ? last : std::max(contents_.last_ns, last);
      is_first = false;
    }
  }

  Database database_;
  bool has_time_index_ = false;
  BagContents contents_;
  std::map<std::int64_t, std::size_t> topic_of_id_;
  std::optional<Query> messages_;
};

}  // namespace

std::unique_ptr<MessageSource> OpenSqliteBag(const std::string& path) {
  return std::make_unique<SqliteBag>(path);
}

}  // namespace gmapping_spa::rosbag
