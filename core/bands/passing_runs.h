#pragma once

#include "core/bands/band_math.h"
#include "core/bands/band_span.h"

namespace abbe {

/// The runs of neighbouring bands whose value is above 0, from the lowest band to the highest:
/// `for (BandRange run : PassingRuns(values))`. Bands under total reflection and bands without
/// power have no refracted ray. The others usually form one run, and more where n(lambda) turns.
class PassingRuns {
public:
  explicit PassingRuns(BandSpan<const float> values) : values_(values) {}

  struct End {};
  class Iterator {
  public:
    explicit Iterator(BandSpan<const float> rest) : rest_(rest) { find(); }

    [[nodiscard]] BandRange operator*() const { return run_; }
    Iterator& operator++() {
      rest_.bands.first = run_.last;
      find();
      return *this;
    }
    [[nodiscard]] bool operator==(End) const { return run_.empty(); }

  private:
    void find() {
      const int end = rest_.bands.last;
      int first = rest_.bands.first;
      while (first < end && !(rest_[first] > 0.0f))
        ++first;
      int last = all_above_zero(rest_.of({first, end})) ? end : first;
      while (last < end && rest_[last] > 0.0f)
        ++last;
      run_ = {first, last};
    }

    BandSpan<const float> rest_; ///< begins with the current run
    BandRange run_;              ///< empty behind the last run
  };

  [[nodiscard]] Iterator begin() const { return Iterator(values_); }
  [[nodiscard]] End end() const { return {}; }

private:
  BandSpan<const float> values_;
};

} // namespace abbe
