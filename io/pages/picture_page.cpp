#include "io/pages/picture_page.h"

#include "core/scene/user_error.h"
#include "io/files/atomic_file.h"
#include "io/images/read_picture.h"
#include "io/pages/packed_tile.h"
#include "io/pages/page_files.h"
#include "io/text/json.h"
#include "spectral/band_colors.h"
#include "spectral/line_lamp.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>
#include <string>

namespace abbe {
namespace {

namespace fs = std::filesystem;

constexpr int kTileSize = 128;

/// Beyond so many values of bands in all, a page keeps 8 bits of each. With 16 bits it would come
/// to more than 150 MB.
constexpr std::size_t kMostFineValues = std::size_t{30} << 20;

/// What a page shows of one file.
struct Source {
  fs::path file;
  PictureHeader header;
  std::vector<std::string> layers; ///< the names of further channels
  std::vector<Xyz> band_colors;
};

/// True for channels that are pictures of their own: no colours of the whole, no bands, no ids.
bool is_layer(const std::string& name) {
  return !name.starts_with("Crypto") && !name.starts_with("S0.") && !name.starts_with("S1.") &&
         !name.starts_with("S2.") && !name.starts_with("S3.") && !name.starts_with("T.") &&
         name != "R" && name != "G" && name != "B" && name != "A" && name != "Y";
}

Source open_source(const fs::path& file) {
  Source source{file, read_picture_header(file), {}, {}};
  const PictureHeader& header = source.header;
  if (!header.has_color && header.wavelengths_nm.empty())
    throw UserError(
        fmt::format("{}: it has neither channels R, G and B, nor Y, nor bands", file.string()));
  for (const PictureChannel& channel : header.channels)
    if (header.format == "OpenEXR" && is_layer(channel.name)) source.layers.push_back(channel.name);
  source.band_colors = colors_of_bands(header.wavelengths_nm, Observer::cie1931_2deg);
  return source;
}

/// Writes to a stream and counts what it writes.
class Page {
public:
  explicit Page(const fs::path& file) : out_(file, std::ios::binary) {}

  void add(std::string_view text) {
    out_ << text;
    bytes_ += text.size();
  }
  [[nodiscard]] std::uintmax_t bytes() const { return bytes_; }
  void close() {
    out_.close();
    if (!out_) throw std::runtime_error("the disk is full or fails");
  }

private:
  std::ofstream out_;
  std::uintmax_t bytes_ = 0;
};

/// The values of one tile out of the rows that were read.
TileValues tile_of(const PictureValues& rows, const Source& source, const PixelWindow& tile) {
  TileValues values;
  values.pixels = tile.pixel_count();
  const std::size_t bands = source.band_colors.size(), layers = source.layers.size();
  const auto take = [](std::vector<float>& to, const std::vector<float>& from, std::size_t pixel,
                       std::size_t count) {
    const auto first = from.begin() + static_cast<std::ptrdiff_t>(pixel * count);
    to.insert(to.end(), first, first + static_cast<std::ptrdiff_t>(count));
  };
  for_each_pixel(tile, [&](int x, int y) {
    const std::size_t pixel = rows.part.index(x, y);
    take(values.bands, rows.bands, pixel, bands);
    take(values.layers, rows.layers, pixel, layers);
    if (source.header.has_color) return take(values.rgb, rows.rgb, pixel, 3);
    Xyz sum;
    for (std::size_t band = 0; band < bands; ++band)
      sum += source.band_colors[band] * static_cast<double>(rows.bands[pixel * bands + band]);
    const LinearRgb c = to_linear_srgb(sum);
    for (const double v : {c.r, c.g, c.b})
      values.rgb.push_back(static_cast<float>(v));
  });
  return values;
}

/// Adds the tiles of a picture and returns the lengths of their streams, as JSON.
std::string add_tiles(Page& page, const Source& source, std::size_t number, BandBits bits) {
  const PixelWindow& data = source.header.data;
  std::string lengths;
  std::size_t tile_number = 0;
  for (int y = data.y0; y < data.y1; y += kTileSize) {
    const PixelWindow row{data.x0, y, data.x1, std::min(y + kTileSize, data.y1)};
    const PictureValues rows = read_picture(
        source.file, {.rows = RowRange{row.y0, row.y1}, .bands = true, .channels = source.layers});
    for (int x = data.x0; x < data.x1; x += kTileSize) {
      const PixelWindow tile{x, row.y0, std::min(x + kTileSize, data.x1), row.y1};
      page.add(fmt::format("<script type=\"text/plain\" id=\"tile-{}-{}\">", number, tile_number));
      lengths += tile_number > 0 ? ",[" : "[";
      std::string separator;
      for (const std::string& stream : packed_streams(tile_of(rows, source, tile), bits)) {
        page.add(stream);
        lengths += fmt::format("{}{}", separator, stream.size());
        separator = ",";
      }
      lengths += "]";
      page.add("</script>\n");
      ++tile_number;
    }
  }
  return lengths;
}

std::string json_colors(const std::vector<Xyz>& colors) {
  std::vector<double> numbers;
  for (const Xyz& c : colors)
    numbers.insert(numbers.end(), {c.x, c.y, c.z});
  return json_list(numbers);
}

std::string metadata_of(const PictureHeader& header, std::string_view name) {
  for (const auto& [key, value] : header.metadata)
    if (key == name) return value;
  return "";
}

std::string described(const Source& source, BandBits bits, const std::string& lengths) {
  const PictureHeader& header = source.header;
  std::string layers;
  for (const std::string& name : source.layers)
    layers += (layers.empty() ? "" : ", ") + json_string(name);
  return fmt::format(
      "{{\"name\": {}, \"x0\": {}, \"y0\": {}, \"width\": {}, \"height\": {}, \"tileSize\": {}, "
      "\"nm\": {}, \"bandColors\": {}, \"bits\": {}, \"layers\": [{}], \"lightGroup\": {}, "
      "\"lengths\": [{}]}}",
      json_string(source.file.filename().string()), header.data.x0, header.data.y0,
      header.data.width(), header.data.height(), kTileSize, json_list(header.wavelengths_nm),
      json_colors(source.band_colors), static_cast<int>(bits), layers,
      json_string(metadata_of(header, "abbe/lightGroup")), lengths);
}

/// The colours of single wavelengths, nm by nm from 380 to 780, of which the page draws the
/// boundary of all chromaticities and finds dominant wavelengths.
std::string locus() {
  std::vector<Xyz> colors;
  for (int nm = 380; nm <= 780; ++nm)
    colors.push_back(to_xyz(line_lamp(nm)));
  return json_colors(colors);
}

/// JSON within an element of a page: no "</" may stand in it.
std::string within_page(std::string json) {
  for (std::size_t at = json.find('<'); at != json.npos; at = json.find('<', at))
    json.replace(at, 1, "\\u003c");
  return json;
}

} // namespace

PageSummary write_picture_page(const fs::path& target, const std::vector<fs::path>& pictures) {
  std::vector<Source> sources;
  std::size_t band_values = 0;
  for (const fs::path& file : pictures) {
    sources.push_back(open_source(file));
    band_values +=
        sources.back().header.data.pixel_count() * sources.back().header.wavelengths_nm.size();
  }
  const BandBits bits = band_values > kMostFineValues ? BandBits::eight : BandBits::sixteen;
  PageSummary summary{sources.size(), 0, band_values > 0 ? largest_error(bits) : 0.0};
  replace_file(target, [&](const fs::path& temporary) {
    Page page(temporary);
    const std::string_view frame = page_file("view.html");
    const auto part = [&](std::string_view from, std::string_view to) {
      const std::size_t begin = from.empty() ? 0 : frame.find(from) + from.size();
      return frame.substr(begin, to.empty() ? frame.npos : frame.find(to) - begin);
    };
    page.add(part("", "/*style*/"));
    page.add(page_file("page.css"));
    page.add(page_file("view.css"));
    page.add(part("/*style*/", "<!--data-->"));
    std::string descriptions;
    for (std::size_t i = 0; i < sources.size(); ++i)
      descriptions +=
          (i > 0 ? ",\n" : "") + described(sources[i], bits, add_tiles(page, sources[i], i, bits));
    page.add("<script type=\"application/json\" id=\"index\">");
    page.add(within_page(fmt::format("{{\"locus\": {}, \"bandError\": {}, \"pictures\": [{}]}}",
                                     locus(), json_number(summary.band_error), descriptions)));
    page.add("</script>\n");
    page.add(part("<!--data-->", "/*script*/"));
    for (const char* script : {"color.js", "tiles.js", "picture.js", "lights.js", "screen.js",
                               "charts.js", "readings.js", "view.js", "input.js"})
      page.add(page_file(script));
    page.add(part("/*script*/", ""));
    page.close();
    summary.bytes = page.bytes();
  });
  return summary;
}

} // namespace abbe
