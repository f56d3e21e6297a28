#include "io/hdf5_file.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <functional>
#include <limits>
#include <string>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "scratch.hpp"

namespace quadrille::io {

namespace {

std::string image_of(const std::function<void(const Hdf5GroupWriter&)>& fill) {
  Hdf5Writer writer;
  fill(writer.root());
  return writer.image();
}

/// What a reader says to a part of a file; empty if it takes it.
std::string refusal(const std::string& image, const std::function<void(const Hdf5GroupReader&)>& part) {
  return message_of<FormatError>([&] {
    const Hdf5Reader reader(image, "sample.h5");
    part(reader.root());
  });
}

const std::string sample = image_of([](const Hdf5GroupWriter& root) {
  const std::vector<int> numbers{1, -2, 3, 4, 5, 6};
  const std::vector<double> reals{0.1, -1e300, std::numeric_limits<double>::infinity(), 4};
  root.text_attribute("format", "sample");
  root.integer_attribute("version", {1, 2});
  root.integers("one", numbers.data(), {}, "1", "a number");
  root.integers("list", numbers.data(), {6}, "", "");
  root.integers("table", numbers.data(), {2, 3}, "", "");
  root.reals("reals", reals.data(), {2, 2}, "length", "");
  root.texts("words",
             {"",
              "Stra\xc3\x9f"
              "e",
              "two words"},
             false, "", "");
  root.group("inner").texts("name", {"deep"}, true, "", "");
});

TEST(Hdf5File, ValuesReadBackToTheSameBits) {
  const Hdf5Reader reader(sample, "sample.h5");
  const Hdf5GroupReader& root = reader.root();
  EXPECT_EQ(root.integers("one", 0), std::vector<int>{1});
  EXPECT_EQ(root.integers("list", 1), (std::vector<int>{1, -2, 3, 4, 5, 6}));
  EXPECT_EQ(root.integers("table", 3), root.integers("list", 1));
  EXPECT_EQ(root.reals("reals", 2), (std::vector<double>{0.1, -1e300, std::numeric_limits<double>::infinity(), 4}));
  EXPECT_EQ(root.texts("words", 1), (std::vector<std::string>{"",
                                                              "Stra\xc3\x9f"
                                                              "e",
                                                              "two words"}));
  EXPECT_EQ(root.group("inner").texts("name", 0), std::vector<std::string>{"deep"});
  EXPECT_EQ(root.text_attribute("format"), "sample");
  EXPECT_EQ(root.integer_attribute("version"), (std::vector<int>{1, 2}));
}

TEST(Hdf5File, SaysWhatItHas) {
  const Hdf5Reader reader(sample, "sample.h5");
  EXPECT_TRUE(reader.root().has("list"));
  EXPECT_TRUE(reader.root().has("inner"));
  EXPECT_FALSE(reader.root().has("outer"));
  EXPECT_TRUE(reader.root().has_attribute("version"));
  EXPECT_FALSE(reader.root().has_attribute("list"));
}

TEST(Hdf5File, EmptyListsAreLists) {
  const std::string image = image_of([](const Hdf5GroupWriter& root) {
    root.reals("none", nullptr, {0, 2}, "", "");
    root.texts("silence", {}, false, "", "");
  });
  const Hdf5Reader reader(image, "sample.h5");
  EXPECT_TRUE(reader.root().reals("none", 2).empty());
  EXPECT_TRUE(reader.root().texts("silence", 1).empty());
}

TEST(Hdf5File, AnotherShapeOrClassIsRefusedWithFileAndName) {
  const std::vector<std::function<void(const Hdf5GroupReader&)>> wrong{
      [](const auto& root) { root.integers("table", 1); },  [](const auto& root) { root.integers("table", 2); },
      [](const auto& root) { root.integers("list", 0); },   [](const auto& root) { root.integers("reals", 2); },
      [](const auto& root) { root.reals("words", 1); },     [](const auto& root) { root.texts("list", 1); },
      [](const auto& root) { root.integers("inner", 1); },  [](const auto& root) { root.group("list"); },
      [](const auto& root) { root.integers("missing", 1); }};
  for (std::size_t k = 0; k < wrong.size(); ++k) {
    const std::string message = refusal(sample, wrong[k]);
    EXPECT_TRUE(message.starts_with("sample.h5")) << k << ": " << message;
  }
  EXPECT_NE(refusal(sample, [](const auto& root) { root.group("inner").integers("name", 0); }).find("inner"),
            std::string::npos);
  EXPECT_EQ(refusal(sample, [](const auto& root) { root.reals("list", 1); }), "") << "integers are numbers";
}

TEST(Hdf5File, TheSameContentIsTheSameBytes) {
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

TEST(Hdf5File, OtherBytesAreNoHdf5) {
  EXPECT_FALSE(looks_like_hdf5(""));
  EXPECT_FALSE(looks_like_hdf5("{\"format\": 1}"));
  for (const std::string& bytes : {std::string(), std::string("no file at all"), sample.substr(0, sample.size() / 2)})
    EXPECT_NE(refusal(bytes, [](const auto& root) { root.integers("table", 3); }), "");
}

/// A file of another program: one dataset "x" of `count` zeros, with properties that `set` gives it.
std::string foreign_file(hsize_t count, const std::function<void(hid_t)>& set) {
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose), properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_fapl_core(access.get(), 1 << 20, false);
  const Hdf5Id file(H5Fcreate("/dev/null/foreign", H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose);
  const Hdf5Id space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  set(properties.get());
  const Hdf5Id x(H5Dcreate2(file.get(), "x", H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                 H5Dclose);
  if (H5Pget_external_count(properties.get()) == 0) {
    const std::vector<double> zeros(count);
    H5Dwrite(x.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
  }
  H5Fflush(file.get(), H5F_SCOPE_GLOBAL);
  std::string bytes(static_cast<std::size_t>(H5Fget_file_image(file.get(), nullptr, 0)), '\0');
  H5Fget_file_image(file.get(), bytes.data(), bytes.size());
  return bytes;
}

TEST(Hdf5File, ValuesInOtherFilesAreNotRead) {
  const std::string file =
      foreign_file(2, [](hid_t properties) { H5Pset_external(properties, "/etc/passwd", 0, H5F_UNLIMITED); });
  EXPECT_EQ(refusal(file, [](const auto& root) { root.reals("x", 1); }),
            "sample.h5: 'x' has its values in another file, which is not read");
}

TEST(Hdf5File, ACompressedDatasetIsReadUnlessItIsABomb) {
  const auto file_of = [](hsize_t count) {
    return foreign_file(count, [count](hid_t properties) {
      H5Pset_chunk(properties, 1, &count);
      H5Pset_deflate(properties, 9);
    });
  };
  EXPECT_EQ(refusal(file_of(100'000), [](const auto& root) { root.reals("x", 1); }), "");
  const std::string bomb = file_of(10'000'000);
  EXPECT_LT(bomb.size(), 1u << 20);
  EXPECT_EQ(refusal(bomb, [](const auto& root) { root.reals("x", 1); }), "sample.h5: 'x' is larger than the file");
  EXPECT_EQ(refusal(file_of(5'000'000), [](const auto& root) { root.reals("x", 1), root.reals("x", 1); }),
            "sample.h5: 'x' is larger than the file")
      << "all datasets together";
}

class Hdf5InAFolder : public Scratch {};

TEST_F(Hdf5InAFolder, AFileFolderOrPipeCalledImageIsInNobodysWay) {
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
