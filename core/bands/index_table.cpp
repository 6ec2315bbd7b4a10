#include "core/bands/index_table.h"

namespace abbe {

IndexTable::IndexTable(const Dispersion& law, bool keep_constant)
    : achromatic_(is_achromatic(law)) {
  if (achromatic_ && keep_constant) {
    samples_.push_back(refractive_index(law, 0.5 * (kLowerNm + kUpperNm)));
    return;
  }
  for (int i = 0; kLowerNm + i * kStepNm <= kUpperNm; ++i)
    samples_.push_back(refractive_index(law, kLowerNm + i * kStepNm));
}

} // namespace abbe
