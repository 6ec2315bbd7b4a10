#include "io/states/write_state.h"

#include "core/film/film_row.h"
#include "io/files/atomic_file.h"
#include "io/states/block_file.h"
#include "io/states/info_bytes.h"
#include "io/states/value_bytes.h"

namespace abbe {
namespace {

void put_range(ValueWriter& out, const SampleRange& range) {
  out.put(std::int32_t{range.first});
  out.put(std::int32_t{range.last});
}

void put_light(ValueWriter& out, const LightPassState& light) {
  out.put(std::int32_t{light.passes});
  put_range(out, light.samples);
  put_range(out, light.first_samples);
  out.put(light.begun);
  out.put(light.chunks);
  out.put(light.first_radius);
}

std::string progress_bytes(const RenderState& state) {
  ValueWriter out;
  out.put(std::int32_t{state.done});
  out.put(std::int32_t{state.round_end});
  out.put(state.seconds);
  out.put(state.light_seconds);
  const RayCounts& rays = state.rays;
  for (const std::uint64_t count :
       {rays.camera, rays.reflected, rays.refracted, rays.scattered, rays.shadow, rays.light,
        rays.splats, rays.photons, rays.not_finite})
    out.put(count);
  put_light(out, state.light);
  out.put(std::uint64_t{state.tiles.size()});
  for (const TileState& tile : state.tiles) {
    out.put(std::int32_t{tile.samples});
    out.put(std::uint8_t{tile.ended});
    out.put(tile.left.pixels);
    out.put(tile.left.samples);
  }
  out.put(state.shares);
  out.put(state.allocation);
  out.put(state.pixel_rays);
  return out.bytes();
}

std::string film_bytes(const Film& film) {
  ValueWriter out;
  const PixelWindow& window = film.window();
  for (const int edge : {window.x0, window.y0, window.x1, window.y1})
    out.put(std::int32_t{edge});
  out.put(film.light_passes());
  out.put(film.refused().not_finite);
  out.put(film.refused().negative);
  out.put(film.refused().overflow);
  out.put(std::uint64_t{film.layer_count()});
  for (std::size_t i = 0; i < film.layer_count(); ++i) {
    const LayerForm& form = film.layer(static_cast<LayerId>(i)).form();
    out.put(form.name);
    out.put(form.kind);
    out.put(form.quantum);
    out.put(std::int32_t{form.bands});
    out.put(form.mean);
    out.put(std::uint8_t{form.strata});
  }
  return out.bytes();
}

void put_row(ValueWriter& out, const FilmRow& row) {
  out.put_each(row.counts);
  out.put_each(row.covered);
  for (const PixelStrata& strata : row.strata) {
    out.put(strata.boundary);
    out.put(strata.first);
  }
  for (const LayerRow& layer : row.layers) {
    out.put_each(layer.sums);
    out.put_each(layer.first_sums);
    for (const std::vector<IdCount>& ids : layer.ids) {
      out.put(std::uint64_t{ids.size()});
      for (const IdCount& pair : ids) {
        out.put(pair.id);
        out.put(pair.count);
      }
    }
  }
}

} // namespace

void write_state(const std::filesystem::path& file, const StateInfo& info, const RenderState& state,
                 const RowSource& rows) {
  replace_file(file, [&](const std::filesystem::path& temporary) {
    BlockWriter writer(temporary);
    ValueWriter about;
    put_info(about, info);
    writer.write("INFO", about.bytes());
    writer.write("PROG", progress_bytes(state));
    writer.write("FILM", film_bytes(state.film));
    FilmRow row;
    ValueWriter bytes;
    const PixelWindow& window = state.film.window();
    for (int y = window.y0; y < window.y1; ++y) {
      rows(y, row);
      bytes.clear();
      put_row(bytes, row);
      writer.write("ROW ", bytes.bytes());
    }
    writer.end();
  });
}

void write_state(const std::filesystem::path& file, const StateInfo& info,
                 const RenderState& state) {
  write_state(file, info, state, [&](int y, FilmRow& row) { get_row(state.film, y, row); });
}

} // namespace abbe
