// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/bag_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/frontend/rosbag/small_bag.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::rosbag {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class BagFolderTest : public testing::Test {
 protected:
  // An MCAP with scans at these times.
  void AddFile(const std::string& name, const std::vector<int>& times_s) {
    SmallBag bag(folder_.Path(name), "mcap");
    for (const int time_s : times_s) bag.Scan(time_s * kSecond_ns);
    bag.Finish();
  }
  void ListFiles(const std::string& lines) {
    folder_.FileWith("metadata.yaml",
                     "rosbag2_bagfile_information:\n  relative_file_paths:\n" + lines);
  }
  std::unique_ptr<MessageSource> Open() const { return OpenBagFolder(folder_.path()); }
  std::vector<std::int64_t> TimesOf(MessageSource* source) const {
    std::vector<std::int64_t> times_s;
    while (const auto message = source->Next()) times_s.push_back(message->time_ns / kSecond_ns);
    return times_s;
  }
  std::string Error() const {
    return MessageOf([&] { Open(); });
  }

  TemporaryFolder folder_;
};

TEST_F(BagFolderTest, WithoutABagIsAnError) {
  const std::string error = folder_.path() + ": expected a folder with a bag, found no file";
  EXPECT_EQ(Error(), error);
  folder_.FileWith("notes.txt", "a robot in a house");
  std::filesystem::create_directory(folder_.Path("older"));
  EXPECT_EQ(Error(), error);
  ListFiles("    - log_0.mcap\n");
  EXPECT_EQ(Error(), error);
}

TEST_F(BagFolderTest, MetadataThatListsNoFilesIsAnErrorOfOneLine) {
  AddFile("log_0", {1});
  const std::string path = folder_.Path("metadata.yaml");
  for (const char* text : {"", "rosbag2", "rosbag2_bagfile_information: 5", "a: [1, 2"}) {
    folder_.FileWith("metadata.yaml", text);
    EXPECT_THAT(Error(), StartsWith(path)) << text;
    EXPECT_THAT(Error(), HasSubstr(": expected the metadata of a ROS 2 bag, found: ")) << text;
  }
  ListFiles("    - {name: log_0}\n");
  EXPECT_THAT(Error(), StartsWith(path + ":3: expected the metadata"));
}

TEST_F(BagFolderTest, ListedFilesAreFoundByTheirNameWhereverTheyWereRecorded) {
  AddFile("log_0", {1});
  AddFile("log_1", {2});
  AddFile("other", {3});
  ListFiles("    - /home/robot/bags/log_0\n    - bags/log_1\n    - log_2\n    - ''\n");
  const auto source = Open();
  EXPECT_THAT(TimesOf(source.get()), ElementsAre(1, 2));
  EXPECT_EQ(source->contents().missing_files, 2);
}

TEST_F(BagFolderTest, NamesThatNoFileCanHaveAreMissingFiles) {
  AddFile("log_0", {1});
  ListFiles("    - log_0\n    - " + std::string(300, 'n') + "\n");
  const auto source = Open();
  EXPECT_THAT(TimesOf(source.get()), ElementsAre(1));
  EXPECT_EQ(source->contents().missing_files, 1);
}

TEST_F(BagFolderTest, FilesFollowEachOtherInTheOrderOfTimeAsOneBag) {
  AddFile("log_0", {5, 6});
  AddFile("log_1", {1, 2, 3});
  const auto source = Open();
  const BagContents& contents = source->contents();
  ASSERT_EQ(contents.topics.size(), 1u);
  EXPECT_EQ(contents.topics[0].messages, 5);
  EXPECT_EQ(contents.first_ns, 1 * kSecond_ns);
  EXPECT_EQ(contents.last_ns, 6 * kSecond_ns);
  EXPECT_EQ(contents.format, "MCAP, 2 files");
  EXPECT_EQ(*source->Next()->file, folder_.Path("log_1"));
  EXPECT_THAT(TimesOf(source.get()), ElementsAre(2, 3, 5, 6));
}

// As recorders leave it behind that were stopped when they had just begun a file.
TEST_F(BagFolderTest, FileWithoutMessagesTellsNoTimes) {
  AddFile("log_0", {7});
  AddFile("log_1", {});
  EXPECT_EQ(Open()->contents().first_ns, 7 * kSecond_ns);
  AddFile("a_first_one", {});
  const auto source = Open();
  EXPECT_EQ(source->contents().first_ns, 7 * kSecond_ns);
  EXPECT_EQ(source->contents().last_ns, 7 * kSecond_ns);
  EXPECT_THAT(TimesOf(source.get()), ElementsAre(7));
}

TEST_F(BagFolderTest, TopicIsTheSameInFilesThatNumberItOtherwise) {
  AddFile("log_0", {1});
  SmallBag bag(folder_.Path("log_1"), "mcap");
  bag.Odometry(2 * kSecond_ns, Planar(0, 0, 0));
  bag.Scan(3 * kSecond_ns);
  bag.Finish();
  const auto source = Open();
  ASSERT_EQ(source->contents().topics.size(), 2u);
  EXPECT_EQ(source->contents().topics[1].name, "/odom");
  for (int round = 0; round < 2; ++round) {  // Select goes to the begin
    source->Select({true, false});
    EXPECT_THAT(TimesOf(source.get()), ElementsAre(1, 3));
  }
  source->Select({false, true});
  EXPECT_EQ(source->Next()->topic, 1u);
}

TEST_F(BagFolderTest, IsUnclosedWhereOneOfItsFilesIs) {
  AddFile("log_0", {1});
  EXPECT_FALSE(Open()->contents().unclosed);
  AddFile("log_1", {2, 3});
  const std::string bytes = BytesOf(folder_.Path("log_1"));
  folder_.FileWith("log_1", bytes.substr(0, bytes.size() - 5));
  AddFile("log_2", {4});
  const auto source = Open();
  EXPECT_TRUE(source->contents().unclosed);
  EXPECT_THAT(TimesOf(source.get()), ElementsAre(1, 2, 3, 4));
}

}  // namespace
}  // namespace gmapping_spa::rosbag
