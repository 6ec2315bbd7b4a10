#include "core/optics/dielectric_facets.h"

#include "core/optics/diffuse_fresnel.h"
#include "core/optics/fresnel.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

/// One lobe in one band: the BSDF times cosine, the pdf with which the lobe picks `wi` once the
/// side is chosen, and the fractions by which the side is chosen.
struct Lobe {
  double value = 0.0, pdf = 0.0;
  Fractions fractions{0.0, 0.0};
};

/// The lobes of light that meets one facet, chosen with probability `chance_of_one`, or several.
struct Lobes {
  Lobe one, several;
  double chance_of_one = 1.0;
};

/// The light that leaves after several facets, split between the sides. With E the albedo of one
/// interaction and T the mean transmittance, from the side before and, with a prime, from behind,
///   f_r = r (1 - E(wo)) (1 - E(wi)) / (pi (1 - mean E)),
///   f_t = t (1 - E(wo)) (1 - E'(wi)) / (pi (1 - mean E'))   with r + t = 1
/// conserve energy, and are reciprocal when t / t' = n'^2 (1 - mean E') / (n^2 (1 - mean E)). Since
/// n^2 T = n'^2 T', t = T (1 - mean E') / max(1 - mean E, 1 - mean E') does both.
struct Several {
  EtaPlace eta;
  double kept_before, kept_behind; ///< 1 - mean E on either side
  Fractions shares{1.0, 0.0};      ///< r and t

  Several(const DielectricAlbedo& albedo, double ratio) : eta(albedo.place(ratio)) {
    kept_before = 1.0 - albedo.mean_scattered(eta);
    kept_behind = 1.0 - albedo.mean_scattered(DielectricAlbedo::reversed(eta));
    const double larger = std::max(kept_before, kept_behind);
    if (!(larger > 0.0)) return;
    shares.transmitted = diffuse_transmittance(ratio) * kept_behind / larger;
    shares.reflected = 1.0 - shares.transmitted;
  }
};

/// Evaluates the lobes in one band after another; holds what does not depend on the band.
class Evaluation {
public:
  Evaluation(const DielectricFacets& surface, const SurfaceOptics& optics, const dvec3& wo,
             const dvec3& wi)
      : surface_(surface), optics_(optics), wo_(wo), wi_(wi),
        seen_(surface.ggx.g2(wo, wi) / surface.ggx.g1(wo)), place_o_(CosineTable::place(wo.z)),
        place_i_(CosineTable::place(std::abs(wi.z))) {
    if (reflects()) {
      half_ = glm::normalize(wo + wi);
      half_pdf_ = surface.ggx.visible_pdf(wo, half_);
    }
  }
  [[nodiscard]] bool reflects() const { return wi_.z > 0.0; }

  /// The lobes in a band, for flux, without the material's reflectivity and transparency.
  [[nodiscard]] Lobes lobes(int b) const {
    Lobes both;
    both.one = reflects() ? reflection(b) : transmission(b);
    if (surface_.compensation) add_several(b, both);
    return both;
  }

private:
  [[nodiscard]] Lobe reflection(int b) const {
    const double along = glm::dot(wo_, half_);
    const Fractions f = optics_.fractions(b, along);
    const double pdf = half_pdf_ / (4.0 * along);
    return {f.reflected * seen_ * pdf, pdf, f};
  }

  [[nodiscard]] Lobe transmission(int b) const {
    const double n_o = optics_.n_before[b], n_i = optics_.n_after[b];
    dvec3 h = n_o * wo_ + n_i * wi_;
    const double length = glm::length(h);
    if (length == 0.0) return {};
    h /= h.z < 0.0 ? -length : length;
    const double o = glm::dot(wo_, h), i = glm::dot(wi_, h);
    if (!(o > 0.0 && i < 0.0)) return {};
    const Fractions f = optics_.fractions(b, o);
    // |n_o (wo . h) + n_i (wi . h)| is the length of h before normalization.
    const double pdf = surface_.ggx.visible_pdf(wo_, h) * -i * n_i * n_i / (length * length);
    return {f.transmitted * seen_ * pdf, pdf, f};
  }

  void add_several(int b, Lobes& both) const {
    const DielectricAlbedo& albedo = *surface_.compensation;
    const Several several(albedo, optics_.n_after[b] / optics_.n_before[b]);
    both.chance_of_one = albedo.scattered(several.eta, place_o_);
    both.several.fractions = several.shares;
    both.several.pdf = std::abs(wi_.z) / std::numbers::pi;
    const double kept = reflects() ? several.kept_before : several.kept_behind;
    if (!(kept > 0.0)) return;
    const EtaPlace side = reflects() ? several.eta : DielectricAlbedo::reversed(several.eta);
    both.several.value = (1.0 - both.chance_of_one) * (1.0 - albedo.scattered(side, place_i_)) /
                         kept * both.several.pdf *
                         (reflects() ? several.shares.reflected : several.shares.transmitted);
  }

  const DielectricFacets& surface_;
  const SurfaceOptics& optics_;
  dvec3 wo_, wi_;
  double seen_; ///< G2 / G1(wo)
  TablePlace place_o_, place_i_;
  dvec3 half_{0.0, 0.0, 1.0};
  double half_pdf_ = 0.0;
};

/// The probability that a lobe chooses reflection or, with `reflects` false, transmission.
double chance(const Fractions& f, const SurfaceOptics& optics, int b, bool reflects) {
  const double r = f.reflected * optics.reflection_scale(b);
  const double t = f.transmitted * optics.transmission_scale(b);
  return r + t > 0.0 ? (reflects ? r : t) / (r + t) : 0.0;
}

} // namespace

double evaluate_dielectric_facets(const DielectricFacets& surface, const SurfaceOptics& optics,
                                  const dvec3& wo, const dvec3& wi, const BandSet& bands,
                                  float* f_cos) {
  for (int b = bands.first; b < bands.last; ++b)
    f_cos[b] = 0.0f;
  if (wi.z == 0.0) return 0.0;
  const Evaluation evaluation(surface, optics, wo, wi);
  const bool reflects = evaluation.reflects();
  const bool alike = optics.alike(bands.first, bands.last);
  Lobes lobes;
  if (alike) lobes = evaluation.lobes(bands.first);
  double pdf = 0.0;
  int count = 0;
  for (int b = bands.first; b < bands.last; ++b) {
    if (!bands.has(b)) continue;
    if (!alike) lobes = evaluation.lobes(b);
    const Lobe &one = lobes.one, &several = lobes.several;
    double scale = reflects ? optics.reflection_scale(b) : optics.transmission_scale(b);
    if (!reflects && surface.transport == Transport::radiance) {
      const double ratio = optics.n_before[b] / optics.n_after[b];
      scale *= ratio * ratio;
    }
    f_cos[b] = static_cast<float>(scale * (one.value + several.value));
    pdf +=
        lobes.chance_of_one * chance(one.fractions, optics, b, reflects) * one.pdf +
        (1.0 - lobes.chance_of_one) * chance(several.fractions, optics, b, reflects) * several.pdf;
    ++count;
  }
  return count > 0 ? pdf / count : 0.0;
}

std::optional<dvec3> sample_dielectric_facets(const DielectricFacets& surface,
                                              const SurfaceOptics& optics, const dvec3& wo, int b,
                                              const dvec2& u, double choice) {
  const double eta = optics.n_after[b] / optics.n_before[b];
  if (surface.compensation) {
    const Several several(*surface.compensation, eta);
    const double one = surface.compensation->scattered(several.eta, CosineTable::place(wo.z));
    if (choice >= one) {
      const double rest = (choice - one) / (1.0 - one);
      const dvec3 wi = sample_cosine_hemisphere(u);
      return rest < chance(several.shares, optics, b, true) ? wi : dvec3{wi.x, wi.y, -wi.z};
    }
    choice /= one;
  }
  const dvec3 h = surface.ggx.sample_visible_normal(wo, u);
  const double along = glm::dot(wo, h);
  const Fractions f = optics.fractions(b, along);
  if (choice < chance(f, optics, b, true)) {
    const dvec3 wi = reflected(-wo, h);
    if (!(wi.z > 0.0)) return std::nullopt;
    return wi;
  }
  const auto cos_t = refracted_cosine(along, eta);
  if (!cos_t) return std::nullopt;
  const dvec3 wi = refracted(-wo, h, along, *cos_t, eta);
  if (!(wi.z < 0.0)) return std::nullopt;
  return wi;
}

} // namespace abbe
