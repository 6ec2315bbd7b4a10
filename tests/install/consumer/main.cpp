#include "geometry/world/world.h"
#include "spectral/glass.h"

#include <cmath>
#include <cstdio>

// The index that Schott's data sheet gives N-BK7 at the d line is 1.51680; and a world is made, so
// that Embree is linked too.
int main() {
  const abbe::Glass* glass = abbe::find_glass("N-BK7");
  if (glass == nullptr) return 1;
  const double index = abbe::refractive_index(glass->dispersion, 587.5618);
  const abbe::World world({}, 1.0);
  const bool right = std::abs(index - 1.51680) < 5e-6 && !world.closest({});
  if (!right) std::printf("n_d of N-BK7 is %.6f\n", index);
  return right ? 0 : 1;
}
