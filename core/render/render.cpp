#include "core/render/render.h"

#include "core/adaptive/noise.h"
#include "core/adaptive/sample_allocation.h"
#include "core/adaptive/sample_shares.h"
#include "core/bundles/denormals.h"
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
  [[nodiscard]] double seconds() const { return state_.seconds + meter_.seconds(); }
  /// True when nothing is to be rendered any more, be the range done or not.
  [[nodiscard]] bool over() const;
  /// True where samples or errors of a pass decide on what comes after it, so that passes must not
  /// be cut where a range ends.
  [[nodiscard]] bool decides() const;
  void begin_round();
  [[nodiscard]] int end_of_pass() const;
  /// Follows the light paths that the pass's camera samples need.
  void light_pass(int last);
  /// The samples of a pass in a tile that has come so far.
  [[nodiscard]] PassSamples samples_of(const TileState& tile, int last) const;
  /// Renders one pass of a tile and decides by its pixels alone whether it is done: the same bytes
  /// on any number of threads. False when it was over before.
  bool render_tile(OpenTile& tile, int last, TileRenderer& renderer);
  /// Renders one pass of all open tiles. False when some of them were left.
  bool render_pass(int last);

  const RenderSettings& settings_;
  const SampleRange range_;
  RenderState& state_;
  const RenderControl& control_;
  const SampleSchedule schedule_;
  RenderContext& context_;
  ProgressMeter meter_;
  tbb::global_control workers_;
  tbb::task_arena arena_;
  std::vector<OpenTile> open_;
  double pause_ = kInfinity; ///< when the rendering is to be stopped, in the seconds of the meter
};

RangeRenderer::RangeRenderer(RenderContext& context, SampleRange range, RenderState& state,
                             const RenderControl& control)
    : settings_(context.plan.settings), range_(range), state_(state), control_(control),
      schedule_(settings_), context_(context),
      meter_(control.progress,
             static_cast<double>(context.plan.window.pixel_count()) * (range.last - state.done),
             settings_.seconds),
      workers_(tbb::global_control::max_allowed_parallelism,
               static_cast<std::size_t>(thread_count(settings_))),
      arena_(thread_count(settings_)) {
  for (std::size_t i = 0; i < state.tiles.size(); ++i)
    if (!state.tiles[i].ended)
      open_.push_back({&context.plan.tiles[i], &state.tiles[i], range.last});
}

bool RangeRenderer::run() {
  bool whole = true;
  while (whole && state_.done < range_.last && !open_.empty()) {
    if (state_.done == state_.round_end) begin_round();
    const int last = end_of_pass();
    light_pass(last);
    if (control_.pause_after > 0.0)
      pause_ = std::min(pause_, meter_.seconds() + control_.pause_after);
    whole = render_pass(last);
    std::erase_if(open_, [](const OpenTile& tile) { return tile.state->ended; });
    if (whole) state_.done = last;
  }
  state_.rays += meter_.rays();
  state_.seconds += meter_.seconds();
  state_.light_seconds += context_.light_passes.seconds();
  // A stop after the last tile came too late to matter.
  return state_.done >= range_.last || open_.empty() || !stopped();
}

bool RangeRenderer::over() const {
  if (stopped()) return true;
  // The first pass is finished, however short the time.
  return settings_.seconds > 0.0 && state_.done > 0 && seconds() >= settings_.seconds;
}

bool RangeRenderer::decides() const {
  return settings_.adaptive == AdaptiveSampling::on || settings_.noise > 0.0;
}

void RangeRenderer::begin_round() {
  state_.round_end = schedule_.end_of_round(state_.done);
  if (settings_.adaptive != AdaptiveSampling::on || state_.done == 0) return;
  arena_.execute([&] {
    if (state_.shares.empty()) state_.shares = find_shares(state_.film, state_.pixel_rays);
    state_.allocation = allocate_samples(state_.film, state_.shares, state_.round_end);
  });
  if (state_.round_end == settings_.samples_per_pixel)
    meter_.step({}, 0.0, more_than(state_.allocation, state_.round_end));
}

int RangeRenderer::end_of_pass() const {
  int end = schedule_.end_of_pass(state_.done, state_.round_end);
  if (decides()) return end;
  // Where an earlier range ended within a light pass, its other samples come first.
  if (state_.done < state_.light.samples.last) end = std::min(end, state_.light.samples.last);
  return std::min(end, range_.last);
}

void RangeRenderer::light_pass(int last) {
  LightPasses& passes = context_.light_passes;
  if (!passes.needed()) return;
  const int done = state_.done;
  if (done >= state_.light.samples.last) {
    if (over()) return;
    SampleRange samples{done, schedule_.end_of_light_pass(done, last)};
    if (settings_.seconds > 0.0 && done > 0)
      samples.last = SampleSchedule::end_in_time(samples, state_.light_seconds + passes.seconds(),
                                                 settings_.seconds - seconds());
    passes.begin(state_.light, samples);
  }
  const IsOver is_over = [this] { return over(); };
  arena_.execute(
      [&] { meter_.add(passes.run(state_.light, state_.film, is_over, control_.record)); });
}

PassSamples RangeRenderer::samples_of(const TileState& tile, int last) const {
  if (state_.allocation.empty()) return PassSamples({tile.samples, last});
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
  arena_.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, open_.size(), 1), [&](const auto& range) {
      const DenormalsOff denormals_off;
      TileRenderer renderer(context_, state_.film, state_.pixel_rays, is_over);
      for (std::size_t i = range.begin(); i < range.end() && !over(); ++i)
        rendered += render_tile(open_[i], last, renderer) ? 1 : 0;
    });
  });
  return rendered == open_.size();
}

/// Brings a state that has not begun to where all samples before `first` would have brought it, but
/// for the film.
void begin_late(const RenderContext& context, int first, RenderState& state) {
  const SampleSchedule schedule(context.plan.settings);
  const int round_end = schedule.end_of_round(0);
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
  const bool begins_late = range.first > state.done;
  if (begins_late) {
    assert(state.done == 0 && state.round_end == 0); // it has not begun
    assert(plan.settings.adaptive == AdaptiveSampling::off && !plan.settings.may_end_early());
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
