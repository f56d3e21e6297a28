#include <gtest/gtest.h>

#include <BRepTools.hxx>
#include <BinTools.hxx>
#include <sstream>

#include "../support/test_data.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "occ/occ_model.hpp"

namespace quadrille::occ {
namespace {

OccModel loaded(const std::string& bytes) { return occ_load(brep_format(), bytes, "a.brep"); }

TEST(OccLoadBrep, text_and_binary_files_are_read) {
  const OccModel model = loaded(test_bytes("bad/rectangle.brep"));
  EXPECT_EQ(model.num_faces, 1);
  EXPECT_EQ(model.length_unit, "unknown");
  std::ostringstream text, binary;
  BRepTools::Write(model.shape, text);
  BinTools::Write(model.shape, binary);
  for (const std::string& bytes : {text.str(), binary.str()}) EXPECT_EQ(loaded(bytes).num_faces, 1);
}

/// The kernel's reader would go on for as long as a count says.
TEST(OccLoadBrep, truncated_files_are_refused) {
  const std::string bytes = test_bytes("bad/rectangle.brep");
  for (const double part : {0.3, 0.6, 0.9}) {
    const auto length = static_cast<std::size_t>(part * static_cast<double>(bytes.size()));
    const std::string text = message_of<FormatError>([&] { loaded(bytes.substr(0, length)); });
    EXPECT_TRUE(text.starts_with("a.brep: the BREP file ")) << part << text;
  }
  EXPECT_EQ(message_of<FormatError>([&] { loaded(bytes.substr(0, bytes.size() / 2)); }),
            "a.brep: the BREP file is broken or truncated");
}

}  // namespace
}  // namespace quadrille::occ
