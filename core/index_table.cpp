#include "core/index_table.h"

namespace abbe {

IndexTable::IndexTable(const Dispersion& law) {
  if (is_achromatic(law)) {
    samples_.push_back(refractive_index(law, 0.5 * (kLowerNm + kUpperNm)));
    return;
  }
  for (int i = 0; kLowerNm + i * kStepNm <= kUpperNm; ++i)
    samples_.push_back(refractive_index(law, kLowerNm + i * kStepNm));
}

} // namespace abbe
