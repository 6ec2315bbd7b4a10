#include "io/states/read_state.h"

#include "core/film/film_row.h"
#include "core/render/peer_sums.h"
#include "io/states/info_bytes.h"
#include "io/states/value_bytes.h"
#include "io/text/read_error.h"
#include "spectral/band_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace abbe {
namespace {

template <class Choice>
Choice choice(std::uint8_t number, Choice last) {
  require(number <= static_cast<std::uint8_t>(last), "a choice");
  return static_cast<Choice>(number);
}

LightPassState get_light(ValueReader& in, const RenderPart& part) {
  LightPassState light;
  light.part = part;
  light.passes = in.get<std::int32_t>();
  const auto range = [&in] {
    const auto first = in.get<std::int32_t>();
    return SampleRange{first, in.get<std::int32_t>()};
  };
  light.samples = range();
  light.first_samples = range();
  light.begun = in.list<std::uint32_t>();
  for (const std::uint8_t chunk : in.list<std::uint8_t>())
    light.chunks.push_back(choice(chunk, ChunkSplats::elsewhere));
  light.first_radius = in.get<double>();
  return light;
}

LayerForm get_form(ValueReader& in) {
  LayerForm form;
  form.name = in.text();
  form.kind = choice(in.get<std::uint8_t>(), LayerKind::nearest);
  form.quantum = in.get<double>();
  form.bands = in.get<std::int32_t>();
  form.mean = choice(in.get<std::uint8_t>(), LayerMean::light_passes);
  form.strata = in.get<std::uint8_t>() != 0;
  int exponent = 0;
  require(std::frexp(form.quantum, &exponent) == 0.5, "a quantum");
  require(form.bands >= 0 && form.bands <= BandGrid::kMaxCount, "a number of bands");
  return form;
}

void get_layer(ValueReader& in, const LayerForm& form, std::size_t width, LayerRow& row) {
  row.sums.resize(width * form.values());
  row.first_sums.resize(form.strata ? row.sums.size() : 0);
  in.get_each(row.sums);
  in.get_each(row.first_sums);
  row.ids.resize(form.kind == LayerKind::ids ? width : 0);
  for (std::vector<IdCount>& ids : row.ids) {
    ids.resize(in.length(2 * sizeof(std::uint32_t)));
    for (IdCount& pair : ids) {
      pair.id = in.get<std::uint32_t>();
      pair.count = in.get<std::uint32_t>();
    }
  }
}

} // namespace

StateReader::StateReader(const std::filesystem::path& file)
    : blocks_(file), progress_{.film = Film({}, {}), .tiles = {}} {
  try {
    read_info(blocks_.read("INFO"));
    read_progress(blocks_.read("PROG"));
    read_film_form(blocks_.read("FILM"));
  } catch (const ReadError&) {
    throw;
  } catch (const std::runtime_error& error) {
    blocks_.refuse(error.what());
  }
}

bool StateReader::has_bands() const {
  return std::ranges::any_of(layers_, [](const LayerForm& f) { return f.name == kBands; });
}

bool StateReader::complete() const {
  return progress_.done >= samples_of(info_.part, info_.samples).last ||
         std::ranges::all_of(progress_.tiles, &TileState::ended);
}

void StateReader::read_info(const std::string& content) {
  ValueReader in(content);
  info_ = get_info(in);
  in.end();
}

void StateReader::read_progress(const std::string& content) {
  ValueReader in(content);
  RenderState& state = progress_;
  state.planned = is_planned(info_);
  state.done = in.get<std::int32_t>();
  state.round_end = in.get<std::int32_t>();
  state.seconds = in.get<double>();
  state.light_seconds = in.get<double>();
  RayCounts& rays = state.rays;
  for (std::uint64_t* count :
       {&rays.camera, &rays.reflected, &rays.refracted, &rays.scattered, &rays.shadow, &rays.light,
        &rays.splats, &rays.photons, &rays.not_finite})
    *count = in.get<std::uint64_t>();
  state.light = get_light(in, info_.part);
  state.tiles.resize(in.length(1));
  for (TileState& tile : state.tiles) {
    tile.samples = in.get<std::int32_t>();
    tile.ended = in.get<std::uint8_t>() != 0;
    tile.left.pixels = in.get<std::uint32_t>();
    tile.left.samples = in.get<std::uint32_t>();
  }
  state.shares = in.list<float>();
  state.allocation = in.list<std::uint32_t>();
  state.pixel_rays = in.list<std::uint32_t>();
  in.end();
}

void StateReader::read_film_form(const std::string& content) {
  ValueReader in(content);
  for (int* edge : {&window_.x0, &window_.y0, &window_.x1, &window_.y1}) {
    *edge = in.get<std::int32_t>();
    require(*edge >= 0 && *edge <= 65536, "an edge of the picture");
  }
  require(window_.x0 < window_.x1 && window_.y0 < window_.y1, "the size of the picture");
  light_passes_ = in.get<double>();
  refused_.not_finite = in.get<std::uint64_t>();
  refused_.negative = in.get<std::uint64_t>();
  refused_.overflow = in.get<std::uint64_t>();
  const std::size_t count = in.length(1);
  require(count < 65535, "the number of layers");
  for (std::size_t i = 0; i < count; ++i)
    layers_.push_back(get_form(in));
  in.end();
  const std::size_t pixels = window_.pixel_count();
  for (const std::size_t size :
       {progress_.shares.size(), progress_.allocation.size(), progress_.pixel_rays.size()})
    require(size == 0 || size == pixels, "the number of pixels");
}

void StateReader::read_row(FilmRow& row) {
  const std::string& content = blocks_.read("ROW ");
  try {
    ValueReader in(content);
    const auto width = static_cast<std::size_t>(window_.width());
    row.counts.resize(width);
    row.covered.resize(width);
    in.get_each(row.counts);
    in.get_each(row.covered);
    const bool strata = std::ranges::any_of(layers_, &LayerForm::strata);
    row.strata.resize(strata ? width : 0);
    for (PixelStrata& pixel : row.strata) {
      pixel.boundary = in.get<std::uint32_t>();
      pixel.first = in.get<std::uint32_t>();
    }
    row.layers.resize(layers_.size());
    for (std::size_t i = 0; i < layers_.size(); ++i)
      get_layer(in, layers_[i], width, row.layers[i]);
    in.end();
  } catch (const ReadError&) {
    throw;
  } catch (const std::runtime_error& error) {
    blocks_.refuse(error.what());
  }
}

RenderState StateReader::read(const BandPlace& place) {
  return read(place, [](int, FilmRow&) {});
}

RenderState StateReader::read_share(const BandPlace& place, const Plan& plan, const Peers& peers) {
  if (peers.alone()) return read(place);
  RenderState state =
      read(place, [&](int y, FilmRow& row) { keep_own(row, y, plan, layers_, peers); });
  if (peers.is_first()) return state;
  state.film.add_refused({0 - refused_.not_finite, 0 - refused_.negative, 0 - refused_.overflow});
  state.rays = {};
  std::ranges::fill(state.pixel_rays, 0U);
  return state;
}

RenderState StateReader::read(const BandPlace& place,
                              const std::function<void(int, FilmRow&)>& change) {
  RenderState state = std::move(progress_);
  state.film = Film(window_, layers_, place);
  FilmRow row;
  for (int y = window_.y0; y < window_.y1; ++y) {
    read_row(row);
    change(y, row);
    set_row(state.film, y, row);
  }
  blocks_.end();
  state.film.add_light_passes(light_passes_);
  state.film.add_refused(refused_);
  return state;
}

void StateReader::check() {
  FilmRow row;
  for (int y = window_.y0; y < window_.y1; ++y)
    read_row(row);
  blocks_.end();
}

} // namespace abbe
