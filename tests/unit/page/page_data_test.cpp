#include "page/page_data.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace quadrille::page {

namespace {

TEST(PageData, Base64IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(PageData, NumbersArePackedWithTheirLowByteFirst) {
  EXPECT_EQ(packed(std::vector<std::int32_t>{1, -2}), base64(std::string("\1\0\0\0\xfe\xff\xff\xff", 8)));
  EXPECT_EQ(packed(std::vector<std::int16_t>{258, -1}), base64("\2\1\xff\xff"));
  EXPECT_EQ(packed(std::vector<std::uint8_t>{7, 255}), base64("\7\xff"));
  EXPECT_EQ(packed_floats({1.0}), base64(std::string("\0\0\x80\x3f", 4)));
}

TEST(PageData, TextsCannotEndAScriptNorOpenMarkup) {
  EXPECT_EQ(script_string("a\"b</script>&\n"), R"("a\"b\u003c/script\u003e\u0026\u000a")");
  EXPECT_EQ(html_text("<b a=\"1\">&\n"), "&lt;b a=&quot;1&quot;&gt;&amp; ");
}

TEST(PageData, ObjectsKeepTheOrderOfTheirKeys) {
  JsonObject object;
  object.text("b", "x").number("a", 0.5).flag("c", true).number("d", std::numeric_limits<double>::infinity());
  object.json("e", json_list({"1", "2"})).data("f", "Zg==").json("g", json_texts({"<"}));
  EXPECT_EQ(object.str(), R"({"b":"x","a":0.5,"c":true,"d":null,"e":[1,2],"f":"Zg==","g":["\u003c"]})");
}

}  // namespace

}  // namespace quadrille::page
