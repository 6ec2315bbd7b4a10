#include "core/bsdfs/dielectric.h"

#include "core/optics/fresnel.h"
#include "core/optics/thin_film.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace abbe {
namespace {

/// True when the medium has one index for all these bands.
bool alike(const double* n, int first, int last) {
  // Compare bits, since that works in whole registers. Equal indices have equal bits: none is 0.
  const auto bits = [n](int b) { return std::bit_cast<std::uint64_t>(n[b]); };
  std::uint64_t differing = 0;
  for (int b = first; b < last; ++b)
    differing |= bits(b) ^ bits(first);
  return differing == 0;
}

/// True when both media have one index for all the bands. Fresnel's equations then need to be
/// solved only once.
bool one_boundary(const Incidence& in) {
  const auto [first, last] = in.bands;
  // Where glass is, the outermost bands tell so at once.
  if (in.n_before[first] != in.n_before[last - 1] || in.n_after[first] != in.n_after[last - 1])
    return false;
  return alike(in.n_before, first, last) && alike(in.n_after, first, last);
}

/// Four bands, for one instruction to work on all. Arrays over bands are read and written in whole
/// groups of four, which their padding allows: what stands outside the range is of no use.
constexpr int kLanes = 4;
using Doubles = double __attribute__((vector_size(kLanes * sizeof(double))));
using Floats = float __attribute__((vector_size(kLanes * sizeof(float))));

template <class Lanes, class Value>
Lanes loaded(const Value* from) {
  Lanes lanes;
  static_assert(sizeof lanes == kLanes * sizeof(Value));
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

/// The numbers of the first bands of the groups that hold a range.
template <class Body>
void for_each_group(BandRange bands, Body&& body) {
  for (int group = bands.first & -kLanes; group < bands.last; group += kLanes)
    body(group);
}

Doubles square_root(const Doubles& x) {
  Doubles root;
  for (int i = 0; i < kLanes; ++i)
    root[i] = std::sqrt(x[i]);
  return root;
}

struct Parts {
  Floats reflected, transmitted;
};

/// What a boundary sends back and lets through in four bands: dielectric_fractions() in lanes.
template <bool kFresnel, Transport kTransport>
Parts parts(double cos_o, const Doubles& n_before, const Doubles& n_after) {
  const Doubles zero{}, one = zero + 1.0;
  const Doubles eta = n_after / n_before;
  const Doubles part2 = cos_o * cos_o + (eta - 1.0) * (eta + 1.0); // see refracted_part2()
  const auto passes = part2 > zero;
  Doubles reflected = one, transmitted = passes ? one : zero;
  if constexpr (kFresnel) {
    const Doubles part = square_root(passes ? part2 : zero); // eta cos t
    const Doubles s = (cos_o - part) / (cos_o + part);
    const Doubles across = eta * eta * cos_o;
    const Doubles p = (across - part) / (across + part);
    reflected = passes ? 0.5 * (s * s + p * p) : one;
    transmitted = 1.0 - reflected;
  }
  if constexpr (kTransport == Transport::radiance) {
    const Doubles inverse = n_before / n_after;
    transmitted = transmitted * (inverse * inverse);
  }
  return {__builtin_convertvector(reflected, Floats), __builtin_convertvector(transmitted, Floats)};
}

template <bool kFresnel, Transport kTransport>
void fill(const Dielectric& surface, const Incidence& in, const SpecularFactors& out) {
  const double cos_o = in.cos_o();
  const auto put = [&](int group, const Parts& p) {
    const Floats reflected = p.reflected * loaded<Floats>(surface.reflectivity.data() + group);
    const Floats transmitted = p.transmitted * loaded<Floats>(surface.transparency.data() + group);
    std::memcpy(out.reflected + group, &reflected, sizeof reflected);
    std::memcpy(out.transmitted + group, &transmitted, sizeof transmitted);
  };
  if (one_boundary(in)) {
    const Doubles zero{};
    const Parts same = parts<kFresnel, kTransport>(cos_o, zero + in.n_before[in.bands.first],
                                                   zero + in.n_after[in.bands.first]);
    for_each_group(in.bands, [&](int group) { put(group, same); });
    return;
  }
  for_each_group(in.bands, [&](int group) {
    put(group, parts<kFresnel, kTransport>(cos_o, loaded<Doubles>(in.n_before + group),
                                           loaded<Doubles>(in.n_after + group)));
  });
}

/// What passes straight on in four bands. The reflectance is fresnel_reflectance() in lanes.
Floats passed_straight(double cos_o, const Doubles& n_before, const Doubles& n_after) {
  const Doubles zero{}, one = zero + 1.0;
  const Doubles ratio = n_after / n_before, inverse = 1.0 / ratio;
  const Doubles eta = ratio < inverse ? inverse : ratio;
  const Doubles part2 = cos_o * cos_o + (eta - 1.0) * (eta + 1.0);
  const auto passes = part2 > zero;
  const Doubles cosine = square_root(passes ? part2 : zero) / eta;
  const Doubles cos_t = cosine < one ? cosine : one;
  const Doubles s = (cos_o - eta * cos_t) / (cos_o + eta * cos_t);
  const Doubles p = (eta * cos_o - cos_t) / (eta * cos_o + cos_t);
  return __builtin_convertvector(1.0 - (passes ? 0.5 * (s * s + p * p) : one), Floats);
}

void filmed(const Dielectric& surface, const Incidence& in, const SpecularFactors& out) {
  thin_film_reflectances(in.cos_o(), in.n_before, surface.film.optics(in), in.n_after,
                         {out.reflected, in.bands});
  for (int b = in.bands.first; b < in.bands.last; ++b) {
    const auto reflected = static_cast<double>(out.reflected[b]);
    const double ratio = in.transport == Transport::radiance ? in.n_before[b] / in.n_after[b] : 1.0;
    out.reflected[b] = static_cast<float>(reflected * static_cast<double>(surface.reflectivity[b]));
    out.transmitted[b] = static_cast<float>((1.0 - reflected) * ratio * ratio *
                                            static_cast<double>(surface.transparency[b]));
  }
}

void pass_film(const Dielectric& surface, const Incidence& in, float* transmittance) {
  const SurfaceOptics optics = surface.optics(in);
  SurfaceOptics reversed = optics;
  std::swap(reversed.n_before, reversed.n_after);
  for (int b = in.bands.first; b < in.bands.last; ++b) {
    const SurfaceOptics& thin_first = in.n_before[b] <= in.n_after[b] ? optics : reversed;
    transmittance[b] *= static_cast<float>(thin_first.fractions(b, in.cos_o()).transmitted *
                                           optics.transmission_scale(b));
  }
}

} // namespace

void Dielectric::specular(const Incidence& in, const SpecularFactors& out) const {
  if (film.present()) {
    filmed(*this, in, out);
    return;
  }
  if (in.transport == Transport::radiance)
    fresnel ? fill<true, Transport::radiance>(*this, in, out)
            : fill<false, Transport::radiance>(*this, in, out);
  else
    fresnel ? fill<true, Transport::flux>(*this, in, out)
            : fill<false, Transport::flux>(*this, in, out);
}

void Dielectric::pass_straight(const Incidence& in, float* transmittance) const {
  if (film.present()) {
    pass_film(*this, in, transmittance);
    return;
  }
  const auto multiply = [&](int group, const Floats& passed) {
    const Floats product = loaded<Floats>(transmittance + group) *
                           (passed * loaded<Floats>(transparency.data() + group));
    std::memcpy(transmittance + group, &product, sizeof product);
  };
  const Doubles zero{};
  const double cos_o = in.cos_o();
  if (!fresnel) {
    for_each_group(in.bands, [&](int group) { multiply(group, Floats{} + 1.0f); });
  } else if (one_boundary(in)) {
    const Floats same = passed_straight(cos_o, zero + in.n_before[in.bands.first],
                                        zero + in.n_after[in.bands.first]);
    for_each_group(in.bands, [&](int group) { multiply(group, same); });
  } else {
    for_each_group(in.bands, [&](int group) {
      multiply(group, passed_straight(cos_o, loaded<Doubles>(in.n_before + group),
                                      loaded<Doubles>(in.n_after + group)));
    });
  }
}

SurfaceOptics Dielectric::optics(const Incidence& in) const {
  SurfaceOptics optics;
  optics.n_before = in.n_before;
  optics.n_after = in.n_after;
  optics.film = film.optics(in);
  optics.fresnel = fresnel;
  optics.reflectivity = reflectivity.data();
  optics.transparency = transparency.data();
  return optics;
}

} // namespace abbe
