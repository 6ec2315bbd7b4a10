#include "io/plots/plot.h"

#include "core/scene/user_error.h"
#include "io/commands/list_plot.h"
#include "spectral/line_lamp.h"
#include "spectral/metal.h"
#include "tests/catch.h"

#include <algorithm>
#include <sstream>

using namespace abbe;

namespace {

Plot plot_of(const Curve& curve, bool from_zero = true) {
  return {"title", [curve](int count) { return means_of(curve, count); }, from_zero};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

std::size_t columns(const std::string& line) {
  return static_cast<std::size_t>(
      std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

ListCommand asked(const std::string& name, const std::string& what = "") {
  ListCommand command;
  command.plot_name = name;
  command.what = what;
  return command;
}

} // namespace

TEST_CASE("a plot in characters fits 80 columns and has an axis in nm") {
  const auto lines = lines_of(plot_text(plot_of(Curve::table({380, 780}, {0.0, 2.0}))));
  REQUIRE(lines.size() == 19);
  CHECK(lines[0] == "title");
  for (const std::string& line : lines)
    CHECK(columns(line) <= 83); // the unit stands after the field
  for (const char* nm : {"400", "500", "600", "700", "nm"})
    CHECK(lines[18].find(nm) != std::string::npos);
  CHECK(count(lines[17], "┬") == 4);
  CHECK(lines[1].find("1.9") < lines[1].find("┤")); // the middle of the last column
  // A ramp: few full blocks on top, nearly all at the bottom.
  CHECK(count(lines[1], "█") <= 3);
  CHECK(count(lines[16], "█") >= 60);
}

TEST_CASE("a constant fills the field, a line is one bar, black is empty") {
  CHECK(count(plot_text(plot_of(Curve::constant(1.0))), "█") == 16 * 68);
  CHECK(count(plot_text(plot_of(line_lamp(550.0))), "█") == 16);
  CHECK(count(plot_text(plot_of(Curve::constant(0.0))), "█") == 0);
}

TEST_CASE("the axis of an index begins a little below its least value") {
  const PlotRange range = range_of({1.5, 1.6}, false);
  CHECK(range.lowest == Approx(1.495));
  CHECK(range.highest == 1.6);
  CHECK(range_of({0.2, 0.4}, true).lowest == 0.0);
}

TEST_CASE("a plot as a picture has its curve where the values are") {
  const DisplayImage image = plot_image(plot_of(Curve::constant(1.0)));
  CHECK(image.data.width() == 900);
  CHECK(image.data.height() == 420);
  REQUIRE(image.encoded.size() == 900u * 420u * 3u);
  const auto grey = [&](int x, int y) { return image.encoded[3u * (y * 900u + x)]; };
  CHECK(grey(475, 15) < 0.2f);  // the curve, at the top
  CHECK(grey(475, 200) > 0.2f); // under it
  CHECK(grey(475, 200) < 0.9f);
  CHECK(grey(475, 5) == 1.0f); // above it, paper
}

TEST_CASE("--plot finds lights, metals and glasses by name") {
  CHECK(find_plot(asked("blackbody(3000)")).title == "blackbody(3000): light per nm, 1 = equal "
                                                     "energy");
  const Plot gold = find_plot(asked("au", "metals"));
  CHECK(gold.title == "Au: reflectance at normal incidence in air");
  CHECK(gold.values(81)[0] == Approx(0.402130).margin(1e-6)); // conductors_81.csv
  const Plot glass = find_plot(asked("n-bk7"));
  CHECK(glass.values(405).front() > glass.values(405).back());
  CHECK_FALSE(glass.from_zero);
  REQUIRE_THROWS_WITH(find_plot(asked("N-BK8", "glasses")),
                      "there is nothing called \"N-BK8\" to plot. Did you mean N-BK7?");
  REQUIRE_THROWS_AS(find_plot(asked("N-BK7", "lights")), UserError);
}
