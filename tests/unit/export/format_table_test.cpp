#include "export/format_table.hpp"

#include <gtest/gtest.h>

#include <set>

#include "base/error.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(FormatTable, NamesAndEndingsAreUnique) {
  std::set<std::string_view> names, endings;
  for (const ExportFormat& format : export_formats()) {
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    if (!format.ending.empty()) {
      EXPECT_TRUE(endings.insert(format.ending).second) << format.ending;
    }
    EXPECT_FALSE(format.summary.empty());
    EXPECT_NE(format.write, nullptr);
  }
}

TEST(FormatTable, AFormatIsFoundByNameAndByEnding) {
  EXPECT_EQ(find_export_format("vtu-bezier")->name, "vtu-bezier");
  EXPECT_EQ(find_export_format("word"), nullptr);
  EXPECT_EQ(export_format_of("folder/a.msh")->name, "msh");
  EXPECT_EQ(export_format_of("case/system/blockMeshDict")->name, "blockmesh");
  EXPECT_EQ(export_format_of("a.txt"), nullptr);
}

TEST(FormatTable, EveryFormatWritesAMeshThatItSupports) {
  for (const ExportFormat& format : export_formats())
    EXPECT_FALSE(export_mesh(two_straight_quads(), format).bytes.empty()) << format.name;
}

TEST(FormatTable, FilesBesideTheMainOneAreThoseOfTheTable) {
  QuadMesh mesh = two_quads();
  mesh.face.curve_names[0] = "in & out";
  for (const ExportFormat& format : export_formats()) {
    std::set<std::string> declared;
    for (const SideName& side : format.side_names) declared.insert(side.ending);
    std::set<std::string> written;
    for (const SideFile& side : export_mesh(mesh, format).side_files) written.insert(side.name.ending);
    if (format.write_hex != nullptr)
      for (const SideFile& side : export_mesh(two_hexes({.order = 2}), format).side_files)
        written.insert(side.name.ending);
    for (const std::string& ending : written) EXPECT_EQ(declared.erase(ending), 1u) << format.name << ' ' << ending;
    EXPECT_TRUE(declared.empty()) << format.name << ' ' << *declared.begin();
  }
}

TEST(FormatTable, AnOrderOrFrameThatAFormatDoesNotSupportIsRefused) {
  QuadMesh mesh = two_quads();
  mesh.order = 11;
  try {
    export_mesh(mesh, *find_export_format("msh"));
    FAIL();
  } catch (const ComputeError& e) {
    EXPECT_STREQ(e.what(),
                 "the format msh supports quads up to order 10, this mesh has order 11: refine with a lower --order");
  }
  EXPECT_THROW(export_mesh(two_straight_quads(), *find_export_format("re2"), {.in_space = true}), UsageError);
  EXPECT_NO_THROW(export_mesh(two_straight_quads(), *find_export_format("msh"), {.in_space = true}));
}

std::string all_bytes(const Exported& exported) {
  std::string bytes = exported.bytes;
  for (const SideFile& side : exported.side_files) bytes += side.bytes;
  return bytes;
}

TEST(FormatTable, EveryFormatObeysUnitAndScale) {
  QuadMesh mesh = two_straight_quads();
  mesh.face.length_unit = "millimetre", mesh.face.metres_per_unit = 0.001;
  QuadMesh doubled = mesh;
  scale_lengths(doubled, {2, "unknown", 0});
  for (const ExportFormat& format : export_formats()) {
    const Exported whole = export_mesh(mesh, format), scaled = export_mesh(mesh, format, {.length = {"file", 2}});
    EXPECT_NE(all_bytes(scaled), all_bytes(whole)) << format.name;
    EXPECT_EQ(all_bytes(scaled), all_bytes(export_mesh(doubled, format))) << format.name;
    EXPECT_EQ(scaled.length.factor, 2);
    EXPECT_EQ(all_bytes(export_mesh(mesh, format, {.length = {"mm"}})), all_bytes(whole)) << format.name;
    EXPECT_EQ(export_mesh(mesh, format, {.length = {"m"}}).length.unit, "metre");
  }
}

TEST(FormatTable, HexahedraAreScaledWithTheirMotionsAndWrittenByFormatsThatHaveThem) {
  HexMesh mesh = two_hexes({.order = 2, .layers = 3});
  join_ends(mesh, 3);
  HexMesh doubled = mesh;
  scale_lengths(doubled, {2, "unknown", 0});
  for (const ExportFormat& format : export_formats()) {
    if (format.write_hex == nullptr) continue;
    const Exported scaled = export_mesh(mesh, format, {.length = {"file", 2}});
    EXPECT_EQ(scaled.bytes, export_mesh(doubled, format).bytes) << format.name;
    EXPECT_NE(scaled.bytes, export_mesh(mesh, format).bytes) << format.name;
    const ExportOptions in_metres{.length = {"m"}};
    EXPECT_EQ(export_mesh(mesh, format, in_metres).length.factor, 1e-3) << format.name;
  }
}

TEST(FormatTable, FormatsWithoutHexahedraNameThoseThatHaveThem) {
  const auto refusal = [](const char* format, const ExportOptions& options) -> std::string {
    try {
      export_mesh(two_hexes({}), *find_export_format(format), options);
      return "";
    } catch (const UsageError& e) {
      return e.what();
    }
  };
  const ExportOptions none, in_space{.in_space = true}, with_blocks{.block_groups = true};
  ExportOptions with_types;
  with_types.patch_types = {{"wall", "wall"}};
  EXPECT_NE(refusal("ism-v2", none).find("the format ism-v2 has no hexahedra: choose one of msh, msh22, vtu, "),
            std::string::npos);
  EXPECT_NE(refusal("msh", in_space).find("--frame 3d"), std::string::npos);
  EXPECT_NE(refusal("msh", with_blocks).find("--block-groups"), std::string::npos);
  EXPECT_NE(refusal("msh", with_types).find("--patch-type"), std::string::npos);
}

}  // namespace
}  // namespace quadrille::exports
