#pragma once

#include <array>

namespace abbe {

using Vector3 = std::array<double, 3>;

/// A 3 x 3 matrix, row major: `m[row][column]`. It maps one colour triple to another.
using Matrix3 = std::array<Vector3, 3>;

/// The matrix with `values` on its diagonal and 0 elsewhere.
[[nodiscard]] Matrix3 diagonal(const Vector3& values);

[[nodiscard]] Vector3 multiply(const Matrix3& m, const Vector3& v);
[[nodiscard]] Matrix3 multiply(const Matrix3& a, const Matrix3& b);

/// The inverse by cofactors. Throws std::invalid_argument when the determinant is 0.
[[nodiscard]] Matrix3 inverse(const Matrix3& m);

} // namespace abbe
