#include "cli/overwrite.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::cli {
namespace {

namespace fs = std::filesystem;

class OverwriteTest : public testing::Test {
 protected:
  OverwriteTest() {
    std::string name = (fs::temp_directory_path() / "overwrite-XXXXXX").string();
    folder = mkdtemp(name.data());
    for (const char* file : {"a", "b"}) std::ofstream(folder / file) << file;
    fs::create_symlink("a", folder / "link");
  }
  ~OverwriteTest() override { fs::remove_all(folder); }
  std::string path(const std::string& name) const { return (folder / name).string(); }

  fs::path folder;
};

TEST_F(OverwriteTest, OtherFilesAndNewFilesAreWritten) {
  EXPECT_NO_THROW(refuse_to_overwrite({path("a")}, {path("b"), path("new"), "", "-"}));
  EXPECT_NO_THROW(refuse_to_overwrite({path("missing"), ""}, {path("missing")}));
  EXPECT_NO_THROW(refuse_to_overwrite({"/dev/null"}, {"/dev/null"}));
}

TEST_F(OverwriteTest, TwoOutputsAreTwoFiles) {
  EXPECT_NO_THROW(refuse_to_overwrite({}, {path("new"), path("b"), "-", "", ""}));
  EXPECT_NO_THROW(refuse_to_overwrite({}, {"/dev/null", "/dev/null"}));
  EXPECT_THROW(refuse_to_overwrite({}, {path("new"), path("./new")}), UsageError);
  EXPECT_THROW(refuse_to_overwrite({}, {path("a"), path("link")}), UsageError);
  EXPECT_THROW(refuse_to_overwrite({}, {"-", "-"}), UsageError);
  EXPECT_THROW(refuse_to_overwrite({}, {"no_such_file", "./no_such_file"}), UsageError);
}

TEST_F(OverwriteTest, AnInputIsRefusedByAnyOfItsNames) {
  for (const std::string& name :
       std::vector<std::string>{"a", "./a", "../" + folder.filename().string() + "/a", "link"}) {
    const std::string message = message_of<UsageError>([&] {
      refuse_to_overwrite({path("b"), path("a")}, {path("new"), path(name)});
    });
    EXPECT_EQ(message,
              path(name) + ": is the input " + path("a") + " and would be overwritten: give another output file");
  }
  EXPECT_THROW(refuse_to_overwrite({path("link")}, {path("a")}), UsageError);
}

}  // namespace
}  // namespace quadrille::cli
