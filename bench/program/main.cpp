#include "bench/program/measure.h"
#include "bench/reports/compare.h"
#include "bench/reports/write_html.h"
#include "io/console/exit_codes.h"
#include "io/files/atomic_file.h"
#include "io/text/token.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace {

using namespace abbe;

constexpr int kBadNews = 1; ///< exit code: something became slower, or a skip changes an image

void show(const bench::Table& table) {
  fmt::print("{}", bench::to_text(table));
  std::fflush(stdout);
}

void tell(const std::string& what) {
  fmt::print(stderr, "{} ...\n", what);
}

void write(const std::filesystem::path& path, const std::string& text) {
  replace_file(path, [&](const std::filesystem::path& temporary) {
    std::ofstream file(temporary);
    file << text;
    if (!file.flush()) throw std::runtime_error("the disk is full");
  });
}

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (!file) throw UserError(fmt::format("cannot read {}", path.string()));
  return text;
}

int run(const bench::Options& options) {
  if (options.measurement == bench::Measurement::done) return options.exit_code;
  if (options.measurement == bench::Measurement::compare) {
    const bench::Comparison comparison =
        bench::compare(read(options.reports[0]), read(options.reports[1]), options.margin);
    show(bench::table_of(comparison));
    return comparison.slower() ? kBadNews : 0;
  }
  const bench::Report report = bench::measure(options, show, tell);
  if (options.json) write(*options.json, bench::to_json_text(report));
  const std::vector<bench::Section> sections = bench::sections_of(report);
  if (options.html) write(*options.html, bench::to_html(sections));
  if (options.plots)
    for (const bench::Section& section : sections)
      for (const bench::NamedPlot& plot : section.plots)
        write(*options.plots / (plot.name + ".svg"), plot.svg);
  const auto changed = [](const bench::SkipCosts& costs) { return costs.changed(); };
  return std::any_of(report.plans.begin(), report.plans.end(), changed) ? kBadNews : 0;
}

} // namespace

int main(int argc, char** argv) {
  try {
    return run(bench::parse_command_line(argc, argv));
  } catch (const ReadError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return kExitUsage;
  } catch (const UserError& error) {
    fmt::print(stderr, "abbe bench: {}\n", error.what());
    return kExitUsage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "abbe bench: {}\n", error.what());
    return kExitFailure;
  }
}
