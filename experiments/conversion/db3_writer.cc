// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/conversion/db3_writer.h"

#include <sqlite3.h>

#include <stdexcept>

#include "experiments/conversion/message_definitions.h"

namespace gmapping_spa::conversion {
namespace {

constexpr const char* kTables =
    "PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; BEGIN;"
    "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);"
    "INSERT INTO schema VALUES (3, 'humble');"
    "CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, "
    "metadata TEXT NOT NULL);"
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
    "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, "
    "timestamp INTEGER NOT NULL, data BLOB NOT NULL);"
    "CREATE INDEX timestamp_idx ON messages (timestamp ASC);";

class Db3Writer : public BagWriter {
 public:
  explicit Db3Writer(const std::string& path) : path_(path) {
    sqlite3* opened = nullptr;
    const int status =
        sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
    database_.reset(opened);
    if (status != SQLITE_OK) Fail();
    Execute(kTables);
    add_topic_ = Prepare("INSERT INTO topics VALUES (?, ?, ?, 'cdr', '')");
    add_message_ = Prepare("INSERT INTO messages (topic_id, timestamp, data) VALUES (?, ?, ?)");
  }

  rosbag::Encoding encoding() const override { return rosbag::Encoding::kCdr; }

  int AddTopic(std::string_view name, std::string_view type) override {
    const int id = ++num_topics_;
    const std::string ros2_type = Ros2TypeName(type);
    sqlite3_bind_int(add_topic_.get(), 1, id);
    sqlite3_bind_text(add_topic_.get(), 2, name.data(), static_cast<int>(name.size()),
                      SQLITE_TRANSIENT);
    sqlite3_bind_text(add_topic_.get(), 3, ros2_type.data(), static_cast<int>(ros2_type.size()),
                      SQLITE_TRANSIENT);
    Run(add_topic_.get());
    return id;
  }

  void Write(int topic, std::int64_t time_ns, std::string_view message) override {
    sqlite3_bind_int(add_message_.get(), 1, topic);
    sqlite3_bind_int64(add_message_.get(), 2, time_ns);
    sqlite3_bind_blob(add_message_.get(), 3, message.data(), static_cast<int>(message.size()),
                      SQLITE_STATIC);
    Run(add_message_.get());
  }

  void Finish() override { Execute("COMMIT"); }

 private:
  struct Closer {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  using Statement = std::unique_ptr<sqlite3_stmt, Closer>;

  [[noreturn]] void Fail() const {
    throw std::runtime_error(path_ + ": cannot be written: " + sqlite3_errmsg(database_.get()));
  }
  void Execute(const char* sql) {
    if (sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) Fail();
  }
  Statement Prepare(const char* sql) {
    sqlite3_stmt* made = nullptr;
    if (sqlite3_prepare_v2(database_.get(), sql, -1, &made, nullptr) != SQLITE_OK) Fail();
    return Statement(made);
  }
  void Run(sqlite3_stmt* statement) {
    if (sqlite3_step(statement) != SQLITE_DONE || sqlite3_reset(statement) != SQLITE_OK) Fail();
  }

  std::string path_;
  std::unique_ptr<sqlite3, Closer> database_;
  Statement add_topic_, add_message_;
  int num_topics_ = 0;
};

}  // namespace

std::unique_ptr<BagWriter> MakeDb3Writer(const std::string& path) {
  return std::make_unique<Db3Writer>(path);
}

}  // namespace gmapping_spa::conversion
