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

TEST(SameOrigin, OneChainMustHoldTheOthersDigest) {
  const InputFile field{"a.field.h5", "", "f1"}, points{"a.crit.json", "", "c1"}, other{"b.crit.json", "", "c2"};
  const Provenance before{{"padapt", "1", {{"field", "f0"}}, "{}"}};
  const Provenance after{{"padapt", "1", {{"field", "f0"}}, "{}"}, {"critpoints", "1", {{"field", "f1"}}, "{}"}};
  EXPECT_NO_THROW(require_same_origin(field, before, points, after));
  EXPECT_NO_THROW(require_same_origin(points, after, field, before));
  EXPECT_THROW(require_same_origin(field, before, other, before), FormatError);
}

}  // namespace
}  // namespace quadrille::io
