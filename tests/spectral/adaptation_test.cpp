#include "spectral/adaptation.h"
#include "tests/catch.h"

#include <stdexcept>

using namespace abbe;

TEST_CASE("Bradford from D65 to D50 is the published matrix") {
  // B. Lindbloom's table, of the whites of ASTM E308: D65 0.95047 1 1.08883, D50 0.96422 1 0.82521.
  const Matrix3 m = bradford_adaptation({0.95047, 1.0, 1.08883}, {0.96422, 1.0, 0.82521});
  const Matrix3 published{{{1.0478112, 0.0228866, -0.0501270},
                           {0.0295424, 0.9904844, -0.0170491},
                           {-0.0092345, 0.0150436, 0.7521316}}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      CHECK(m[i][j] == Approx(published[i][j]).margin(1e-7));
}

TEST_CASE("CAT16 from illuminant A to D65") {
  // Worked out by hand, in fractions, from the matrix in [Li17]; each of its rows sums to 1.
  const Matrix3 m = adaptation(to_xyz(Chromaticity{0.44758, 0.40745}, 1.0),
                               to_xyz(Chromaticity{0.3127, 0.3290}, 1.0), AdaptationMethod::cat16);
  const Matrix3 expected{{{0.9506814642, -0.1874060997, 0.2629224878},
                          {-0.0256698866, 1.0323135659, -0.0115667695},
                          {-0.0027424281, 0.0910143911, 2.8135491680}}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(m[i][j] == Approx(expected[i][j]).margin(1e-9));
}

TEST_CASE("Adaptation takes white to white, and back") {
  const Xyz a{1.0985, 1.0, 0.35585}, d65{0.95047, 1.0, 1.08883};
  const Xyz white = transformed(bradford_adaptation(a, d65), a);
  CHECK(white.x == Approx(d65.x).epsilon(1e-13));
  CHECK(white.y == Approx(d65.y).epsilon(1e-13));
  CHECK(white.z == Approx(d65.z).epsilon(1e-13));
  const Xyz color{0.3, 0.4, 0.1};
  const Xyz back =
      transformed(bradford_adaptation(d65, a), transformed(bradford_adaptation(a, d65), color));
  CHECK(back.x == Approx(color.x).epsilon(1e-13));
  CHECK(back.y == Approx(color.y).epsilon(1e-13));
  CHECK(back.z == Approx(color.z).epsilon(1e-13));
}

TEST_CASE("The same white changes nothing, to the last bit") {
  const Xyz d65{0.95047, 1.0, 1.08883}, color{0.3, 0.4, 0.1};
  CHECK(transformed(bradford_adaptation(d65, d65), color) == color);
}

TEST_CASE("What no eye takes for white is refused") {
  CHECK_THROWS_AS(bradford_adaptation(to_xyz(Chromaticity{0.1, 0.01}, 1.0), {1, 1, 1}),
                  std::invalid_argument);
  CHECK_THROWS_AS(bradford_adaptation({0, 0, 0}, {1, 1, 1}), std::invalid_argument);
}
