#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <vector>

namespace abbe {

using glm::dvec2;

/// Chooses cells of a grid in proportion to their weights.
class CellChoice {
public:
  /// `weights` are rows of `columns` values, none negative, with a sum above 0.
  CellChoice(const std::vector<double>& weights, std::size_t columns);

  /// A cell and a place inside it, from two numbers in [0, 1): neighbouring numbers stay
  /// neighbours, so strata are kept.
  struct Choice {
    std::size_t row, column;
    dvec2 inside; ///< x along the columns, y along the rows, each in [0, 1)
  };
  [[nodiscard]] Choice choose(const dvec2& u) const;

  [[nodiscard]] double total() const { return rows_.back(); }

private:
  std::size_t columns_;
  std::vector<double> rows_;  ///< sums of the rows up to and with each
  std::vector<double> cells_; ///< in each row the sums of its cells up to and with each
};

} // namespace abbe
