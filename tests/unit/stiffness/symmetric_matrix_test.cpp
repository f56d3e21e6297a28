#include "stiffness/symmetric_matrix.hpp"

#include <gtest/gtest.h>

namespace quadrille::stiffness {
namespace {

TEST(SymmetricMatrix, IsMadeFromTheLowerTriangle) {
  Eigen::MatrixXd all(3, 3), lower(3, 3);
  all << 1, 2, 4, 2, 3, 5, 4, 5, 6;
  lower << 1, 7, 7, 2, 3, 7, 4, 5, 6;
  EXPECT_EQ(SymmetricMatrix(lower).dense(), all);
  EXPECT_EQ(SymmetricMatrix(lower).rows(), 3);
}

TEST(SymmetricMatrix, CanBeEmpty) { EXPECT_EQ(SymmetricMatrix().dense().size(), 0); }

}  // namespace
}  // namespace quadrille::stiffness
