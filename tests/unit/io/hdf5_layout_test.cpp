#include "io/hdf5_layout.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "../region_samples.hpp"
#include "base/error.hpp"
#include "io/digest.hpp"
#include "io/stage_files.hpp"

namespace quadrille::io {

namespace {

/// The image of a stage file, without its checksum.
std::string image_of(const StageModel& stage) {
  std::string bytes = stage_bytes(stage);
  bytes.resize(bytes.size() - checksum_size);
  return bytes;
}

/// The image with a number of 8 bytes at that place.
std::string with_number(std::string image, std::size_t at, std::uint64_t number) {
  std::memcpy(image.data() + at, &number, sizeof number);
  return image;
}

std::uint64_t number_in(const std::string& image, std::size_t at) {
  std::uint64_t number = 0;
  std::memcpy(&number, image.data() + at, sizeof number);
  return number;
}

const std::string image = image_of(samples::tri_mesh());

TEST(Hdf5Layout, IsThatOfOurFiles) {
  for (const StageModel& stage :
       {StageModel(samples::tri_mesh()), StageModel(samples::field()), StageModel(samples::phase_field()),
        StageModel(samples::block_layout()), StageModel(samples::quad_mesh()), StageModel(samples::two_regions_mesh())})
    EXPECT_TRUE(has_own_layout(image_of(stage))) << stage.index();
}

TEST(Hdf5Layout, NoneOfOtherBytes) {
  EXPECT_FALSE(has_own_layout(""));
  EXPECT_FALSE(has_own_layout("\x89HDF\r\n\x1a\n"));
  EXPECT_FALSE(has_own_layout(image + '\0'));
  for (std::size_t size = 0; size < image.size(); size += 97)
    EXPECT_FALSE(has_own_layout(image.substr(0, size))) << size;
}

TEST(Hdf5Layout, StructuresLieInsideAndAreReferredToOnce) {
  const std::size_t first_name = image.find("SNOD") + 8, first_object = first_name + 8, heap = image.find("HEAP");
  const std::uint64_t root = number_in(image, 64);
  EXPECT_FALSE(has_own_layout(with_number(image, first_object, root))) << "a cycle";
  EXPECT_FALSE(has_own_layout(with_number(image, first_object, number_in(image, first_object + 40)))) << "twice";
  EXPECT_FALSE(has_own_layout(with_number(image, first_object, image.size() - 8)));
  EXPECT_FALSE(has_own_layout(with_number(image, first_name, number_in(image, heap + 8)))) << "a name outside";
  EXPECT_FALSE(has_own_layout(with_number(image, heap + 8, image.size()))) << "a heap beyond the file";
  EXPECT_FALSE(has_own_layout(with_number(image, heap + 24, ~std::uint64_t{0} - 7)));
}

TEST(Hdf5Layout, SizesAreThoseOfShapeAndType) {
  const std::string space("\x01\x01\x01\0\0\0\0\0", 8);  // of one dimension, with its greatest extent
  std::size_t num_changed = 0;
  for (std::size_t at = image.find(space); at != std::string::npos; at = image.find(space, at + 1), ++num_changed)
    for (const std::uint64_t extent : {std::uint64_t{1} << 31, number_in(image, at + 8) + 1000, ~std::uint64_t{0}})
      EXPECT_FALSE(has_own_layout(with_number(with_number(image, at + 8, extent), at + 16, extent))) << at;
  EXPECT_GT(num_changed, 5U);
}

// The claim itself: what has the layout is read in this process, without a crash, or refused.
TEST(Hdf5Layout, LibhdfReadsEveryImageThatHasIt) {
  std::mt19937 random(1);
  int num_read = 0;
  for (std::size_t at = 8; at < image.size(); at += 5) {
    std::string damaged = image;
    damaged[at] = static_cast<char>(random() % 4 == 0 ? random() : damaged[at] ^ (1 << random() % 8));
    if (!has_own_layout(damaged)) continue;
    append_checksum(damaged);
    try {
      read_any_stage({{"file", ""}, damaged});
    } catch (const FormatError&) {
    }
    ++num_read;
  }
  EXPECT_GT(num_read, 200);
}

}  // namespace

}  // namespace quadrille::io
