#include "io/digest.hpp"

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

// FIPS 180-4 and NIST's example vectors.
TEST(Sha256, KnownDigests) {
  EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_hex(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

/// The padding has its corners at 55, 56, 63 and 64 bytes (digests by coreutils' sha256sum).
TEST(Sha256, EveryPadding) {
  EXPECT_EQ(sha256_hex(std::string(55, 'x')), "d5e285683cd4efc02d021a5c62014694958901005d6f71e89e0989fac77e4072");
  EXPECT_EQ(sha256_hex(std::string(56, 'x')), "04c26261370ee7541549d16dee320c723e3fd14671e66a099afe0a377c16888e");
  EXPECT_EQ(sha256_hex(std::string(63, 'x')), "75220b47218278e656f2013bb8f0c455a25eaf01e86c64924e9d48d89776d6f2");
  EXPECT_EQ(sha256_hex(std::string(64, 'x')), "7ce100971f64e7001e8fe5a51973ecdfe1ced42befe7ee8d5fd6219506b5393c");
}

TEST(Sha256, WithAndWithoutTheProcessorsInstructions) {
  std::string bytes;
  for (int length = 0; length < 700; ++length) {
    EXPECT_EQ(sha256_hex(bytes), sha256_hex_in_software(bytes)) << length;
    bytes += static_cast<char>(37 * length + length / 7);
  }
}

}  // namespace

}  // namespace quadrille::io
