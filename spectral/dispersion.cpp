#include "spectral/dispersion.h"

#include <limits>
#include <type_traits>

namespace abbe {

namespace {

double refractive_index(const ExaggeratedDispersion& law, double lambda_nm) {
  const double n =
      std::visit([&](const auto& one) { return abbe::refractive_index(one, lambda_nm); }, law.law);
  return law.n_d + law.factor * (n - law.n_d);
}

bool is_achromatic(const ExaggeratedDispersion& law) {
  return law.factor == 0.0 ||
         std::visit([](const auto& one) { return abbe::is_achromatic(one); }, law.law);
}

} // namespace

double refractive_index(const Dispersion& law, double lambda_nm) {
  return std::visit([&](const auto& one) { return refractive_index(one, lambda_nm); }, law);
}

bool is_achromatic(const Dispersion& law) {
  return std::visit([](const auto& one) { return is_achromatic(one); }, law);
}

double abbe_number(const Dispersion& law) {
  if (is_achromatic(law)) return std::numeric_limits<double>::infinity();
  return (refractive_index(law, kLineD_nm) - 1.0) /
         (refractive_index(law, kLineF_nm) - refractive_index(law, kLineC_nm));
}

Dispersion exaggerated(const Dispersion& law, double factor) {
  return std::visit(
      [&](const auto& one) -> Dispersion {
        using Law = std::decay_t<decltype(one)>;
        if constexpr (std::is_same_v<Law, ExaggeratedDispersion>)
          return ExaggeratedDispersion{one.law, one.n_d, factor};
        else
          return ExaggeratedDispersion{one, abbe::refractive_index(one, kLineD_nm), factor};
      },
      law);
}

} // namespace abbe
