#include "core/emitters/cell_choice.h"

#include <algorithm>
#include <cassert>

namespace abbe {
namespace {

constexpr double kBelowOne = 1.0 - 0x1p-53;

struct Part {
  std::size_t index;
  double inside;
};

/// Which of the parts, whose sums are given, holds the fraction u of their total.
Part part_at(const double* sums, std::size_t count, double u) {
  const double goal = u * sums[count - 1];
  const double* chosen = std::upper_bound(sums, sums + count - 1, goal);
  const double below = chosen == sums ? 0.0 : *(chosen - 1);
  const double inside = *chosen > below ? (goal - below) / (*chosen - below) : 0.0;
  return {static_cast<std::size_t>(chosen - sums), std::clamp(inside, 0.0, kBelowOne)};
}

} // namespace

CellChoice::CellChoice(const std::vector<double>& weights, std::size_t columns)
    : columns_(columns), cells_(weights) {
  double total = 0.0;
  for (std::size_t first = 0; first < weights.size(); first += columns) {
    for (std::size_t i = 1; i < columns; ++i)
      cells_[first + i] += cells_[first + i - 1];
    total += cells_[first + columns - 1];
    rows_.push_back(total);
  }
  assert(total > 0.0);
}

CellChoice::Choice CellChoice::choose(const dvec2& u) const {
  const Part row = part_at(rows_.data(), rows_.size(), u.y);
  const Part column = part_at(cells_.data() + row.index * columns_, columns_, u.x);
  return {row.index, column.index, {column.inside, row.inside}};
}

} // namespace abbe
