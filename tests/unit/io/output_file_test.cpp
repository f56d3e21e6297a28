#include "io/output_file.hpp"

#include <sys/stat.h>

#include <thread>

#include "base/error.hpp"
#include "scratch.hpp"

namespace quadrille::io {
namespace {

class Output : public Scratch {};

TEST_F(Output, ReplacesAFileAndLeavesNothingElse) {
  write_output(path("a"), "old", false);
  write_output(path("a"), "new", true);
  EXPECT_EQ(bytes_of("a"), "new");
  EXPECT_EQ(num_files(), 1u);
}

TEST_F(Output, KeepsTheModeOfWhatItReplaces) {
  put("a", "old");
  ASSERT_EQ(chmod(path("a").c_str(), 0640), 0);
  write_output(path("a"), "new", false);
  struct stat status {};
  ASSERT_EQ(stat(path("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
}

TEST_F(Output, WritesThroughASymbolicLink) {
  put("real", "old");
  std::filesystem::create_symlink("real", path("link"));
  write_output(path("link"), "new", false);
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_EQ(bytes_of("real"), "new");
}

TEST_F(Output, WritesToAFifoDirectly) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = bytes_of("pipe"); });
  write_output(path("pipe"), "bytes", true);
  reader.join();
  EXPECT_EQ(got, "bytes");
  EXPECT_TRUE(std::filesystem::is_fifo(path("pipe")));
}

TEST_F(Output, ThatCannotBeWrittenIsAnOutputError) {
  EXPECT_THROW(write_output(path("no/folder"), "x", false), OutputError);
  EXPECT_THROW(write_output(path("."), "x", false), OutputError);
  EXPECT_THROW(write_output("/dev/full", "x", false), OutputError);
  EXPECT_EQ(num_files(), 0u);
}

TEST_F(Output, DevicesStayDevices) {
  write_output("/dev/null", "x", true);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(Output, ReportIsNestedByItsDots) {
  Report report;
  report.set("solve.residual", 1e-15);
  report.set("solve.unknowns", 42);
  report.set("bound", std::numeric_limits<double>::quiet_NaN());
  report.warn("W-X-001", "odd");
  write_report(path("r.json"), "tool", "1.2.3", report);
  EXPECT_EQ(bytes_of("r.json"),
            "{\n"
            "  \"tool\": \"tool\",\n"
            "  \"version\": \"1.2.3\",\n"
            "  \"solve\": {\"residual\": 1e-15, \"unknowns\": 42},\n"
            "  \"bound\": null,\n"
            "  \"warnings\": [{\"code\": \"W-X-001\", \"message\": \"odd\"}]\n"
            "}\n");
}

}  // namespace
}  // namespace quadrille::io
