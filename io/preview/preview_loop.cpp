#include "io/preview/preview_loop.h"

#include "core/adaptive/noise.h"
#include "core/image/develop.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "core/render/render.h"
#include "core/scene/user_error.h"
#include "io/building/setting_effects.h"
#include "io/preview/preview_camera.h"
#include "io/scene_files/read_scene_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace abbe {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

/// The layer's channels of a developed image, or its colours.
PreviewPicture picture_of(const SceneLinearImage& image, const std::string& layer) {
  PreviewPicture picture{0, image.display, image.data, 3, {}};
  std::vector<const ImageChannel*> channels;
  for (const ImageChannel& channel : image.channels)
    if (!layer.empty() && channel.name.starts_with(layer + ".")) channels.push_back(&channel);
  const std::size_t pixels = image.data.pixel_count();
  if (channels.size() != 1 && channels.size() != 3) {
    for (std::size_t i = 0; i < pixels; ++i)
      picture.values.insert(picture.values.end(),
                            image.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i),
                            image.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i + 3));
    return picture;
  }
  picture.channels = static_cast<int>(channels.size());
  for (std::size_t i = 0; i < pixels; ++i)
    for (const ImageChannel* channel : channels)
      picture.values.push_back(channel->values[i]);
  return picture;
}

/// Puts the coarse picture in the place of pixels that have no samples yet.
void fill_missing(PreviewPicture& picture, const Film& film, const PreviewPicture& coarse) {
  if (coarse.channels != picture.channels) return;
  const auto channels = static_cast<std::size_t>(picture.channels);
  const PixelWindow& part = coarse.part;
  for_each_pixel(picture.part, [&](int x, int y) {
    if (film.samples(x, y) > 0) return;
    const int from_x =
        std::clamp(x * coarse.frame.width() / picture.frame.width(), part.x0, part.x1 - 1);
    const int from_y =
        std::clamp(y * coarse.frame.height() / picture.frame.height(), part.y0, part.y1 - 1);
    const std::size_t from = channels * part.index(from_x, from_y);
    const std::size_t to = channels * picture.part.index(x, y);
    for (std::size_t k = 0; k < channels; ++k)
      picture.values[to + k] = coarse.values[from + k];
  });
}

/// The settings of a picture of some hundred pixels a side with one sample each, which comes at
/// once; nothing where the picture itself is no larger.
std::optional<RenderSettings> coarse(RenderSettings settings) {
  constexpr double kPixels = 128.0 * 128.0;
  const double shrink = std::sqrt(settings.width * static_cast<double>(settings.height) / kPixels);
  if (shrink <= 1.0) return std::nullopt;
  const auto scaled = [&](int length) {
    return std::max(1, static_cast<int>(std::lround(length / shrink)));
  };
  settings.width = scaled(settings.width);
  settings.height = scaled(settings.height);
  if (auto& crop = settings.crop) {
    crop->x0 = std::min(static_cast<int>(crop->x0 / shrink), settings.width - 1);
    crop->y0 = std::min(static_cast<int>(crop->y0 / shrink), settings.height - 1);
    crop->x1 = std::clamp(scaled(crop->x1), crop->x0 + 1, settings.width);
    crop->y1 = std::clamp(scaled(crop->y1), crop->y0 + 1, settings.height);
  }
  settings.samples_per_pixel = 1;
  settings.noise = settings.seconds = 0.0;
  settings.adaptive = AdaptiveSampling::off;
  return settings;
}

/// The loop and what it keeps from one rendering to the next.
class Preview {
public:
  Preview(const PreviewedScene& previewed, PreviewBoard& board)
      : previewed_(previewed), board_(board) {}

  /// Renders until it is done or something else is wished.
  void render(PreviewWishes wishes, FileWatch& files);

  /// How often it has begun.
  [[nodiscard]] int renderings() const { return report_.renderings; }

private:
  void read(FileWatch& files);
  void render_at(const RenderSettings& settings, const std::string& layer, bool first);
  void show(const RenderState& state, const Plan& plan, const std::string& layer);

  const PreviewedScene& previewed_;
  PreviewBoard& board_;
  std::optional<Scene> scene_;
  std::optional<World> world_;
  std::optional<double> focus_distance_;
  PreviewReport report_;
  Clock::time_point since_;
  bool first_shown_ = false;
  std::optional<PreviewPicture> coarse_; ///< the first picture of a rendering
};

void Preview::read(FileWatch& files) {
  InputFiles inputs{previewed_.path};
  report_.warnings.clear();
  scene_.reset();
  const auto warn = [&](const std::string& warning) { report_.warnings += warning + "\n"; };
  try {
    scene_ = read_scene_file(previewed_.path, warn, &inputs, nullptr, previewed_.strictness);
  } catch (...) {
    files.follow(inputs);
    throw;
  }
  files.follow(inputs);
  try {
    world_.emplace(scene_->shapes, farthest_coordinate(*scene_));
  } catch (...) {
    scene_.reset(); // without its world it is read again
    throw;
  }
}

void Preview::show(const RenderState& state, const Plan& plan, const std::string& layer) {
  PreviewPicture picture = picture_of(develop_scene_linear(state.film, plan), layer);
  if (coarse_)
    fill_missing(picture, state.film, *coarse_);
  else
    coarse_ = picture;
  board_.show(std::move(picture));
  if (!first_shown_) report_.first_picture_seconds = seconds_since(since_);
  first_shown_ = true;
}

void Preview::render_at(const RenderSettings& settings, const std::string& layer, bool first) {
  const Plan plan = make_plan(*scene_, settings);
  RenderState state = begin_rendering(*scene_, plan);
  report_.state = first ? "coarse" : "rendering";
  double shown = 0.0;
  RenderControl control{.stop = &board_.stop()};
  control.progress = [&](const RenderProgress& now) {
    report_.fraction = now.fraction;
    report_.seconds = now.seconds;
    report_.seconds_left = now.fraction > 0.0 ? now.seconds * (1.0 / now.fraction - 1.0) : 0.0;
    report_.rays_per_second =
        now.seconds > 0.0 ? static_cast<double>(now.rays.total()) / now.seconds : 0.0;
    if (!first) board_.tell(report_);
  };
  const auto publish = [&] {
    const Clock::time_point begun = Clock::now();
    report_.samples = sample_counts(state.film).mean;
    report_.noise = std::nullopt;
    if (state.film.keeps_errors()) {
      const double noise = relative_error(state.film, state.film.window());
      if (std::isfinite(noise)) report_.noise = noise;
    }
    show(state, plan, layer);
    board_.tell(report_);
    shown = seconds_since(begun);
  };
  // What it costs to show a picture stays below 2 % of the time.
  control.pause_after = first ? 0.0 : 0.4;
  if (!first)
    control.pause = [&] {
      publish();
      control.pause_after = std::max(control.pause_after, 50.0 * shown);
    };
  const bool complete =
      abbe::render(*scene_, plan, *world_, {0, plan.settings.samples_per_pixel}, state, control);
  if (!complete) return;
  if (!first) report_.state = "done";
  publish();
}

void Preview::render(PreviewWishes wishes, FileWatch& files) {
  since_ = wishes.since;
  first_shown_ = false;
  coarse_.reset();
  PreviewReport begun;
  begun.warnings = std::move(report_.warnings); // of the scene, which may not be read again
  begun.renderings = report_.renderings + 1;
  report_ = std::move(begun);
  if (wishes.read_again || !scene_) read(files);
  report_.title = scene_->title;
  RenderSettings settings = overridden(scene_->settings, previewed_.settings);
  report_.width = settings.width;
  report_.height = settings.height;
  for (const auto& [option, text] : wishes.settings)
    set_from_text(setting_of_option(option), text, settings);
  settings.keep_errors = true;
  if (previewed_.check_memory) previewed_.check_memory(*scene_, settings);
  const Camera own = scene_->camera;
  if (wishes.forget_focus) focus_distance_.reset();
  if (wishes.focus) {
    const double ratio = static_cast<double>(settings.width) / settings.height;
    focus_distance_ = distance_at(*world_, wished_camera(own, wishes), ratio, *wishes.focus);
  }
  if (!wishes.aperture || *wishes.aperture > 0.0) wishes.focus_distance = focus_distance_;
  scene_->camera = wished_camera(own, wishes);
  report_.camera = camera_lines(scene_->camera);
  board_.tell(report_);
  try {
    if (const auto quick = coarse(settings)) render_at(*quick, wishes.layer, true);
    if (!board_.stop()) render_at(settings, wishes.layer, false);
  } catch (...) {
    scene_->camera = own;
    throw;
  }
  scene_->camera = own;
}

} // namespace

void run_preview(const PreviewedScene& previewed, PreviewBoard& board, FileWatch& files) {
  Preview preview(previewed, board);
  for (PreviewWishes wishes = board.take_wishes(); !wishes.over; wishes = board.take_wishes()) {
    try {
      preview.render(wishes, files);
    } catch (const std::exception& fault) {
      // The mistake is shown, and the last picture stays.
      PreviewReport report = board.news(-1).report;
      report.state = "error";
      report.error = fault.what();
      report.renderings = preview.renderings();
      board.tell(report);
    }
  }
}

} // namespace abbe
