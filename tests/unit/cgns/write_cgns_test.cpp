#include "cgns/write_cgns.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "base/error.hpp"

namespace quadrille::cgns {
namespace {

std::string scratch() { return testing::TempDir() + "write_cgns_test_" + std::to_string(getpid()) + ".cgns"; }

exports::CgnsRequest one_zone() {
  exports::CgnsZone zone;
  zone.name = "block_0";
  zone.size = {2, 2};
  zone.x = {{0, 1, 0, 1}, {0, 0, 1, 1}};
  zone.boundaries = {{"side_1", "wall", {1, 1, 2, 1}}};
  return {true, 2, {{"wall", "BCWall"}}, {zone}};
}

TEST(WriteCgns, TheFileIsHdf5TheSameEachTimeAndRemoved) {
  const std::string bytes = cgns_file(one_zone(), scratch());
  EXPECT_EQ(bytes.substr(0, 4), "\x89HDF");
  EXPECT_NE(bytes.find("BCWall"), std::string::npos);
  EXPECT_EQ(cgns_file(one_zone(), scratch()), bytes);
  EXPECT_FALSE(std::filesystem::exists(scratch()));
}

TEST(WriteCgns, WhatTheLibraryRefusesIsAnError) {
  EXPECT_THROW(cgns_file(one_zone(), "/no/such/folder/mesh.cgns"), OutputError);
  exports::CgnsRequest request = one_zone();
  request.families[0].boundary = "BCUnheardOf";
  EXPECT_THROW(cgns_file(request, scratch()), Defect);
  EXPECT_FALSE(std::filesystem::exists(scratch()));
}

}  // namespace
}  // namespace quadrille::cgns
