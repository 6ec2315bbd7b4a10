#include "core/render/render.h"

#include "core/adaptive/noise.h"
#include "core/adaptive/sample_allocation.h"
#include "core/adaptive/sample_shares.h"
#include "core/bundles/denormals.h"
#include "core/render/peer_sums.h"
#include "core/render/progress_meter.h"
#include "core/render/tile_renderer.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace abbe {
namespace {

/// A tile that is not done yet.
struct OpenTile {
  const Tile* tile;
  TileState* state;
  int expected; ///< how many samples a pixel it may need
};

/// How many samples a tile may need, by the error it has after n of them: errors fall like
/// 1/sqrt(n).
int expected_samples(double error, int n, double noise, int most) {
  const double expected = n * std::pow(error / noise, 2);
  return static_cast<int>(std::min(std::max(expected, n + 1.0), static_cast<double>(most)));
}

/// By how many samples an allocation misses `mean` samples a pixel.
double more_than(const std::vector<std::uint32_t>& allocation, int mean) {
  const auto total = std::accumulate(allocation.begin(), allocation.end(), std::uint64_t{0});
  return static_cast<double>(total) -
         static_cast<double>(mean) * static_cast<double>(allocation.size());
}

int thread_count(const RenderSettings& settings) {
  return settings.threads > 0 ? settings.threads : tbb::info::default_concurrency();
}

/// Renders one range of samples into a state, pass by pass.
class RangeRenderer {
public:
  RangeRenderer(RenderContext& context, SampleRange range, RenderState& state,
                const RenderControl& control);

  /// False when it was stopped.
  bool run();

private:
  [[nodiscard]] bool stopped() const {
    return (control_.stop && *control_.stop) || (pause_ < kInfinity && meter_.seconds() >= pause_);
  }
  /// How long the rendering has taken, with earlier ranges.
  [[nodiscard]] double seconds() const {
    return state_.seconds + meter_.seconds() - counted_seconds_;
  }
  /// Renders on until the range is done, which it tells, or the rendering is stopped.
  bool run_to_stop();
  /// Counts in the state what has come since it was done before.
  void count();
  /// True when nothing is to be rendered any more, be the range done or not.
  [[nodiscard]] bool over() const;
  /// True where samples or errors of a pass decide on what comes after it, so that passes must not
  /// be cut where a range ends.
  [[nodiscard]] bool decides() const;
  void begin_round();
  [[nodiscard]] int end_of_pass() const;
  /// Follows the light paths that the pass's camera samples need. False when it was stopped.
  bool light_pass(int last);
  /// Follows those that are left, so that a picture is there before they are done. False when it
  /// was stopped.
  bool rest_of_light_pass();
  /// True where what comes before camera samples must be complete: tiles that end by their noise
  /// see splats, and a time limit has measured how long all light paths take.
  [[nodiscard]] bool splats_come_first() const { return settings_.may_end_early(); }
  [[nodiscard]] LightPasses::Run light_run(const IsOver& is_over) {
    return {state_.film,
            is_over,
            control_.record,
            {static_cast<std::size_t>(peers_.number), static_cast<std::size_t>(peers_.count)}};
  }
  /// The samples of a pass in a tile that has come so far.
  [[nodiscard]] PassSamples samples_of(const TileState& tile, int last) const;
  /// Renders one pass of a tile and decides by its pixels alone whether it is done: the same bytes
  /// on any number of threads. False when it was over before.
  bool render_tile(OpenTile& tile, int last, TileRenderer& renderer);
  /// Renders one pass of all open tiles, those of the peers too. False when some of them were left.
  bool render_pass(int last);

  // What peers ask of each other; one that is alone does nothing then.

  /// The work that is expected of this one, in camera samples.
  [[nodiscard]] double expected_work() const;
  /// True where decisions need the splats of all.
  [[nodiscard]] bool needs_splats_of_all() const {
    return !peers_.alone() && settings_.noise > 0.0 && context_.light_passes.needed();
  }
  void share_splats_of_all();
  void part_with_splats_of_all();
  /// Tells each other which chunks of the current light pass have been added.
  void exchange_chunks();
  /// Tells each other how far tiles have come.
  void exchange_tiles();

  const RenderSettings& settings_;
  const SampleRange range_;
  RenderState& state_;
  const RenderControl& control_;
  const SampleSchedule schedule_;
  RenderContext& context_;
  const Peers peers_;
  bool splats_are_shared_ = false;
  ProgressMeter meter_;
  tbb::global_control workers_;
  tbb::task_arena arena_;
  std::vector<OpenTile> open_;
  double pause_ = kInfinity; ///< when the rendering is to be stopped, in the seconds of the meter
  double counted_seconds_ = 0.0, counted_light_seconds_ = 0.0; ///< that are in the state
};

RangeRenderer::RangeRenderer(RenderContext& context, SampleRange range, RenderState& state,
                             const RenderControl& control)
    : settings_(context.plan.settings), range_(range), state_(state), control_(control),
      schedule_(settings_), context_(context), peers_(control.peers ? *control.peers : Peers{}),
      meter_(control.progress, expected_work(), settings_.seconds),
      workers_(tbb::global_control::max_allowed_parallelism,
               static_cast<std::size_t>(thread_count(settings_))),
      arena_(thread_count(settings_)) {
  for (std::size_t i = 0; i < state.tiles.size(); ++i)
    if (!state.tiles[i].ended)
      open_.push_back({&context.plan.tiles[i], &state.tiles[i], range.last});
}

bool RangeRenderer::run() {
  while (!run_to_stop()) {
    if (!control_.pause || !peers_.all(!(control_.stop && *control_.stop))) return false;
    control_.pause();
    pause_ = kInfinity;
  }
  return true;
}

bool RangeRenderer::run_to_stop() {
  bool whole = true;
  share_splats_of_all();
  while (whole && state_.done < range_.last && !open_.empty()) {
    // Peers begin rounds and passes together, or none does.
    if (!peers_.alone() && !peers_.all(!stopped())) break;
    if (state_.done == state_.round_end) begin_round();
    const int last = end_of_pass();
    whole = peers_.all(light_pass(last));
    if (control_.pause_after > 0.0)
      pause_ = std::min(pause_, meter_.seconds() + control_.pause_after);
    whole = whole && render_pass(last) && peers_.all(rest_of_light_pass());
    std::erase_if(open_, [](const OpenTile& tile) { return tile.state->ended; });
    if (whole) state_.done = last;
  }
  part_with_splats_of_all();
  count();
  // A stop after the last tile came too late to matter.
  return state_.done >= range_.last || open_.empty() || (peers_.alone() && !stopped());
}

void RangeRenderer::count() {
  const double seconds = meter_.seconds(), light_seconds = context_.light_passes.seconds();
  state_.rays += meter_.take_rays();
  state_.seconds += seconds - std::exchange(counted_seconds_, seconds);
  state_.light_seconds += light_seconds - std::exchange(counted_light_seconds_, light_seconds);
  if (!peers_.alone()) add_up_counts(state_, peers_);
}

bool RangeRenderer::over() const {
  if (stopped()) return true;
  // The first pass is finished, however short the time.
  return settings_.seconds > 0.0 && state_.done > 0 && seconds() >= settings_.seconds;
}

bool RangeRenderer::decides() const {
  return (settings_.adaptive == AdaptiveSampling::on && !state_.planned) || settings_.noise > 0.0;
}

void RangeRenderer::begin_round() {
  state_.round_end =
      state_.planned ? settings_.samples_per_pixel : schedule_.end_of_round(state_.done);
  if (state_.planned || settings_.adaptive != AdaptiveSampling::on || state_.done == 0) return;
  const auto decide = [&](const Film& film, std::span<const std::uint32_t> rays) {
    arena_.execute([&] {
      if (state_.shares.empty()) state_.shares = find_shares(film, rays);
      state_.allocation = allocate_samples(film, state_.shares, state_.round_end);
    });
  };
  if (peers_.alone()) {
    decide(state_.film, state_.pixel_rays);
  } else {
    std::vector<std::int64_t> rays(state_.pixel_rays.begin(), state_.pixel_rays.end());
    peers_.add_up(rays);
    decide(add_up_colors(state_.film, peers_),
           std::vector<std::uint32_t>(rays.begin(), rays.end()));
  }
  if (state_.round_end == settings_.samples_per_pixel)
    meter_.step({}, 0.0, more_than(state_.allocation, state_.round_end) / peers_.count);
}

int RangeRenderer::end_of_pass() const {
  int end = schedule_.end_of_pass(state_.done, state_.round_end);
  if (decides()) return end;
  // Where an earlier range ended within a light pass, its other samples come first.
  if (state_.done < state_.light.samples.last) end = std::min(end, state_.light.samples.last);
  return std::min(end, range_.last);
}

bool RangeRenderer::light_pass(int last) {
  LightPasses& passes = context_.light_passes;
  if (!passes.needed()) return true;
  const int done = state_.done;
  if (done >= state_.light.samples.last) {
    if (peers_.alone() && over()) return false;
    SampleRange samples{done, schedule_.end_of_light_pass(done, last)};
    if (settings_.seconds > 0.0 && done > 0)
      samples.last = SampleSchedule::end_in_time(samples, state_.light_seconds + passes.seconds(),
                                                 settings_.seconds - seconds());
    passes.begin(state_.light, samples);
  }
  const IsOver is_over = [this] {
    meter_.follow_light();
    return over();
  };
  part_with_splats_of_all();
  arena_.execute([&] {
    const LightPasses::Run run = light_run(is_over);
    meter_.add(passes.fill_map(state_.light, run));
    if (splats_come_first() && passes.has_map(state_.light))
      meter_.add(passes.add_splats(state_.light, run));
  });
  exchange_chunks();
  share_splats_of_all();
  return passes.has_map(state_.light) && (!splats_come_first() || !over());
}

bool RangeRenderer::rest_of_light_pass() {
  if (!context_.light_passes.needed() || splats_come_first()) return true;
  const IsOver is_over = [this] {
    meter_.follow_light();
    return over();
  };
  arena_.execute(
      [&] { meter_.add(context_.light_passes.add_splats(state_.light, light_run(is_over))); });
  exchange_chunks();
  return std::ranges::find(state_.light.chunks, ChunkSplats::missing) == state_.light.chunks.end();
}

PassSamples RangeRenderer::samples_of(const TileState& tile, int last) const {
  if (state_.allocation.empty()) return PassSamples({tile.samples, last});
  if (state_.planned) return {state_.allocation, {tile.samples, last}, settings_.samples_per_pixel};
  return {state_.allocation, SampleSchedule::passes(state_.done, state_.round_end)};
}

bool RangeRenderer::render_tile(OpenTile& tile, int last, TileRenderer& renderer) {
  if (tile.state->samples >= last) return true; // before it was stopped
  const PixelWindow& window = tile.tile->window;
  const auto pixels = static_cast<double>(window.pixel_count());
  const PassProgress pass =
      renderer.render(*tile.tile, samples_of(*tile.state, last), tile.state->left, control_.record);
  if (pass.rendered > 0) state_.film.touched(window.pixel_count());
  if (!pass.whole) {
    meter_.add(pass.rays);
    return false;
  }
  tile.state->samples = last;
  tile.state->left = {};
  const int expected = tile.expected;
  tile.expected = std::max(expected, last);
  if (settings_.noise > 0.0 && (schedule_.may_end(last) || last == settings_.samples_per_pixel)) {
    const double error = relative_error(state_.film, window);
    tile.state->ended = error <= settings_.noise;
    tile.expected =
        tile.state->ended ? last : expected_samples(error, last, settings_.noise, range_.last);
  }
  meter_.step(pass.rays, static_cast<double>(pass.rendered), pixels * (tile.expected - expected));
  return true;
}

bool RangeRenderer::render_pass(int last) {
  const IsOver is_over = [this] { return over(); };
  std::atomic<std::size_t> rendered = 0;
  const auto is_own = [&](const OpenTile& tile) {
    return peers_.has_tile(static_cast<std::size_t>(tile.state - state_.tiles.data()));
  };
  arena_.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, open_.size(), 1), [&](const auto& range) {
      const DenormalsOff denormals_off;
      TileRenderer renderer(context_, state_.film, state_.pixel_rays, is_over);
      for (std::size_t i = range.begin(); i < range.end() && !over(); ++i)
        rendered += !is_own(open_[i]) || render_tile(open_[i], last, renderer) ? 1 : 0;
    });
  });
  exchange_tiles();
  return peers_.all(rendered == open_.size());
}

double RangeRenderer::expected_work() const {
  std::size_t pixels = context_.plan.window.pixel_count();
  if (!peers_.alone()) {
    pixels = 0;
    for (std::size_t t = 0; t < context_.plan.tiles.size(); ++t)
      if (peers_.has_tile(t)) pixels += context_.plan.tiles[t].window.pixel_count();
  }
  return static_cast<double>(pixels) * (range_.last - state_.done);
}

void RangeRenderer::share_splats_of_all() {
  if (!needs_splats_of_all()) return;
  share_splats(state_.film, peers_);
  splats_are_shared_ = true;
}

void RangeRenderer::part_with_splats_of_all() {
  if (splats_are_shared_) part_with_splats(state_.film, peers_);
  splats_are_shared_ = false;
}

void RangeRenderer::exchange_chunks() {
  if (peers_.alone()) return;
  std::vector<ChunkSplats>& chunks = state_.light.chunks;
  std::vector<std::int64_t> added(chunks.size());
  for (std::size_t c = 0; c < chunks.size(); ++c)
    added[c] = chunks[c] == ChunkSplats::added ? 1 : 0;
  peers_.add_up(added);
  for (std::size_t c = 0; c < chunks.size(); ++c)
    if (added[c] > 0) chunks[c] = ChunkSplats::added;
  state_.film.add_light_passes(light_passes_in_film(state_.light) - state_.film.light_passes());
}

void RangeRenderer::exchange_tiles() {
  if (peers_.alone()) return;
  std::vector<std::int64_t> numbers;
  for (std::size_t t = 0; t < state_.tiles.size(); ++t) {
    const TileState tile = peers_.has_tile(t) ? state_.tiles[t] : TileState{};
    numbers.insert(numbers.end(),
                   {tile.samples, tile.ended ? 1 : 0, tile.left.pixels, tile.left.samples});
  }
  peers_.add_up(numbers);
  auto next = numbers.begin();
  for (TileState& tile : state_.tiles) {
    tile.samples = static_cast<int>(*next++);
    tile.ended = *next++ != 0;
    tile.left.pixels = static_cast<std::uint32_t>(*next++);
    tile.left.samples = static_cast<std::uint32_t>(*next++);
  }
}

/// Brings a state that has not begun to where all samples before `first` would have brought it, but
/// for the film.
void begin_late(const RenderContext& context, int first, RenderState& state) {
  const SampleSchedule schedule(context.plan.settings);
  const int round_end =
      state.planned ? context.plan.settings.samples_per_pixel : schedule.end_of_round(0);
  if (context.light_passes.needed())
    for (int done = 0; done <= first; done = state.light.samples.last) {
      const int pass_end = schedule.end_of_pass(done, round_end);
      context.light_passes.begin(state.light, {done, schedule.end_of_light_pass(done, pass_end)});
    }
  state.done = first;
  state.round_end = round_end;
  for (TileState& tile : state.tiles)
    tile.samples = first;
}

} // namespace

bool render(const Scene& scene, const Plan& plan, const World& world, SampleRange range,
            RenderState& state, const RenderControl& control) {
  assert(!control.record || plan.settings.threads == 1);
  [[maybe_unused]] const int most = plan.settings.samples_per_pixel;
  assert(range.last <= most);
  assert(!control.peers || control.peers->alone() ||
         (state.light.part.is_whole() && plan.settings.seconds == 0.0));
  const bool begins_late = range.first > state.done;
  if (begins_late) {
    assert(state.done == 0 && state.round_end == 0); // it has not begun
    assert(plan.settings.adaptive == AdaptiveSampling::off || state.planned);
    assert(!plan.settings.may_end_early());
    assert(!plan.caustics || range.first == samples_of(state.light.part, most).first);
  }
  RenderContext context(scene, plan, world);
  if (begins_late) begin_late(context, range.first, state);
  return RangeRenderer(context, range, state, control).run();
}

Rendering end_rendering(RenderState&& state, const Plan& plan, bool complete) {
  const auto open = std::ranges::count_if(state.tiles, [](const TileState& t) { return !t.ended; });
  return {.film = std::move(state.film),
          .rays = state.rays,
          .seconds = state.seconds,
          .light_seconds = state.light_seconds,
          .complete = complete,
          .open_tiles = plan.settings.noise > 0.0 ? static_cast<std::size_t>(open) : 0};
}

Rendering render(const Scene& scene, const Plan& plan, const World& world,
                 const std::optional<BandPlace>& bands, const RenderControl& control) {
  RenderState state = begin_rendering(scene, plan, bands);
  const bool complete =
      render(scene, plan, world, {0, plan.settings.samples_per_pixel}, state, control);
  return end_rendering(std::move(state), plan, complete);
}

} // namespace abbe
