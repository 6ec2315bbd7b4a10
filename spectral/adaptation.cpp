#include "spectral/adaptation.h"

#include <stdexcept>

namespace abbe {
namespace {

// Bradford's cone responses of XYZ. [Lam85, ICC2010 annex E]
constexpr Matrix3 kBradford{
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

// CAT16's. [Li17]
constexpr Matrix3 kCat16{{{0.401288, 0.650173, -0.051461},
                          {-0.250268, 1.204414, 0.045854},
                          {-0.002079, 0.048952, 0.953127}}};

const Matrix3& cones_of(AdaptationMethod method) {
  switch (method) {
  case AdaptationMethod::bradford:
    return kBradford;
  case AdaptationMethod::cat16:
    return kCat16;
  }
  return kBradford;
}

Vector3 responses(const Xyz& white, const Matrix3& matrix) {
  const Vector3 cones = multiply(matrix, Vector3{white.x, white.y, white.z});
  for (const double response : cones)
    if (!(response > 0.0)) throw std::invalid_argument("no eye can take this for white");
  return cones;
}

} // namespace

Matrix3 adaptation(const Xyz& from, const Xyz& to, AdaptationMethod method) {
  if (from == to) return diagonal({1.0, 1.0, 1.0});
  const Matrix3& cones = cones_of(method);
  const Vector3 source = responses(from, cones), target = responses(to, cones);
  const Matrix3 scale =
      diagonal({target[0] / source[0], target[1] / source[1], target[2] / source[2]});
  return multiply(inverse(cones), multiply(scale, cones));
}

Matrix3 bradford_adaptation(const Xyz& from, const Xyz& to) {
  return adaptation(from, to, AdaptationMethod::bradford);
}

Xyz transformed(const Matrix3& matrix, const Xyz& color) {
  const Vector3 xyz = multiply(matrix, Vector3{color.x, color.y, color.z});
  return {xyz[0], xyz[1], xyz[2]};
}

} // namespace abbe
