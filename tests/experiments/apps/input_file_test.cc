// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/input_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>

namespace gmapping_spa::apps {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

std::string Gzip(const std::string& text) {
  std::ostringstream packed;
  boost::iostreams::filtering_ostream out;
  out.push(boost::iostreams::gzip_compressor());
  out.push(packed);
  out << text;
  boost::iostreams::close(out);
  return packed.str();
}

// More than one buffer of bytes that hardly compress.
std::string LongText() {
  std::mt19937 random(1);
  std::string text(200000, ' ');
  for (char& c : text) c = static_cast<char>('0' + random() % 64);
  return text;
}

class InputFile : public testing::Test {
 protected:
  ~InputFile() override { std::filesystem::remove(path_); }

  void Write(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }

  std::string Read() const {
    const auto in = OpenInput(path_);
    return {std::istreambuf_iterator<char>(*in), {}};
  }

  const std::string path_ = testing::TempDir() + "input_file_test_" +
                            testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(InputFile, PlainBytesAreReadAsTheyAre) {
  for (const std::string& bytes :
       {std::string(), std::string("\x1f"), std::string("a\n\0b", 4), LongText()}) {
    Write(bytes);
    EXPECT_EQ(Read(), bytes);
  }
}

TEST_F(InputFile, GzipIsUnpacked) {
  Write(Gzip(LongText()));
  EXPECT_EQ(Read(), LongText());
}

TEST_F(InputFile, AllMembersOfAGzipFileAreRead) {
  Write(Gzip("one\n") + Gzip("") + Gzip("two\n"));
  EXPECT_EQ(Read(), "one\ntwo\n");
}

TEST_F(InputFile, GzipCutOffAnywhereIsAnErrorThatNamesTheFile) {
  const std::string packed = Gzip("a short text, a short text, and its end\n");
  for (std::size_t size = 2; size < packed.size(); ++size) {  // less does not look like gzip
    Write(packed.substr(0, size));
    EXPECT_THAT([&] { Read(); }, ThrowsMessage<std::runtime_error>(
                                     AllOf(HasSubstr(path_ + ": "), Not(HasSubstr("\n")))))
        << "cut to " << size << " of " << packed.size();
  }
}

TEST_F(InputFile, LongGzipCutOffIsAnErrorForWhoReadsLines) {
  const std::string packed = Gzip(LongText() + "\n" + LongText());
  for (const std::size_t missing : {1, 4, 8, 9, 1000, 65536, 100000}) {
    Write(packed.substr(0, packed.size() - missing));
    const auto in = OpenInput(path_);
    std::string line;
    EXPECT_THROW(while (std::getline(*in, line)), std::runtime_error) << missing << " missing";
  }
}

TEST_F(InputFile, GzipCutOffInItsSecondMemberIsAnError) {
  const std::string first = Gzip("one\n"), second = Gzip("two\n");
  for (std::size_t size = 1; size < second.size(); ++size) {
    Write(first + second.substr(0, size));
    EXPECT_THROW(Read(), std::runtime_error) << "second member cut to " << size;
  }
}

TEST_F(InputFile, GzipWithAFlippedByteInDataOrChecksumIsAnError) {
  const std::string packed = Gzip("a short text, a short text, and its end\n");
  // From behind the header up to the length that follows the checksum, which tells nothing more.
  for (std::size_t i = 10; i < packed.size() - 4; ++i) {
    std::string corrupt = packed;
    corrupt[i] = static_cast<char>(corrupt[i] ^ 0x55);
    Write(corrupt);
    EXPECT_THROW(Read(), std::runtime_error) << "byte " << i << " of " << packed.size();
  }
}

TEST_F(InputFile, MissingFileAndDirectoryAreErrorsThatSaySo) {
  EXPECT_THAT([] { OpenInput("/no/such/file"); },
              ThrowsMessage<std::runtime_error>("/no/such/file: cannot be opened: No such file or "
                                                "directory"));
  const std::string folder = testing::TempDir();
  EXPECT_THAT([&] { OpenInput(folder); },
              ThrowsMessage<std::runtime_error>(HasSubstr("found a directory")));
  EXPECT_THAT([&] { IdentifyFile(folder); },
              ThrowsMessage<std::runtime_error>(HasSubstr("found a directory")));
}

TEST_F(InputFile, IdentityIsThatOfTheBytesOfTheFile) {
  Write("abc");
  EXPECT_EQ(IdentifyFile(path_).sha256,  // FIPS 180-2, appendix B.1
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(IdentifyFile(path_).bytes, 3);
  Write("");
  EXPECT_EQ(IdentifyFile(path_).sha256,
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(IdentifyFile(path_).bytes, 0);
  Write(std::string(1000000, 'a'));  // appendix B.3, longer than a buffer
  EXPECT_EQ(IdentifyFile(path_).sha256,
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace gmapping_spa::apps
