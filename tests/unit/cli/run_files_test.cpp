#include "cli/run_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"

namespace quadrille::cli {
namespace {

namespace fs = std::filesystem;

class RunFilesTest : public testing::Test {
 protected:
  RunFilesTest() {
    std::string name = (fs::temp_directory_path() / "run-files-XXXXXX").string();
    folder = mkdtemp(name.data());
    for (const char* file : {"a", "b"}) std::ofstream(folder / file) << file;
    fs::create_symlink("a", folder / "link");
  }
  ~RunFilesTest() override { fs::remove_all(folder); }
  std::string path(const std::string& name) const { return (folder / name).string(); }

  /// The message that the files are refused with; empty if they are not.
  static std::string refusal(const std::vector<std::string>& read, const std::vector<std::string>& written) {
    RunFiles files;
    for (const std::string& one : read) files.read(one);
    for (std::size_t i = 0; i < written.size(); ++i) files.write(written[i], "--out" + std::to_string(i));
    try {
      files.require_distinct();
    } catch (const UsageError& e) {
      return e.what();
    }
    return "";
  }

  fs::path folder;
};

TEST_F(RunFilesTest, OtherFilesAndNewFilesAreWritten) {
  EXPECT_EQ(refusal({path("a")}, {path("b"), path("new"), "", "-"}), "");
  EXPECT_EQ(refusal({path("missing"), ""}, {path("missing")}), "");
  EXPECT_EQ(refusal({"/dev/null"}, {"/dev/null"}), "");
}

TEST_F(RunFilesTest, TwoOutputsAreTwoFiles) {
  EXPECT_EQ(refusal({}, {path("new"), path("b"), "-", "", ""}), "");
  EXPECT_EQ(refusal({}, {"/dev/null", "/dev/null"}), "");
  EXPECT_EQ(refusal({}, {path("new"), path("./new")}),
            path("./new") + ": would be written twice, by --out0 and by --out1: give two names");
  EXPECT_NE(refusal({}, {path("a"), path("link")}), "");
  EXPECT_EQ(refusal({}, {"-", "-"}),
            "--out0 and --out1 cannot both go to standard output: name a file for one of them");
  EXPECT_NE(refusal({}, {"no_such_file", "./no_such_file"}), "");
}

TEST_F(RunFilesTest, AnInputIsRefusedByAnyOfItsNames) {
  for (const std::string& name :
       std::vector<std::string>{"a", "./a", "../" + folder.filename().string() + "/a", "link"})
    EXPECT_EQ(refusal({path("b"), path("a")}, {path("new"), path(name)}),
              path(name) + ": is the input " + path("a") + ", which --out1 would overwrite: give another file");
  EXPECT_NE(refusal({path("link")}, {path("a")}), "");
}

TEST_F(RunFilesTest, FilesAreTheSameByWhateverName) {
  EXPECT_TRUE(are_same_file(path("a"), path("link")));
  EXPECT_TRUE(are_same_file(path("a"), path("./a")));
  EXPECT_FALSE(are_same_file(path("a"), path("b")));
  EXPECT_TRUE(are_same_file(path("none"), path("./none"))) << "neither exists";
  EXPECT_FALSE(are_same_file(path("a"), path("none")));
}

}  // namespace
}  // namespace quadrille::cli
