#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "hdf5_samples.hpp"
#include "scratch.hpp"

namespace quadrille::io {

namespace {

TEST(Hdf5Writer, TheSameContentIsTheSameBytes) {
  const auto once = [] {
    return image_of([](const Hdf5GroupWriter& root) {
      const double x = 0.5;
      root.group("a").reals("x", &x, {}, "length", "a coordinate");
      root.text_attribute("format", "sample");
    });
  };
  EXPECT_EQ(once(), once());
  EXPECT_TRUE(looks_like_hdf5(once()));
}

TEST(Hdf5Writer, EmptyListsAreLists) {
  const std::string image = image_of([](const Hdf5GroupWriter& root) {
    root.reals("none", nullptr, {0, 2}, "", "");
    root.texts("silence", {}, false, "", "");
  });
  const Hdf5Reader reader(image, "sample.h5");
  EXPECT_TRUE(reader.root().reals("none", 2).empty());
  EXPECT_TRUE(reader.root().texts("silence", 1).empty());
}

TEST(Hdf5Writer, TwoMembersOfOneNameAreRefused) {
  const int value = 1;
  EXPECT_THROW(image_of([&](const Hdf5GroupWriter& root) {
                 root.integers("one", &value, {}, "", "");
                 root.integers("one", &value, {}, "", "");
               }),
               std::exception);
}

class Hdf5WriterInAFolder : public Scratch {};

TEST_F(Hdf5WriterInAFolder, AFileFolderOrPipeCalledImageIsInNobodysWay) {
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(path(""));
  for (const char* kind : {"file", "folder", "pipe"}) {
    if (*kind == 'p')
      mkfifo("image", 0600);
    else if (kind[1] == 'o')
      std::filesystem::create_directory("image");
    else
      put("image", "text");
    EXPECT_EQ(refusal(sample, [](const auto& root) { root.integers("one", 0); }), "") << kind;
    EXPECT_EQ(image_of([](const Hdf5GroupWriter& root) { root.text_attribute("a", "b"); }).substr(1, 3), "HDF") << kind;
    std::filesystem::remove_all("image");
  }
  std::filesystem::current_path(before);
}

}  // namespace

}  // namespace quadrille::io
