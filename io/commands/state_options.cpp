#include "io/commands/state_options.h"

#include "core/adaptive/sample_schedule.h"
#include "core/scene/user_error.h"
#include "io/states/kept_settings.h"
#include "io/text/numbers.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// "3/8" is the third of eight parts.
std::optional<RenderPart> parse_part(const std::string& text) {
  constexpr std::int64_t kMost = 1 << 24; // as many as there may be samples
  const std::size_t slash = text.find('/');
  if (slash == text.npos) return std::nullopt;
  const auto number = parse_whole(std::string_view(text).substr(0, slash));
  const auto count = parse_whole(std::string_view(text).substr(slash + 1));
  if (!number || !count || *count < 1 || *count > kMost || *number < 1 || *number > *count)
    return std::nullopt;
  return RenderPart{static_cast<int>(*number) - 1, static_cast<int>(*count)};
}

std::string text_of(const RenderPart& part) {
  return fmt::format("{}/{}", part.number + 1, part.count);
}

/// True where the light passes of the state are those of a rendering that was begun for as many
/// samples as the plan has.
bool has_light_passes_of(const Plan& plan, const LightPassState& light) {
  const SampleSchedule schedule(plan.settings);
  const int round_end = schedule.end_of_round(0);
  int passes = 0, done = 0;
  for (; done < light.samples.last; ++passes)
    done = schedule.end_of_light_pass(done, schedule.end_of_pass(done, round_end));
  return passes == light.passes && done == light.samples.last;
}

} // namespace

void add_state_options(CLI::App& app, StateOptions& options) {
  app.add_option("--checkpoint", options.checkpoint,
                 "Keep the state of the rendering in a file, now and then and when it ends or is "
                 "interrupted")
      ->type_name("FILE");
  app.add_option_function<std::string>(
         "--checkpoint-every",
         [&options](const std::string& text) {
           const auto seconds = parse_finite(text);
           if (!seconds || !(*seconds >= 1.0 && *seconds <= 1e9))
             throw CLI::ValidationError("--checkpoint-every",
                                        "\"" + text + "\" is not a time of 1 second or more");
           options.every_seconds = *seconds;
         },
         "How often (default 600)")
      ->type_name("SECONDS");
  app.add_option("--resume", options.resume,
                 "Go on from a state; with more --spp, add samples to a finished picture")
      ->type_name("FILE");
  app.add_option_function<std::string>(
         "--part",
         [&options](const std::string& text) {
           options.part = parse_part(text);
           if (!options.part)
             throw CLI::ValidationError("--part", "\"" + text +
                                                      "\" is not a part such as 3/8, the third of "
                                                      "eight");
         },
         "Render one of several parts of the samples into the state -o, for abbe merge")
      ->type_name("K/N");
  app.add_option("--plan-out", options.plan_out,
                 "Only plan where samples go, for parts with adaptive sampling")
      ->type_name("FILE");
  app.add_option("--plan-in", options.plan_in, "Spread samples as --plan-out has planned")
      ->type_name("FILE");
}

RenderPart part_of(const StateOptions& options, const StateReader* resumed) {
  if (!resumed) return options.part.value_or(RenderPart{});
  const RenderPart part = resumed->info().part;
  if (options.part && !(*options.part == part))
    throw UserError(fmt::format("{}: this state is of part {}, and --part asks for {}",
                                options.resume->string(), text_of(part), text_of(*options.part)));
  return part;
}

void check_plan_options(const StateOptions& options, const RenderSettings& settings) {
  if (!options.plan_out && !options.plan_in) return;
  const std::string name = options.plan_out ? "--plan-out" : "--plan-in";
  if (options.plan_out && options.plan_in)
    throw UserError("--plan-out and --plan-in exclude each other: a plan is made once, and read by "
                    "each part");
  if (settings.noise > 0.0)
    throw UserError(name + " and --noise exclude each other: with a noise target each tile ends by "
                           "its own samples. Leave out one of them");
  if (settings.seconds > 0.0)
    throw UserError(name + " and --time exclude each other: a plan spreads a known number of "
                           "samples. Give it by --spp");
  if (settings.adaptive == AdaptiveSampling::off)
    throw UserError(name +
                    " needs adaptive sampling, which is off here. Add --adaptive on, or "
                    "leave out " +
                    name);
  if (options.resume)
    throw UserError(name + " and --resume exclude each other: a state knows its plan. Leave out " +
                    name);
  if (options.plan_out && (options.part || options.checkpoint))
    throw UserError("--plan-out renders a few samples to plan with, and neither a part nor a "
                    "state. Give --part or --checkpoint with --plan-in, in the next call");
}

void check_part(const RenderPart& part, const RenderSettings& settings, bool spread) {
  if (part.is_whole()) return;
  if (settings.noise > 0.0)
    throw UserError("--part and --noise exclude each other: a tile is done when all its samples "
                    "together have reached the noise. Give --noise 0 and the samples by --spp");
  if (settings.seconds > 0.0)
    throw UserError("--part and --time exclude each other: parts must end at the samples where the "
                    "next ones begin. Leave out --time");
  if (settings.adaptive == AdaptiveSampling::on && !spread)
    throw UserError("--part needs the same number of samples for all pixels: what adaptive "
                    "sampling gives a pixel depends on the samples of all parts. Add --adaptive "
                    "off, or --plan-in with the plan that --plan-out writes");
  if (part.count > settings.samples_per_pixel)
    throw UserError(fmt::format("{} samples a pixel cannot be divided into {} parts. Take more "
                                "samples or fewer parts",
                                settings.samples_per_pixel, part.count));
}

RenderSettings resumed_settings(const fs::path& file, const StateInfo& info,
                                const RenderSettings& settings, const SettingsOverride& given) {
  const auto is_samples = [](const auto& setting) { return setting.row->option == "--spp"; };
  RenderSettings result = with_kept(settings, info.settings, given);
  if (std::ranges::none_of(given, is_samples)) result.samples_per_pixel = info.samples;
  const int samples = result.samples_per_pixel;
  if (samples < info.samples)
    throw UserError(fmt::format("{}: this state is of {} samples a pixel, and there is no way back "
                                "to {}",
                                file.string(), info.samples, samples));
  if (samples > info.samples && is_planned(info))
    throw UserError(fmt::format("{}: a plan has spread {} samples a pixel, and more cannot be "
                                "added. Leave out --spp",
                                file.string(), info.samples));
  if (samples > info.samples && !info.part.is_whole())
    throw UserError(fmt::format("{}: a part gets the samples that it was begun for, {} a pixel in "
                                "all. Merge the parts, or leave out --spp",
                                file.string(), info.samples));
  return result;
}

std::string resume_note(const fs::path& file, const StateInfo& info, const RenderState& state,
                        const Plan& plan) {
  const int samples = plan.settings.samples_per_pixel;
  std::string note = fmt::format("resume: {} has {} of {} samples a pixel", file.string(),
                                 state.done, info.samples);
  if (samples == info.samples) return note;
  const bool even =
      plan.settings.adaptive == AdaptiveSampling::off && !plan.settings.may_end_early();
  if (even && has_light_passes_of(plan, state.light))
    return note + fmt::format(", which become {}: the same bytes as in one go", samples);
  return note + fmt::format(", which become {}: unbiased, but not the bytes of {} in one go, since "
                            "{} fewer samples",
                            samples, samples,
                            even ? "a pass of light paths was for" : "it was decided with");
}

} // namespace abbe
