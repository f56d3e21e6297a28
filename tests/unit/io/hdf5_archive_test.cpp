#include "io/hdf5_archive.hpp"

#include <gtest/gtest.h>

#include <string>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::io {
namespace {

enum class Colour { red, blue };
constexpr auto enum_names(Colour) { return std::to_array({"red", "blue"}); }

struct Ball {
  int number = 0;
  double radius = 0;
  Vec2 centre;
  bool is_hollow = false;
  Colour colour = Colour::red;
  std::vector<Vec2> path;
  std::vector<std::array<int, 3>> faces;
  std::vector<std::string> names;
  std::string material;  // of an object inside
  std::vector<double> weights;
};

void describe(Archive& archive, Ball& ball) {
  archive.field("number", ball.number);
  archive.field("radius", ball.radius);
  archive.field("centre", ball.centre);
  archive.field("is_hollow", ball.is_hollow);
  archive.field("colour", ball.colour, {}, "BAL-R01");
  archive.field("path", ball.path);
  archive.field("faces", ball.faces);
  archive.field("names", ball.names);
  archive.object("skin", [&](Archive& inner) { inner.field("material", ball.material); });
  archive.records(
      "weights", ball.weights.size(), [&](std::size_t count) { ball.weights.resize(count); },
      [&](Archive& record, std::size_t i) {
        double unused = 0;
        record.field("w", i == Archive::declared ? unused : ball.weights[i]);
      });
}

std::string image_of(Ball ball) {
  Hdf5Writer writer;
  describe(*hdf5_archive(writer.root()), ball);
  return writer.image();
}

Ball read(const std::string& image) {
  const Hdf5Reader reader(image, "ball.h5");
  Ball ball;
  describe(*hdf5_archive(reader.root()), ball);
  return ball;
}

Ball sample() {
  return {3, 0.5, {1, 2}, true, Colour::blue, {{0, 0}, {1, 1}}, {{0, 1, 2}}, {"a", ""}, "leather", {0.25, 0.75}};
}

TEST(Hdf5Archive, EveryKindOfMemberReadsBack) {
  const Ball ball = read(image_of(sample())), expected = sample();
  EXPECT_EQ(ball.number, expected.number);
  EXPECT_EQ(ball.radius, expected.radius);
  EXPECT_EQ(ball.centre, expected.centre);
  EXPECT_TRUE(ball.is_hollow);
  EXPECT_EQ(ball.colour, Colour::blue);
  EXPECT_EQ(ball.path, expected.path);
  EXPECT_EQ(ball.faces, expected.faces);
  EXPECT_EQ(ball.names, expected.names);
  EXPECT_EQ(ball.material, "leather");
  EXPECT_EQ(ball.weights, expected.weights);
}

TEST(Hdf5Archive, EmptyListsReadBackEmpty) {
  const Ball ball = read(image_of({}));
  EXPECT_TRUE(ball.path.empty());
  EXPECT_TRUE(ball.faces.empty());
  EXPECT_TRUE(ball.weights.empty());
}

TEST(Hdf5Archive, ItSaysWhatTheFileHas) {
  const std::string image = image_of(sample());
  const Hdf5Reader reader(image, "ball.h5");
  const auto archive = hdf5_archive(reader.root());
  EXPECT_TRUE(archive->is_reading());
  EXPECT_TRUE(archive->has("skin"));
  EXPECT_FALSE(archive->has("bone"));
}

std::string refusal(const std::function<void(const Hdf5GroupWriter&)>& write,
                    const std::function<void(Archive&)>& ask) {
  Hdf5Writer writer;
  write(writer.root());
  const std::string image = writer.image();
  const Hdf5Reader reader(image, "ball.h5");
  return message_of<FormatError>([&] { ask(*hdf5_archive(reader.root())); });
}

TEST(Hdf5Archive, AFlagIsZeroOrOne) {
  const auto flag = [](int value) {
    return refusal([=](const auto& root) { root.integers("is_hollow", &value, {}, "", ""); },
                   [](Archive& archive) {
                     bool read_back = false;
                     archive.field("is_hollow", read_back);
                   });
  };
  EXPECT_EQ(flag(0), "");
  EXPECT_EQ(flag(1), "");
  EXPECT_NE(flag(2).find("must be 0 or 1"), std::string::npos);
}

TEST(Hdf5Archive, AMemberOfFixedSizeHasItsNumberOfValues) {
  const std::vector<double> three{1, 2, 3};
  const std::string message = refusal([&](const auto& root) { root.reals("centre", three.data(), {3}, "", ""); },
                                      [](Archive& archive) {
                                        Vec2 centre;
                                        archive.field("centre", centre);
                                      });
  EXPECT_NE(message.find("must have 2 values"), std::string::npos) << message;
}

TEST(Hdf5Archive, AnUnknownNameIsRefusedWithTheAllowedOnesAndTheRule) {
  const auto ask = [](const std::function<void(Archive&, Colour&)>& field) {
    return refusal([](const auto& root) { root.texts("colour", {"green"}, true, "", ""); },
                   [&](Archive& archive) {
                     Colour colour = Colour::blue;
                     field(archive, colour);
                     EXPECT_EQ(colour, Colour::red);
                   });
  };
  const std::string message = ask([](Archive& a, Colour& c) { a.field("colour", c, {}, "BAL-R01"); });
  for (const char* part : {"red", "blue", "not 'green'", "(BAL-R01)"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_EQ(ask([](Archive& a, Colour& c) { a.extensible_field("colour", c, Colour::red); }), "");
}

}  // namespace
}  // namespace quadrille::io
