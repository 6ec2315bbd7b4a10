#include "io/building/fingerprint.h"

#include <functional>
#include <variant>

namespace abbe {
namespace {

/// Gathers numbers, in order.
class Mixer {
public:
  template <class Value>
  Mixer& add(const Value& value) {
    constexpr std::size_t kGolden = 0x9e3779b97f4a7c15; // 2^64 divided by the golden ratio
    sum_ ^= std::hash<Value>{}(value) + kGolden + (sum_ << 6) + (sum_ >> 2);
    return *this;
  }

  Mixer& add(const Curve& curve) {
    if (const auto constant = curve.constant_value()) return add(*constant);
    for (const SpectralLine& line : curve.spectral_lines())
      add(line.nm).add(line.power);
    for (double nm = 400.0; nm <= 750.0; nm += 50.0)
      add(curve.at(nm));
    return *this;
  }

  Mixer& add(const Dispersion& law) {
    add(law.index());
    for (const double nm : {400.0, 550.0, 700.0})
      add(refractive_index(law, nm));
    return *this;
  }

  Mixer& add(const MaterialId& id) { return add(id.value); }

  Mixer& add(const CheckerTexture& t) { return add(t.across).add(t.up).add(t.first).add(t.second); }
  Mixer& add(const GridTexture& t) {
    return add(t.across).add(t.up).add(t.width).add(t.lines).add(t.fields);
  }
  Mixer& add(const ImageTexture& t) { return add(t.image); }

  [[nodiscard]] std::size_t sum() const { return sum_; }

private:
  std::size_t sum_ = 0;
};

} // namespace

std::size_t fingerprint(const Material& m) {
  Mixer mixer;
  mixer.add(m.name).add(m.ambient).add(m.diffuse).add(m.specular).add(m.emission);
  mixer.add(m.reflectivity).add(m.transparency).add(m.specular_exponent).add(m.roughness);
  if (m.metal) mixer.add(m.metal->n).add(m.metal->k);
  if (m.texture) std::visit([&](const auto& texture) { mixer.add(texture); }, *m.texture);
  if (m.mixture) mixer.add(m.mixture->first).add(m.mixture->second).add(m.mixture->share);
  if (m.film) mixer.add(m.film->thickness_nm).add(m.film->index);
  if (m.coat) mixer.add(*m.coat);
  if (m.pane) mixer.add(m.pane->thickness_mm).add(m.pane->index).add(m.pane->absorption_per_mm);
  return mixer.sum();
}

std::size_t fingerprint(const Medium& m) {
  Mixer mixer;
  mixer.add(m.name).add(m.index).add(m.absorption_per_mm);
  if (m.drops) mixer.add(m.drops->extinction_per_mm).add(m.drops->index);
  return mixer.sum();
}

} // namespace abbe
