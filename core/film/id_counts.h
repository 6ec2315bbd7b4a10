#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace abbe {

/// How many samples of a pixel met the thing with this number.
struct IdCount {
  std::uint32_t id = 0, count = 0;
  friend bool operator==(const IdCount&, const IdCount&) = default;
};

/// For each pixel, the numbers that its samples met and how often. No pair is dropped, so the
/// counts do not depend on the order in which samples come. A pixel takes 16 bytes, and more only
/// where its samples met several things.
class IdCounts {
public:
  /// No pixels.
  IdCounts() = default;
  explicit IdCounts(std::size_t pixels) : pixels_(pixels) {}

  /// Two threads must not add to one pixel at once.
  void add(std::size_t pixel, std::uint32_t id, std::uint32_t count = 1);

  /// The pairs of a pixel, the most frequent first; of equally frequent ones the smallest number.
  [[nodiscard]] std::vector<IdCount> of(std::size_t pixel) const;

private:
  struct Pixel {
    IdCount first;
    std::unique_ptr<std::vector<IdCount>> more; ///< null where the samples met one thing
  };
  std::vector<Pixel> pixels_;
};

} // namespace abbe
