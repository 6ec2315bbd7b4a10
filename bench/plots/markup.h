#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace abbe::bench {

/// The text with what means something in XML replaced by entities.
[[nodiscard]] std::string escaped(std::string_view text);

/// A coordinate in an image: two digits behind the point, no trailing zeros. Throws
/// std::invalid_argument for what is not finite.
[[nodiscard]] std::string coordinate(double value);

/// Writes XML: what is opened is closed in the right order, texts and values are escaped.
class Markup {
public:
  struct Attribute {
    std::string_view name;
    std::string value;
  };
  using Attributes = std::initializer_list<Attribute>;

  void open(std::string_view tag, Attributes attributes = {});
  void close();
  /// An element without content.
  void element(std::string_view tag, Attributes attributes);
  /// An element that holds text.
  void text(std::string_view tag, Attributes attributes, std::string_view content);
  /// Adds what is markup already.
  void raw(std::string_view markup) { text_ += markup; }

  /// All of it; what is open is closed.
  [[nodiscard]] std::string finish();

private:
  void begin(std::string_view tag, Attributes attributes);

  std::string text_;
  std::vector<std::string> open_;
};

} // namespace abbe::bench
