#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "io/json_archive.hpp"

namespace quadrille::io {

namespace {

using Json = nlohmann::ordered_json;

TEST(JsonText, TheTopLevelHasALineForEachKeyInItsOrder) {
  Json json;
  json["z"] = 1;
  json["a"] = {{"x", 1}, {"y", Json::array({1, 2})}};
  EXPECT_EQ(json_text(json), "{\n  \"z\": 1,\n  \"a\": {\"x\": 1, \"y\": [1, 2]}\n}\n");
}

TEST(JsonText, DoublesKeepTheirBitsAndAPoint) {
  for (const double x : {0.1, 1.0 / 3, 1e300, 5e-324, -2.0, std::numeric_limits<double>::max()}) {
    Json json;
    json["x"] = x;
    const std::string text = json_text(json);
    EXPECT_EQ(Json::parse(text)["x"].get<double>(), x) << text;
    EXPECT_TRUE(Json::parse(text)["x"].is_number_float()) << text << "has a point or an exponent";
  }
}

TEST(JsonText, LeavesAndKeysAreThoseOfTheLibrary) {
  const Json leaves =
      Json::array({-7, std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::uint64_t>::max(), 2.0, -0.0,
                   1e-7, 1e22, std::numeric_limits<double>::quiet_NaN(), true, nullptr, "a\tb"});
  for (const Json& leaf : leaves) {
    Json json;
    json["k"] = leaf;
    EXPECT_EQ(json_text(json), "{\n  \"k\": " + leaf.dump() + "\n}\n");
  }
  for (const std::string key : {"plain_1", "", "with blank", "a\"b", "\xC3\xA4"}) {
    Json json;
    json[key] = 1;
    EXPECT_EQ(json_text(json), "{\n  " + Json(key).dump() + ": 1\n}\n");
  }
}

TEST(JsonText, LongListsOfNumbersAndPointsAreWrappedWithinTheWidth) {
  Json json;
  for (int i = 0; i < 200; ++i) {
    json["numbers"].push_back(i);
    json["points"].push_back({0.5 * i, 0.25});
  }
  std::istringstream lines(json_text(json));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    EXPECT_LE(line.size(), 111u) << line << ": 110 and a comma";
  EXPECT_LT(count, 60) << "many items on a line";
  EXPECT_EQ(Json::parse(json_text(json)), json);
}

TEST(JsonText, LongObjectsHaveALineForEachMember) {
  Json record;
  for (int i = 0; i < 20; ++i) record["a_long_member_name_" + std::to_string(i)] = i;
  Json json;
  json["records"] = Json::array({record, record});
  const std::string text = json_text(json);
  EXPECT_NE(text.find("\n      \"a_long_member_name_7\": 7,\n"), std::string::npos) << text;
  EXPECT_EQ(Json::parse(text), json);
}

TEST(JsonText, EmptyListsAndObjectsAndBytesThatAreNoUtf8ArePrinted) {
  Json json;
  json["list"] = Json::array();
  json["object"] = Json::object();
  json["text"] = "a\xff\"";
  EXPECT_EQ(json_text(json), "{\n  \"list\": [],\n  \"object\": {},\n  \"text\": \"a\xEF\xBF\xBD\\\"\"\n}\n");
}

}  // namespace

}  // namespace quadrille::io
