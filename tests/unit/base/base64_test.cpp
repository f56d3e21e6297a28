#include "base/base64.hpp"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(Base64, IsReadBack) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) {
    EXPECT_EQ(bytes_of_base64(base64(bytes)), bytes);
    bytes += static_cast<char>(37 * i);
  }
}

TEST(Base64, OtherTextsAreRefused) {
  for (const char* text :
       {"Z", "Zg=", "Zm9v=", "Z===", "====", "Zm9v\nZg=", "Z-==", "Zh==", "Zm9=", "Zg==Zg==", "=m9v"})
    EXPECT_EQ(bytes_of_base64(text), std::nullopt) << text;
}

}  // namespace
}  // namespace quadrille
