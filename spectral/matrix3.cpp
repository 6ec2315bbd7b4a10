#include "spectral/matrix3.h"

#include <stdexcept>

namespace abbe {

Matrix3 diagonal(const Vector3& values) {
  Matrix3 m{};
  for (int i = 0; i < 3; ++i)
    m[i][i] = values[i];
  return m;
}

Vector3 multiply(const Matrix3& m, const Vector3& v) {
  Vector3 result{};
  for (int i = 0; i < 3; ++i)
    result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

Matrix3 multiply(const Matrix3& a, const Matrix3& b) {
  Matrix3 result{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      result[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return result;
}

Matrix3 inverse(const Matrix3& m) {
  // Indices taken cyclically give each cofactor its sign.
  Matrix3 adjugate{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      adjugate[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
    }
  const double determinant =
      m[0][0] * adjugate[0][0] + m[0][1] * adjugate[1][0] + m[0][2] * adjugate[2][0];
  if (determinant == 0.0) throw std::invalid_argument("the matrix has no inverse");
  for (Vector3& row : adjugate)
    for (double& value : row)
      value /= determinant;
  return adjugate;
}

} // namespace abbe
