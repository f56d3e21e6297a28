#include <gtest/gtest.h>
#include <hdf5.h>

#include <functional>
#include <limits>
#include <string>

#include "hdf5_samples.hpp"

namespace quadrille::io {

namespace {

TEST(Hdf5Reader, ValuesReadBackToTheSameBits) {
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

TEST(Hdf5Reader, SaysWhatItHas) {
  const Hdf5Reader reader(sample, "sample.h5");
  EXPECT_TRUE(reader.root().has("list"));
  EXPECT_TRUE(reader.root().has("inner"));
  EXPECT_FALSE(reader.root().has("outer"));
  EXPECT_TRUE(reader.root().has_attribute("version"));
  EXPECT_FALSE(reader.root().has_attribute("list"));
}

TEST(Hdf5Reader, AnotherShapeOrClassIsRefusedWithFileAndName) {
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

TEST(Hdf5Reader, OtherBytesAreNoHdf5) {
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

TEST(Hdf5Reader, ValuesInOtherFilesAreNotRead) {
  const std::string file =
      foreign_file(2, [](hid_t properties) { H5Pset_external(properties, "/etc/passwd", 0, H5F_UNLIMITED); });
  EXPECT_EQ(refusal(file, [](const auto& root) { root.reals("x", 1); }),
            "sample.h5: 'x' has its values in another file, which is not read");
}

TEST(Hdf5Reader, ACompressedDatasetIsReadUnlessItIsABomb) {
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

}  // namespace

}  // namespace quadrille::io
