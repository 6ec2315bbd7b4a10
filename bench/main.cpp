#include "bench/command_line.h"
#include "bench/result_tables.h"
#include "bench/write_json.h"
#include "io/atomic_file.h"
#include "io/command_line.h"
#include "io/token.h"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace {

using namespace abbe;
namespace fs = std::filesystem;

void show(const bench::Table& table) {
  fmt::print("{}", bench::to_text(table));
  std::fflush(stdout);
}

bench::Report measure(const bench::Options& options) {
  bench::Report report{bench::this_machine(), {}, {}, {}};
  show(bench::table_of(report.machine));
  const bench::ErrorOptions& error = options.error;
  for (const fs::path& scene : options.scenes) {
    switch (options.measurement) {
    case bench::Measurement::rays: {
      const std::vector<int> levels =
          error.render.bands ? std::vector{*error.render.bands} : std::vector{1, 81};
      for (const int bands : levels) {
        bench::RenderOptions render = error.render;
        render.bands = bands;
        show(bench::table_of(report.rays.emplace_back(bench::measure_rays(scene, render))));
      }
      break;
    }
    case bench::Measurement::bands:
      show(bench::table_of(report.bands.emplace_back(bench::measure_bands(scene, error.render))));
      break;
    case bench::Measurement::error:
      report.errors.push_back(bench::measure_error(
          scene, error, [](const std::string& what) { fmt::print(stderr, "{} ...\n", what); }));
      show(bench::budgets_table(report.errors.back()));
      show(bench::times_table(report.errors.back()));
      break;
    case bench::Measurement::done:
      break;
    }
  }
  return report;
}

int run(const bench::Options& options) {
  if (options.measurement == bench::Measurement::done) return options.exit_code;
  const bench::Report report = measure(options);
  if (!options.json) return 0;
  replace_file(*options.json, [&](const fs::path& temporary) {
    std::ofstream file(temporary);
    file << bench::to_json_text(report);
    if (!file.flush()) throw std::runtime_error("the disk is full");
  });
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  try {
    return run(bench::parse_command_line(argc, argv));
  } catch (const ReadError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return kExitUsage;
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "abbe bench: {}\n", error.what());
    return kExitUsage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "abbe bench: {}\n", error.what());
    return kExitFailure;
  }
}
