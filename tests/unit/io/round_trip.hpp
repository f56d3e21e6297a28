#pragma once
// Stage files that are written, read and written again.

#include "io/stage_files.hpp"
#include "scratch.hpp"

namespace quadrille::io {

class RoundTrip : public Scratch {
 protected:
  /// Writing what was read gives the same bytes: nothing is lost and nothing is added.
  template <typename Stage>
  void expect_same_bytes(const Stage& stage) {
    write_stage(path("first"), stage);
    const InputFile file = read_input(path("first"));
    write_stage(path("second"), read_stage<Stage>(file));
    EXPECT_EQ(bytes_of("first"), bytes_of("second"));
    EXPECT_GT(file.bytes.size(), 500u);
  }
  static void expect_same_regions(const CadFace& face, const CadFace& expected) {
    EXPECT_EQ(face.region_loops, expected.region_loops);
    EXPECT_EQ(face.region_names, expected.region_names);
    EXPECT_EQ(face.partners, expected.partners);
    ASSERT_EQ(face.periodic_pairs.size(), expected.periodic_pairs.size());
    for (std::size_t i = 0; i < face.periodic_pairs.size(); ++i) {
      EXPECT_EQ(face.periodic_pairs[i].curves, expected.periodic_pairs[i].curves);
      EXPECT_EQ(face.periodic_pairs[i].angle, expected.periodic_pairs[i].angle);
      EXPECT_EQ(face.periodic_pairs[i].shift, expected.periodic_pairs[i].shift);
    }
  }
};

}  // namespace quadrille::io
