#include "base/byte_archive.hpp"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

struct Part {
  bool flag = false;
  double number = 0;
};
struct Whole {
  std::string text;
  std::vector<Part> parts;
  std::vector<std::string> words;
  std::pair<int, std::variant<int, std::string>> either;
  std::array<double, 2> two{};
};
struct Members {
  static void of(auto& a, Is<Part> auto& p) { a(p.flag, p.number); }
  static void of(auto& a, Is<Whole> auto& w) { a(w.text, w.parts, w.words, w.either, w.two); }
};

Whole sample() { return {"a\0b", {{true, 0.1}, {false, -2}}, {"", "x"}, {7, "second"}, {1, 2}}; }

TEST(ByteArchive, ReadsWhatItWrites) {
  const std::string bytes = to_bytes_by<Members>(sample());
  Whole read;
  from_bytes_by<Members>(bytes, read);
  EXPECT_EQ(read.text, sample().text);
  ASSERT_EQ(read.parts.size(), 2U);
  EXPECT_TRUE(read.parts[0].flag);
  EXPECT_EQ(read.parts[1].number, -2);
  EXPECT_EQ(read.words, sample().words);
  EXPECT_EQ(read.either, sample().either);
  EXPECT_EQ(read.two, sample().two);
  EXPECT_EQ(to_bytes_by<Members>(read), bytes);
}

TEST(ByteArchive, RefusesBytesOfAnotherLength) {
  const std::string bytes = to_bytes_by<Members>(sample());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    Whole read;
    EXPECT_THROW(from_bytes_by<Members>(bytes.substr(0, size), read), Defect) << size;
  }
  Whole read;
  EXPECT_THROW(from_bytes_by<Members>(bytes + '\0', read), Defect);
}

}  // namespace
}  // namespace quadrille
