#include "netcdf/write_netcdf.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrille::netcdf {
namespace {

exports::NetcdfRequest small_file() {
  exports::NetcdfRequest file;
  const int n = file.add_dimension("n", 3), records = file.add_dimension("t", 0);
  file.attributes = {{"title", std::string("ab")}};
  file.variables = {{"k", {n}, std::vector<std::int32_t>{1, 2, -1}}, {"time", {records}, std::vector<double>{}}};
  return file;
}

std::vector<std::uint32_t> words_of(const std::string& bytes) {
  std::vector<std::uint32_t> words(bytes.size() / 4, 0);
  for (std::size_t k = 0; k < 4 * words.size(); ++k)
    words[k / 4] = words[k / 4] << 8 | static_cast<unsigned char>(bytes[k]);
  return words;
}

/// Bytes as the specification lists them, in words of four.
TEST(WriteNetcdf, ASmallFileInFullAndTheSameEachTime) {
  const std::string bytes = netcdf_file(small_file());
  const std::vector<std::uint32_t> words = words_of(bytes);
  const auto begin = static_cast<std::uint32_t>(4 * (words.size() - 3));
  EXPECT_EQ(words, (std::vector<std::uint32_t>{
                       0x43444602, 0,                                                                // CDF, no record
                       10,         2,          1,         0x6E000000, 3,          1, 0x74000000, 0,  // n = 3; t
                       12,         1,          5,         0x7469746C, 0x65000000, 2, 2,          0x61620000,  // title
                       11,         2,          1,         0x6B000000, 1,          0, 0,          0,
                       4,          12,         0,         begin,  // k
                       4,          0x74696D65, 1,         1,          0,          0, 6,          8,
                       0,          begin + 12,  // time
                       1,          2,          0xFFFFFFFF}));
  EXPECT_EQ(netcdf_file(small_file()), bytes);
}

TEST(WriteNetcdf, AllTypesAndAttributesOfVariables) {
  exports::NetcdfRequest file;
  const int two = file.add_dimension("two", 2), three = file.add_dimension("three", 3);
  file.variables = {{"text", {two, three}, std::string("abcdef")},
                    {"single", {two}, std::vector<float>{1, -2}, {{"unit", std::string("m")}}},
                    {"double", {two}, std::vector<double>{1, -2}}};
  const std::string bytes = netcdf_file(file);
  EXPECT_NE(bytes.find("abcdef"), std::string::npos);
  EXPECT_NE(bytes.find(std::string("unit\0\0\0\2\0\0\0\1m", 13)), std::string::npos);
  EXPECT_NE(bytes.find(std::string("\x3F\x80\0\0\xC0\0\0\0", 8)), std::string::npos);
  EXPECT_NE(bytes.find(std::string("\x3F\xF0\0\0\0\0\0\0\xC0\0\0\0\0\0\0\0", 16)), std::string::npos);
}

TEST(WriteNetcdf, WhatTheLibraryRefusesIsAnError) {
  exports::NetcdfRequest file = small_file();
  file.variables.push_back(file.variables[0]);
  try {
    netcdf_file(file);
    FAIL() << "two variables of one name";
  } catch (const OutputError& e) {
    EXPECT_STREQ(e.what(), "the netCDF library reports: NetCDF: String match to name in use");
  }
  file = small_file();
  file.variables[0].values = std::vector<std::int32_t>{1, 2};
  EXPECT_THROW(netcdf_file(file), Defect);
}

TEST(WriteNetcdf, RequestsArriveAsTheyWere) {
  const exports::NetcdfRequest sent = small_file();
  EXPECT_EQ(netcdf_file(exports::netcdf_request(to_bytes(sent))), netcdf_file(sent));
  EXPECT_THROW(exports::netcdf_request("damaged"), Defect);
}

}  // namespace
}  // namespace quadrille::netcdf
