#include "io/json_archive.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::io {
namespace {

struct Part {
  int count = 0;
  std::string name;
};

/// A member of each kind.
struct Sample {
  int number = 0;
  double real = 0;
  bool is_set = false;
  std::string text, options = "{}";
  std::vector<int> integers;
  std::vector<Vec2> points;
  std::vector<double> packed;
  std::vector<Part> parts;
};

void describe(Archive& archive, Sample& sample) {
  archive.field("number", sample.number);
  archive.field("real", sample.real);
  archive.field("is_set", sample.is_set);
  archive.field("text", sample.text);
  archive.json("options", sample.options, {});
  archive.field("integers", sample.integers);
  archive.field("points", sample.points);
  archive.packed_object("inner", [&](Archive& inner) { inner.field("packed", sample.packed); });
  archive.records(
      "parts", sample.parts.size(), [&](std::size_t count) { sample.parts.resize(count); },
      [&](Archive& record, std::size_t i) {
        record.field("count", sample.parts[i].count);
        record.field("name", sample.parts[i].name);
      });
}

Sample full() {
  return {-3,
          0.1,
          true,
          "tab\tand \"quote\"",
          R"({"b":1,"a":[2]})",
          {1, 2},
          {{0.5, -1}, {1e300, 2}},
          {0.1, -0.0, 1e-300},
          {{1, "one"}, {2, ""}}};
}

std::string written(Sample sample) {
  JsonWriter writer;
  describe(writer.root(), sample);
  return writer.flat_text();
}

Sample read(const std::string& bytes) {
  JsonReader reader(bytes, "x.json");
  Sample sample;
  describe(reader.root(), sample);
  return sample;
}

/// The message for the text with one part replaced.
std::string refusal(const std::string& part, const std::string& by) {
  std::string bytes = written(full());
  EXPECT_NE(bytes.find(part), std::string::npos) << part;
  bytes.replace(bytes.find(part), part.size(), by);
  return message_of<FormatError>([&] { read(bytes); });
}

TEST(JsonArchive, EveryKindOfMemberReadsBack) {
  const Sample sample = read(written(full())), expected = full();
  EXPECT_EQ(sample.number, expected.number);
  EXPECT_EQ(sample.real, expected.real);
  EXPECT_TRUE(sample.is_set);
  EXPECT_EQ(sample.text, expected.text);
  EXPECT_EQ(sample.options, expected.options) << "keys in their order";
  EXPECT_EQ(sample.integers, expected.integers);
  EXPECT_EQ(sample.points, expected.points);
  EXPECT_EQ(sample.packed, expected.packed);
  ASSERT_EQ(sample.parts.size(), 2u);
  EXPECT_EQ(sample.parts[0].name, "one");
  EXPECT_EQ(written(sample), written(full()));
}

TEST(JsonArchive, EmptyListsReadBackEmpty) {
  const Sample sample = read(written({}));
  EXPECT_TRUE(sample.integers.empty() && sample.points.empty() && sample.packed.empty() && sample.parts.empty());
}

TEST(JsonArchive, MembersOfAnotherKindAreRefusedWithTheirPath) {
  EXPECT_EQ(refusal(R"("number":-3)", R"("number":1.5)"), "x.json: 'number' must be an integer");
  EXPECT_EQ(refusal(R"("number":-3)", R"("number":"1")"), "x.json: 'number' must be an integer");
  EXPECT_EQ(refusal(R"("number":-3)", R"("nimber":-3)"), "x.json: 'number' is missing");
  EXPECT_EQ(refusal(R"("real":0.1)", R"("real":null)"), "x.json: 'real' must be a number");
  EXPECT_EQ(refusal(R"("is_set":true)", R"("is_set":1)"), "x.json: 'is_set' must be true or false");
  EXPECT_EQ(refusal(R"([0.5,-1.0])", "[0.5]"), "x.json: 'points' must be an array of 2 numbers");
  EXPECT_EQ(refusal(R"([1,2])", "{}"), "x.json: 'integers' must be an array");
  EXPECT_EQ(refusal(R"({"count":2,)", R"({"count":"2",)"), "x.json: 'parts[1].count' must be an integer");
  EXPECT_EQ(refusal(R"({"count":1,"name":"one"})", "7"), "x.json: 'parts[0]' must be an object");
}

TEST(JsonArchive, IntegersMustFit) {
  for (const char* number : {"2147483648", "-2147483649", "9223372036854775808", "18446744073709551615"})
    EXPECT_EQ(refusal(R"("number":-3)", std::string("\"number\":") + number),
              "x.json: 'number' is an integer out of range")
        << number;
  EXPECT_EQ(refusal(R"("number":-3)", R"("number":2147483647)"), "");
  EXPECT_EQ(refusal(R"("number":-3)", R"("number":-2147483648)"), "");
}

TEST(JsonArchive, PackedNumbersMustBeWholeDoubles) {
  std::string bytes = written(full());
  const std::size_t begin = bytes.find("\"packed\":\"") + 10, end = bytes.find('"', begin);
  const std::string packed = bytes.substr(begin, end - begin);
  const std::string expected = "x.json: 'inner.packed' must be the base64 of doubles, 1 for each entry";
  EXPECT_EQ(refusal(packed, packed.substr(4)), expected) << "three bytes less";
  EXPECT_EQ(refusal(packed, "####"), expected);
  EXPECT_EQ(refusal('"' + packed + '"', "[0.1]"), expected);
  EXPECT_EQ(refusal(packed, ""), "");
}

TEST(JsonArchive, WhatIsNoJsonIsRefusedWithoutWordsOfTheLibrary) {
  const auto message = [](const std::string& bytes) { return message_of<FormatError>([&] { read(bytes); }); };
  EXPECT_TRUE(message("").starts_with("x.json: not valid JSON: ")) << message("");
  EXPECT_EQ(count(message("{"), "json.exception"), 0);
  EXPECT_EQ(message("[]"), "x.json: the top level must be an object");
  EXPECT_TRUE(message("{\"real\": 1e999}").starts_with("x.json: not valid JSON: ")) << "infinite";
}

TEST(JsonArchive, NumbersThatAreNotFiniteAreNotWritten) {
  Sample sample = full();
  sample.real = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message_of<Defect>([&] { written(sample); }), "'real' contains a number that is not finite");
  sample = full();
  sample.packed[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of<Defect>([&] { written(sample); }), "'packed' contains a number that is not finite");
}

std::string repeated(const std::string& part, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += part;
  return all;
}

TEST(IsShallow, LevelsOfBracketsAreLimitedOutsideOfTexts) {
  EXPECT_TRUE(is_shallow(repeated("[", 100) + repeated("]", 100)));
  EXPECT_FALSE(is_shallow(repeated("[", 101)));
  EXPECT_FALSE(is_shallow(repeated("{\"a\":", 101)));
  EXPECT_TRUE(is_shallow('"' + repeated("[", 101) + '"'));
  EXPECT_TRUE(is_shallow("\"\\\"" + repeated("[", 101) + '"')) << "an escaped quote ends no text";
  EXPECT_FALSE(is_shallow("\"\\\\\"" + repeated("[", 101))) << "an escaped backslash before a quote does";
  EXPECT_TRUE(is_shallow(repeated("[]", 1000)));
  EXPECT_EQ(message_of<FormatError>([] { require_shallow(repeated("[", 101), "x.json"); }),
            "x.json: not valid: nested deeper than 100 levels");
}

TEST(IsShallow, KeysOfOneObjectAreLimited) {
  EXPECT_TRUE(is_shallow('{' + repeated("\"a\":1,", 10000)));
  EXPECT_FALSE(is_shallow('{' + repeated("\"a\":1,", 10001)));
  EXPECT_TRUE(is_shallow('[' + repeated("{\"a\":1,\"b\":2},", 10001))) << "of each object";
  EXPECT_EQ(message_of<FormatError>([] { require_shallow('{' + repeated("\"a\":1,", 10001), "x.json"); }),
            "x.json: not valid: an object has more than 10000 keys");
}

}  // namespace
}  // namespace quadrille::io
