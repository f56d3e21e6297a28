#include "io/input_file.hpp"

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

}  // namespace
}  // namespace quadrille::io
