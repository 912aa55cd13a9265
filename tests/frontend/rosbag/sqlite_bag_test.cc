// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/sqlite_bag.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "tests/frontend/rosbag/small_bag.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::rosbag {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class SqliteBagTest : public testing::Test {
 protected:
  using Connection = std::unique_ptr<sqlite3, decltype(&sqlite3_close)>;

  // Scans at 3 s, 1 s and 2 s, odometry at 4 s, in this order.
  std::string WriteBag(const std::string& name = "log.db3") {
    SmallBag bag(folder_.Path(name), "db3");
    for (const int time_s : {3, 1, 2}) bag.Scan(time_s * kSecond_ns);
    bag.Odometry(4 * kSecond_ns, Planar(0, 0, 0));
    return bag.Finish();
  }
  static Connection Execute(const std::string& path, const char* sql) {
    sqlite3* opened = nullptr;
    sqlite3_open(path.c_str(), &opened);
    EXPECT_EQ(sqlite3_exec(opened, sql, nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(opened);
    return {opened, &sqlite3_close};
  }
  static std::vector<std::int64_t> TimesOf(MessageSource* source) {
    std::vector<std::int64_t> times_s;
    while (const auto message = source->Next()) times_s.push_back(message->time_ns / kSecond_ns);
    return times_s;
  }

  TemporaryFolder folder_;
};

TEST_F(SqliteBagTest, MessagesAreInTheOrderOfTimeWhereThereIsAnIndexOfItElseOfWriting) {
  const std::string path = WriteBag();
  EXPECT_THAT(TimesOf(OpenSqliteBag(path).get()), ElementsAre(1, 2, 3, 4));
  Execute(path, "DROP INDEX timestamp_idx");
  const auto source = OpenSqliteBag(path);
  EXPECT_EQ(source->contents().first_ns, 1 * kSecond_ns);
  EXPECT_THAT(TimesOf(source.get()), ElementsAre(3, 1, 2, 4));
  EXPECT_FALSE(source->Next()) << "the end is the end";
}

TEST_F(SqliteBagTest, TopicsAreSelectedByTheirPlaceWhateverTheirIds) {
  const std::string path = WriteBag();
  Execute(path,
          "UPDATE topics SET id = 70 WHERE id = 1; UPDATE messages SET topic_id = 70 "
          "WHERE topic_id = 1");
  const auto source = OpenSqliteBag(path);
  ASSERT_EQ(source->contents().topics.size(), 2u);
  EXPECT_EQ(source->contents().topics[1].name, "/scan");
  EXPECT_EQ(source->contents().topics[1].type, "sensor_msgs/LaserScan");
  EXPECT_EQ(source->contents().topics[1].messages, 3);
  source->Select({false, true});
  EXPECT_EQ(source->Next()->topic, 1u);
  EXPECT_THAT(TimesOf(source.get()), ElementsAre(2, 3));
  source->Select({false, false});
  EXPECT_FALSE(source->Next());
}

TEST_F(SqliteBagTest, MessagesOfNoTopicAreLeftOut) {
  const std::string path = WriteBag();
  Execute(path, "UPDATE messages SET topic_id = 9 WHERE timestamp = 1000000000");
  const auto source = OpenSqliteBag(path);
  EXPECT_EQ(source->contents().topics[0].messages, 2);
  EXPECT_EQ(source->contents().first_ns, 2 * kSecond_ns);
  EXPECT_THAT(TimesOf(source.get()), ElementsAre(2, 3, 4));
}

TEST_F(SqliteBagTest, OtherSerializationsAreToldAndMessageIsNamedByItsRow) {
  const std::string path = WriteBag();
  Execute(path, "UPDATE topics SET serialization_format = 'protobuf' WHERE name = '/odom'");
  const auto source = OpenSqliteBag(path);
  EXPECT_EQ(source->contents().topics[0].encoding, Encoding::kCdr);
  EXPECT_EQ(source->contents().topics[1].encoding, Encoding::kUnknown);
  const auto message = source->Next();
  EXPECT_EQ(message->unit, std::string("row"));
  EXPECT_EQ(message->place, 2);
  EXPECT_EQ(*message->file, path);
}

// As a recorder leaves it behind that was stopped.
TEST_F(SqliteBagTest, LogThatWasNotYetMergedIsReadAsWell) {
  const std::string path = WriteBag();
  const Connection recorder =
      Execute(path,
              "PRAGMA journal_mode=WAL; INSERT INTO messages (topic_id, timestamp, data) "
              "VALUES (1, 5000000000, x'00')");
  EXPECT_THAT(TimesOf(OpenSqliteBag(path).get()), ElementsAre(1, 2, 3, 4, 5));
}

TEST_F(SqliteBagTest, AnyNameOfAFileWillDo) {
  for (const char* name : {"log?mode=memory", "log#1.db3", "100%41.db3", "a log.db3"}) {
    EXPECT_EQ(TimesOf(OpenSqliteBag(WriteBag(name)).get()).size(), 4u) << name;
  }
  EXPECT_EQ(TimesOf(OpenSqliteBag("/" + WriteBag()).get()).size(), 4u) << "two slashes in front";
}

TEST_F(SqliteBagTest, OtherDatabasesAreRefused) {
  const std::string path = WriteBag();
  const std::string error = ": expected the tables 'topics' and 'messages' of a ROS 2 bag";
  Execute(path, "ALTER TABLE messages RENAME TO rows; CREATE VIEW messages AS SELECT * FROM rows");
  EXPECT_EQ(MessageOf([&] { OpenSqliteBag(path); }), path + error);
  const std::string other = WriteBag("other.db3");
  Execute(other, "ALTER TABLE messages RENAME COLUMN data TO bytes");
  EXPECT_EQ(MessageOf([&] { OpenSqliteBag(other); }),
            other + ": expected the tables of a ROS 2 bag: no such column: data");
  const std::string missing = folder_.Path("missing.db3");
  EXPECT_THAT(MessageOf([&] { OpenSqliteBag(missing); }),
              HasSubstr(missing + ": cannot be opened as a database"));
}

}  // namespace
}  // namespace gmapping_spa::rosbag
