#include "spectral/matrix3.h"
#include "tests/catch.h"

#include <stdexcept>

using namespace abbe;

TEST_CASE("The inverse of a matrix undoes it") {
  const Matrix3 m = {{{2, 1, 0}, {-1, 3, 4}, {5, 0, 1}}};
  // By hand: determinant 2 (3 - 0) - 1 (-1 - 20) = 27, adjugate as below.
  const Matrix3 adjugate = {{{3, -1, 4}, {21, 2, -8}, {-15, 5, 7}}};
  const Matrix3 found = inverse(m);
  const Matrix3 unit = multiply(m, found);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      CHECK(found[i][j] == Approx(adjugate[i][j] / 27.0));
      CHECK(unit[i][j] == Approx(i == j ? 1.0 : 0.0).margin(1e-15));
    }
}

TEST_CASE("A matrix times a vector, and a diagonal matrix") {
  CHECK(multiply(Matrix3{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}, Vector3{1, 10, 100}) ==
        Vector3{321, 654, 987});
  CHECK(multiply(diagonal({2, 3, 4}), Vector3{1, 1, 1}) == Vector3{2, 3, 4});
}

TEST_CASE("A singular matrix has no inverse") {
  CHECK_THROWS_AS(inverse(Matrix3{{{1, 2, 3}, {2, 4, 6}, {0, 0, 1}}}), std::invalid_argument);
}
