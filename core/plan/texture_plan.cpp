#include "core/plan/texture_plan.h"

#include "spectral/rgb_spectrum.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abbe {
namespace {

/// The number of the field, and the place in it from 0 to 1.
struct Field {
  double number, place;
};

Field field_of(double coordinate, double fields) {
  const double x = coordinate * fields;
  const double number = std::floor(x);
  return {number, x - number};
}

const BandTable& reflectance(const CheckerPlan& checker, const TexturePlans&, const dvec2& uv,
                             BandTable&) {
  const double sum = field_of(uv.x, checker.across).number + field_of(uv.y, checker.up).number;
  return std::fmod(sum, 2.0) == 0.0 ? checker.first : checker.second;
}

const BandTable& reflectance(const GridPlan& grid, const TexturePlans&, const dvec2& uv,
                             BandTable&) {
  const auto on_line = [&](double coordinate, double fields) {
    const double place = field_of(coordinate, fields).place;
    return std::min(place, 1.0 - place) < grid.half_width;
  };
  return on_line(uv.x, grid.across) || on_line(uv.y, grid.up) ? grid.lines : grid.fields;
}

const BandTable& reflectance(const ImagePlan& plan, const TexturePlans& plans, const dvec2& uv,
                             BandTable& scratch) {
  plans.lattice.front().evaluate(color_at(plans.images[plan.image], uv), scratch);
  return scratch;
}

/// The two texels around a place on an axis of `count` texels, and the share of the second.
struct Neighbours {
  std::size_t first, second;
  float share;
};

Neighbours neighbours(double place, int count) {
  const double x = std::clamp(place * count - 0.5, 0.0, count - 1.0);
  const auto first = static_cast<std::size_t>(x);
  return {first, std::min(first + 1, static_cast<std::size_t>(count) - 1),
          static_cast<float>(x - std::floor(x))};
}

} // namespace

ReflectanceLattice::ReflectanceLattice(const std::vector<double>& nm)
    : bands_(nm.size()), stride_(padded_band_count(static_cast<int>(nm.size()))) {
  constexpr int kPoints = kSteps + 1;
  values_.reserve(stride_ * kPoints * kPoints * kPoints);
  for (int b = 0; b < kPoints; ++b)
    for (int g = 0; g < kPoints; ++g)
      for (int r = 0; r < kPoints; ++r) {
        const double step = 1.0 / kSteps;
        const auto row =
            BandTable::at_wavelengths(nm, rgb_reflectance({r * step, g * step, b * step}), false);
        values_.insert(values_.end(), row.data(), row.data() + stride_);
      }
}

void ReflectanceLattice::evaluate(const std::array<float, 3>& rgb, BandTable& reflectance) const {
  // Within the cell the path from its lowest to its highest corner that takes the largest remainder
  // first passes the corners of the tetrahedron; the weights are the differences of the remainders.
  constexpr std::array<std::size_t, 3> kStride{1, kSteps + 1, (kSteps + 1) * (kSteps + 1)};
  struct Axis {
    float remainder;
    std::size_t stride;
  };
  std::array<Axis, 3> axes;
  std::size_t corner = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const float x = rgb[i] * kSteps;
    const float cell = std::min(std::floor(x), static_cast<float>(kSteps - 1));
    axes[i] = {x - cell, kStride[i]};
    corner += static_cast<std::size_t>(cell) * kStride[i];
  }
  if (axes[0].remainder < axes[1].remainder) std::swap(axes[0], axes[1]);
  if (axes[1].remainder < axes[2].remainder) std::swap(axes[1], axes[2]);
  if (axes[0].remainder < axes[1].remainder) std::swap(axes[0], axes[1]);
  const float* a = values_.data() + corner * stride_;
  const float* b = a + axes[0].stride * stride_;
  const float* c = b + axes[1].stride * stride_;
  const float* d = c + axes[2].stride * stride_;
  const float wa = 1.0f - axes[0].remainder, wb = axes[0].remainder - axes[1].remainder;
  const float wc = axes[1].remainder - axes[2].remainder, wd = axes[2].remainder;
  float* target = reflectance.varying();
  for (std::size_t i = 0; i < stride_; ++i)
    target[i] = wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i];
}

int plan_texture(TexturePlans& plans, const Texture& texture,
                 const std::vector<ReflectanceImage>& images, const std::vector<double>& nm,
                 bool keep_constant) {
  const auto table = [&](const Curve& curve) {
    return BandTable::at_wavelengths(nm, curve, keep_constant);
  };
  if (const auto* checker = std::get_if<CheckerTexture>(&texture)) {
    plans.textures.emplace_back(
        CheckerPlan{checker->across, checker->up, table(checker->first), table(checker->second)});
  } else if (const auto* grid = std::get_if<GridTexture>(&texture)) {
    plans.textures.emplace_back(GridPlan{grid->across, grid->up, 0.5 * grid->width,
                                         table(grid->lines), table(grid->fields)});
  } else {
    if (plans.images.empty()) plans.images = images;
    if (plans.lattice.empty()) plans.lattice.emplace_back(nm);
    plans.textures.emplace_back(ImagePlan{std::get<ImageTexture>(texture).image});
  }
  return static_cast<int>(plans.textures.size()) - 1;
}

std::array<float, 3> color_at(const ReflectanceImage& image, const dvec2& uv) {
  const Neighbours x = neighbours(field_of(uv.x, 1.0).place, image.width),
                   y = neighbours(1.0 - field_of(uv.y, 1.0).place, image.height);
  const auto texel = [&](std::size_t column, std::size_t row) {
    return image.rgb.data() + 3 * (row * static_cast<std::size_t>(image.width) + column);
  };
  const float *a = texel(x.first, y.first), *b = texel(x.second, y.first),
              *c = texel(x.first, y.second), *d = texel(x.second, y.second);
  std::array<float, 3> rgb;
  for (std::size_t i = 0; i < 3; ++i) {
    const float above = a[i] + x.share * (b[i] - a[i]), below = c[i] + x.share * (d[i] - c[i]);
    rgb[i] = std::clamp(above + y.share * (below - above), 0.0f, 1.0f);
  }
  return rgb;
}

const BandTable& texture_at(const TexturePlans& plans, int texture, const dvec2& uv,
                            BandTable& scratch) {
  return std::visit(
      [&](const auto& plan) -> const BandTable& { return reflectance(plan, plans, uv, scratch); },
      plans.textures[static_cast<std::size_t>(texture)]);
}

} // namespace abbe
