#include "bench/plots/markup.h"
#include "bench/plots/plot.h"
#include "bench/plots/plot_frame.h"
#include "tests/bench/well_formed.h"
#include "tests/catch.h"

#include <stdexcept>

using namespace abbe;
using namespace abbe::bench;
using test::values_of;
using test::xml_mistake;

namespace {

std::vector<std::string> labels(const PlotAxis& axis) {
  std::vector<std::string> result;
  for (const Tick& tick : axis.ticks())
    if (!tick.label.empty()) result.push_back(tick.label);
  return result;
}

LinePlot line_plot(const std::vector<PlotPoint>& points) {
  return {"a <title> & \"more\"", "x", "y", Scale::logarithmic, Scale::logarithmic,
          {{"l", points}}};
}

} // namespace

TEST_CASE("the reader of XML finds mistakes") {
  CHECK(xml_mistake("<a><b c=\"1\" d=\"x y\"/>t &amp; u</a>\n").empty());
  for (const char* bad : {"<a>", "<a></b>", "</a>", "<a b=1/>", "<a b=\"&\"/>", "<a>&</a>", "<a/>t",
                          "<a/><a/>", "<a b=\"1\"c=\"2\"/>", "<a b=\"1/>", "<a"}) {
    INFO(bad);
    CHECK_FALSE(xml_mistake(bad).empty());
  }
}

TEST_CASE("markup closes what is open and escapes what has a meaning") {
  Markup m;
  m.open("a", {{"b", "x\"y"}});
  m.open("c");
  m.text("t", {}, "1 < 2 & 3 > 2");
  const std::string text = m.finish();
  CHECK(xml_mistake(text).empty());
  CHECK(text == "<a b=\"x&quot;y\">\n<c>\n<t>1 &lt; 2 &amp; 3 &gt; 2</t>\n</c>\n</a>\n");
}

TEST_CASE("coordinates have two digits and are finite") {
  CHECK(coordinate(1.0) == "1");
  CHECK(coordinate(100.0) == "100");
  CHECK(coordinate(-0.001) == "0");
  CHECK(coordinate(2.346) == "2.35");
  CHECK_THROWS_AS(coordinate(1.0 / 0.0), std::invalid_argument);
  CHECK_THROWS_AS(coordinate(kNone), std::invalid_argument);
}

TEST_CASE("even ticks are at 1, 2 or 5 times a power of ten") {
  const PlotAxis axis({0.3, 4.1}, Scale::even, true);
  CHECK(labels(axis) == std::vector<std::string>{"0", "1", "2", "3", "4", "5"});
  CHECK(axis.place(0.0) == 0.0);
  CHECK(axis.place(2.5) == 0.5);
  CHECK(labels(PlotAxis({10.0, 11.0}, Scale::even, false)) ==
        std::vector<std::string>{"10", "10.2", "10.4", "10.6", "10.8", "11"});
  CHECK(labels(PlotAxis({1.0, 3.0}, Scale::whole, false)) ==
        std::vector<std::string>{"1", "2", "3"});
  CHECK(labels(PlotAxis({-3.0, 5.0}, Scale::even, true)).front() == "-4");
}

TEST_CASE("logarithmic ticks are decades, with more labels where there is room") {
  const PlotAxis wide({1e-3, 10.0}, Scale::logarithmic, false);
  CHECK(labels(wide) == std::vector<std::string>{"0.001", "0.01", "0.1", "1", "10"});
  CHECK(wide.ticks().size() == 5 + 4 * 8);
  CHECK(wide.place(0.1) == Approx(0.5));
  const PlotAxis narrow({3.0, 60.0}, Scale::logarithmic, false);
  CHECK(labels(narrow) == std::vector<std::string>{"5", "10", "20", "50"});
  CHECK(narrow.lower() == 3.0);
  CHECK(narrow.upper() == 60.0);
  CHECK_FALSE(narrow.shows(0.0));
  CHECK(labels(PlotAxis({1e-4, 1e-3}, Scale::logarithmic, false)) ==
        std::vector<std::string>{"1e-4", "2e-4", "5e-4", "0.001"});
  CHECK(labels(PlotAxis({1e4, 1e7}, Scale::logarithmic, false)) ==
        std::vector<std::string>{"10000", "1e5", "1e6", "1e7"});
}

TEST_CASE("an axis without values, or with one, has two ends") {
  for (const Scale scale : {Scale::even, Scale::whole, Scale::logarithmic})
    for (const std::vector<double>& values :
         {std::vector<double>{}, std::vector{1.0}, std::vector{7.0}, std::vector{kNone}}) {
      const PlotAxis axis(values, scale, false);
      CHECK(axis.upper() > axis.lower());
      CHECK(axis.ticks().size() >= 2);
    }
}

TEST_CASE("a plot of lines is XML, and shows each point that it can") {
  const std::string svg = to_svg(line_plot(
      {{1.0, {1.0}}, {10.0, {0.1, 0.05, 0.2}}, {100.0, {0.0}}, {1000.0, {kNone}}, {0.0, {1.0}}}));
  CHECK(xml_mistake(svg).empty());
  CHECK(svg.find("a &lt;title&gt; &amp; &quot;more&quot;") != svg.npos);
  CHECK(values_of(svg, "cx").size() == 3); // two points and the legend
  // From the upper left corner to the lower end of x's decade; y begins at the whisker's 0.05.
  const std::string left = coordinate(PlotFrame::x(0.0)), top = coordinate(PlotFrame::y(1.0));
  REQUIRE(values_of(svg, "d").size() == 1);
  CHECK(values_of(svg, "d")[0].starts_with("M" + left + " " + top));
}

TEST_CASE("no plot has a coordinate that is not finite") {
  const LinePlot nothing{"", "", "", Scale::logarithmic, Scale::even, {}};
  const BarPlot no_bars{"", "", {}, {}};
  const BarPlot some{"bars",
                     "y",
                     {"a", "a very long name", "c"},
                     {{"s", {{1.0}, {kNone}, {-2.0}}}, {"t", {{3.0, 2.0, 4.0}}}}};
  const LinePlot gaps{"",          "",
                      "",          Scale::even,
                      Scale::even, {{"l", {{1.0, {kNone}}, {kNone, {1.0}}, {2.0, {3.0}}}}}};
  for (const std::string& svg : {to_svg(nothing), to_svg(gaps), to_svg(no_bars), to_svg(some),
                                 to_svg(line_plot({})), to_svg(line_plot({{5.0, {5.0}}}))}) {
    CHECK(xml_mistake(svg).empty());
    CHECK(svg.find("nan") == svg.npos);
    CHECK(svg.find("inf") == svg.npos);
  }
}

TEST_CASE("bars stand on zero, as high as their values") {
  const std::string svg = to_svg(BarPlot{"", "", {"a", "b"}, {{"s", {{1.0}, {2.0}}}}});
  const auto heights = values_of(svg, "height"); // all, background, frame, legend, bars
  REQUIRE(heights.size() == 6);
  CHECK(heights[4] == coordinate(0.5 * PlotFrame::kHeight));
  CHECK(heights[5] == coordinate(PlotFrame::kHeight));
}
