#include "io/whole_file.hpp"

#include <sys/stat.h>

#include <thread>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "scratch.hpp"

namespace quadrille::io {

namespace {

class Input : public Scratch {
 protected:
  std::string refusal(const std::string& path) const {
    return message_of<FormatError>([&] { read_input(path); });
  }
};

TEST_F(Input, IsReadWholeWithItsDigest) {
  put("a", "abc");
  const InputFile file = read_input(path("a"));
  EXPECT_EQ(file.bytes, "abc");
  EXPECT_EQ(file.sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(file.digest("step").format, "step");
  const std::string large(300001, '\n');
  put("b", large);
  EXPECT_EQ(read_input(path("b")).bytes, large);
}

TEST_F(Input, OfUnknownLengthIsReadWhole) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  const std::string large(300001, 'x');
  std::thread writer([&] { put("pipe", large); });
  EXPECT_EQ(read_input(path("pipe")).bytes, large);
  writer.join();
}

TEST_F(Input, ThatIsNoneIsRefusedByName) {
  EXPECT_EQ(refusal(path("missing")), path("missing") + ": cannot be read: No such file or directory");
  EXPECT_EQ(refusal(path(".")), path(".") + ": is a directory, not a file");
  put("empty", "");
  EXPECT_EQ(refusal(path("empty")), path("empty") + ": is empty");
}

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
