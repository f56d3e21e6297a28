#include "base/resources.hpp"

#include <gtest/gtest.h>

#include <cerrno>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille {
namespace {

TEST(Resources, ThoseThatAreExhaustedAreNamedWithTheirLimits) {
  EXPECT_NO_THROW(require_resources(ENOENT, "x.step"));
  EXPECT_EQ(message_of<ComputeError>([] { require_resources(EMFILE, "x.step: cannot be read"); }),
            "x.step: cannot be read: no more open files: raise their limit (ulimit -n)");
  EXPECT_EQ(message_of<ComputeError>([] { require_resources(EAGAIN, "cannot start a process"); }),
            "cannot start a process: no more processes: raise their limit (ulimit -u)");
  EXPECT_THROW(require_resources(ENOMEM, ""), ComputeError);
}

}  // namespace
}  // namespace quadrille
