#include "core/film/film_row.h"
#include "tests/catch.h"

#include <array>
#include <string>

using namespace abbe;

namespace {

std::vector<LayerForm> all_kinds() {
  return {{kBeauty, LayerKind::xyz, 0.25, 0, LayerMean::samples, true},
          {kBands, LayerKind::bands, 0.25, 2},
          {"depth", LayerKind::value, 0.25},
          {"shape", LayerKind::ids}};
}

} // namespace

TEST_CASE("a film whose rows are set from another's holds the same") {
  const PixelWindow window{3, 5, 5, 7};
  Film film(window, all_kinds());
  const LayerId beauty = *film.find(kBeauty), bands = *film.find(kBands),
                depth = *film.find("depth"), shape = *film.find("shape");
  const std::array<float, 2> radiance{1.0F, 2.5F};
  for (std::uint32_t i = 0; i < 3; ++i) { // sums of 1, 2 and 4
    const Film::Place place = film.count({4, 6, i, i != 1});
    film.add(beauty, place, Xyz{1.0 * (1u << i), 0.5, 0.25});
    film.add(bands, place, radiance);
    film.add(depth, place, -2.0);
    film.add_id(shape, place, i == 2 ? 7 : 9);
  }
  Film copy(window, all_kinds());
  FilmRow row;
  for (int y = window.y0; y < window.y1; ++y) {
    get_row(film, y, row);
    set_row(copy, y, row);
  }
  CHECK(copy.samples(4, 6) == 3);
  CHECK(copy.covered_samples(4, 6) == 2);
  CHECK(copy.samples(3, 5) == 0);
  CHECK(copy.strata(4, 6) == PixelStrata{2, 2});
  const std::size_t pixel = window.index(4, 6);
  CHECK(copy.layer(beauty).sum(pixel, 0) == 7 * 4);
  CHECK(copy.layer(beauty).first_sum(pixel, 0) == 3 * 4);
  CHECK(copy.layer(beauty).sum(pixel, 1) == 3 * 2);
  CHECK(copy.layer(bands).sum(pixel, 1) == 3 * 10);
  CHECK(copy.layer(depth).sum(pixel) == -3 * 8);
  CHECK(copy.layer(shape).ids().of(pixel) == std::vector<IdCount>{{9, 2}, {7, 1}});
  CHECK(copy.layer(beauty).sum(window.index(3, 6)) == 0);
}
