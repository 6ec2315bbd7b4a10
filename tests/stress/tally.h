#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace abbe::stress {

/// What a part of the stress suite has tried and found, by name. Names have no spaces.
class Tally {
public:
  /// Something was tried, or found and is allowed.
  void count(const std::string& name, std::uint64_t times = 1) { counts_[name] += times; }
  /// Keeps the largest value under a name.
  void worst(const std::string& name, double value);
  /// Something failed. `reproduction` tells in one line all that is needed to see it again.
  void fail(const std::string& name, const std::string& reproduction);

  void add(const Tally& other);
  [[nodiscard]] bool passes() const { return failed_.empty(); }
  [[nodiscard]] std::uint64_t rounds() const { return rounds_; }
  void rounds_done(std::uint64_t rounds, double seconds);

  /// One line for each name; the same that `read` takes.
  [[nodiscard]] std::string text() const;
  /// An empty tally where there is no file. Throws std::runtime_error for a file of another kind.
  [[nodiscard]] static Tally read(const std::filesystem::path& file);
  /// Replaces the file at once, so that a run that is ended leaves a whole one.
  void write(const std::filesystem::path& file) const;

private:
  std::uint64_t rounds_ = 0;
  double seconds_ = 0.0;
  std::map<std::string, std::uint64_t> counts_, failed_;
  std::map<std::string, double> worst_;
  std::vector<std::string> reproductions_; ///< of the first failures of each name
};

} // namespace abbe::stress
