#include "core/bands/index_table.h"

namespace abbe {

std::size_t IndexTable::count(const Dispersion& law, bool keep_constant) {
  if (is_achromatic(law) && keep_constant) return 1;
  return 1 + static_cast<std::size_t>((kUpperNm - kLowerNm) / kStepNm);
}

IndexTable::IndexTable(const Dispersion& law, bool keep_constant)
    : achromatic_(is_achromatic(law)) {
  if (achromatic_ && keep_constant) {
    samples_.push_back(refractive_index(law, 0.5 * (kLowerNm + kUpperNm)));
    return;
  }
  samples_.reserve(count(law, keep_constant));
  for (int i = 0; kLowerNm + i * kStepNm <= kUpperNm; ++i)
    samples_.push_back(refractive_index(law, kLowerNm + i * kStepNm));
}

} // namespace abbe
