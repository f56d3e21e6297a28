#include "io/checksum.hpp"

#include <gtest/gtest.h>

namespace quadrille::io {
namespace {

Checksum verified(const std::string& bytes, std::string& content) {
  std::string_view image;
  const Checksum checksum = verify_checksum(bytes, image);
  content = image;
  return checksum;
}

TEST(ChecksumTest, SealedBytesAreRightAndTheImageIsWhatWasSealed) {
  for (const std::size_t size : {0u, 1u, 7u, 8u, 9u, 1000u}) {
    std::string bytes(size, 'x'), content;
    append_checksum(bytes);
    EXPECT_EQ(bytes.size(), size + 16);
    EXPECT_EQ(verified(bytes, content), Checksum::right) << size;
    EXPECT_EQ(content, std::string(size, 'x'));
  }
}

TEST(ChecksumTest, EveryChangedBitIsSeen) {
  std::string bytes = "some bytes of an image", content;
  append_checksum(bytes);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
      EXPECT_EQ(verified(damaged, content), Checksum::wrong) << i;
    }
}

TEST(ChecksumTest, ZerosInFrontOfTheTrailerAreSeen) {
  std::string bytes = "image", content;
  append_checksum(bytes);
  bytes.insert(5, 1, '\0');
  EXPECT_EQ(verified(bytes, content), Checksum::wrong) << "the length counts";
}

TEST(ChecksumTest, BytesWithoutATrailerHaveNoChecksum) {
  std::string content;
  EXPECT_EQ(verified("short", content), Checksum::missing);
  EXPECT_EQ(content, "short");
  EXPECT_EQ(verified(std::string(100, 'x'), content), Checksum::missing);
  EXPECT_EQ(content.size(), 100u);
}

}  // namespace
}  // namespace quadrille::io
