#include "chain/stage_file.hpp"

#include <gtest/gtest.h>

#include "../samples.hpp"
#include "base/error.hpp"
#include "temporary_folder.hpp"

namespace quadrille::chain {
namespace {

TEST(StageFile, keeps_a_struct_in_memory_until_its_file_is_needed) {
  const TemporaryFolder folder;
  StageFile<TriMesh> file(folder.file("x.tri.h5"));
  EXPECT_FALSE(file.is_in_memory());
  EXPECT_THROW(file.input(), FormatError);
  file.set(samples::tri_mesh(), false);
  EXPECT_TRUE(file.is_in_memory());
  EXPECT_FALSE(folder.has("x.tri.h5"));
  EXPECT_EQ(file.input().file.sha256, "") << "not known";
  file.write();
  EXPECT_EQ(file.input().file.sha256, io::read_input(file.path()).sha256);
  EXPECT_EQ(file.input().file.name, file.path());
}

TEST(StageFile, reads_what_another_program_wrote) {
  const TemporaryFolder folder;
  StageFile<TriMesh> file(folder.file("x.tri.h5"));
  file.set(samples::tri_mesh(), true);
  TriMesh other = samples::tri_mesh();
  other.face.name = "other";
  io::write_stage(file.path(), other);
  EXPECT_EQ(file.model().face.name, "square");
  file.forget();
  EXPECT_EQ(file.model().face.name, "other");
  EXPECT_EQ(file.input().file.sha256, io::read_input(file.path()).sha256);
}

TEST(StageFile, releases_its_struct) {
  const TemporaryFolder folder;
  StageFile<TriMesh> file(folder.file("x.tri.h5"));
  file.set(samples::tri_mesh(), true);
  EXPECT_EQ(file.release().face.name, "square");
  EXPECT_FALSE(file.is_in_memory());
  EXPECT_EQ(file.release().face.name, "square") << "from the file";
}

TEST(StageFile, a_struct_of_another_file_has_its_name_and_digest) {
  const TemporaryFolder folder;
  StageFile<TriMesh> file(folder.file("x.tri.h5"));
  const std::string bytes = io::stage_bytes(samples::tri_mesh());
  file.read({{"other.h5", "digest"}, bytes});
  EXPECT_EQ(file.input().file.name, "other.h5");
  EXPECT_EQ(file.input().file.sha256, "digest");
  EXPECT_EQ(file.path(), folder.file("x.tri.h5"));
  StageFile<TriMesh> taking(folder.file("y.tri.h5"));
  taking.take(file);
  EXPECT_FALSE(file.is_in_memory());
  EXPECT_EQ(taking.input().file.sha256, "digest");
  EXPECT_EQ(taking.input().file.name, folder.file("y.tri.h5"));
}

}  // namespace
}  // namespace quadrille::chain
