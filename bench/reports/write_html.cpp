#include "bench/reports/write_html.h"

#include "bench/plots/markup.h"

namespace abbe::bench {
namespace {

constexpr const char* kStyle = "body { font-family: Helvetica, Arial, sans-serif; color: #222222; "
                               "max-width: 72em; margin: 2em auto; padding: 0 1em; }\n"
                               "h2 { font-size: 1.1em; margin-top: 2.5em; }\n"
                               "table { border-collapse: collapse; font-size: 0.9em; }\n"
                               "th, td { padding: 0.2em 0.8em; text-align: right; "
                               "font-variant-numeric: tabular-nums; }\n"
                               "th:first-child, td:first-child { text-align: left; }\n"
                               "thead th { border-bottom: 1px solid #555555; }\n"
                               "svg { max-width: 100%; height: auto; margin: 1em 1em 0 0; }\n";

void add_row(Markup& page, const char* cell, const std::vector<std::string>& cells) {
  page.open("tr");
  for (const std::string& text : cells)
    page.text(cell, {}, text);
  page.close();
}

void add_table(Markup& page, const Table& table) {
  page.text("h2", {}, table.title);
  if (!table.columns.empty()) {
    page.open("table");
    page.open("thead");
    add_row(page, "th", table.columns);
    page.close();
    page.open("tbody");
    for (const auto& row : table.rows)
      add_row(page, "td", row);
    page.close();
    page.close();
  }
  for (const std::string& note : table.notes)
    page.text("p", {}, note);
}

} // namespace

std::string to_html(const std::vector<Section>& sections) {
  Markup page;
  page.raw("<!DOCTYPE html>\n");
  page.open("html", {{"lang", "en"}});
  page.open("head");
  page.element("meta", {{"charset", "utf-8"}});
  page.text("title", {}, "abbe bench");
  page.text("style", {}, kStyle);
  page.close();
  page.open("body");
  page.text("h1", {}, "abbe bench");
  for (const Section& section : sections) {
    page.open("section");
    for (const Table& table : section.tables)
      add_table(page, table);
    for (const NamedPlot& plot : section.plots)
      page.raw(plot.svg);
    page.close();
  }
  return page.finish();
}

} // namespace abbe::bench
