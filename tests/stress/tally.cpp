#include "tests/stress/tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace abbe::stress {

namespace {
constexpr std::uint64_t kKept = 500000; ///< reproductions of failures of one name
} // namespace

void Tally::worst(const std::string& name, double value) {
  const auto [place, is_new] = worst_.try_emplace(name, value);
  if (!is_new && !(value <= place->second)) place->second = value; // a NaN is the worst of all
}

void Tally::fail(const std::string& name, const std::string& reproduction) {
  if (++failed_[name] <= kKept) reproductions_.push_back(name + " " + reproduction);
}

void Tally::add(const Tally& other) {
  rounds_ += other.rounds_;
  seconds_ += other.seconds_;
  for (const auto& [name, times] : other.counts_)
    counts_[name] += times;
  for (const auto& [name, value] : other.worst_)
    worst(name, value);
  for (const std::string& line : other.reproductions_)
    if (failed_[line.substr(0, line.find(' '))] < kKept) reproductions_.push_back(line);
  for (const auto& [name, times] : other.failed_)
    failed_[name] += times;
}

void Tally::rounds_done(std::uint64_t rounds, double seconds) {
  rounds_ += rounds;
  seconds_ += seconds;
}

std::string Tally::text() const {
  std::string text = fmt::format("rounds {}\nseconds {:.1f}\n", rounds_, seconds_);
  for (const auto& [name, times] : counts_)
    text += fmt::format("count {} {}\n", name, times);
  for (const auto& [name, value] : worst_)
    text += fmt::format("worst {} {:.17g}\n", name, value);
  for (const auto& [name, times] : failed_)
    text += fmt::format("failed {} {}\n", name, times);
  for (const std::string& line : reproductions_)
    text += fmt::format("failure {}\n", line);
  return text;
}

Tally Tally::read(const std::filesystem::path& file) {
  Tally tally;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind, name;
    words >> kind;
    if (kind == "rounds")
      words >> tally.rounds_;
    else if (kind == "seconds")
      words >> tally.seconds_;
    else if (kind == "count")
      words >> name >> tally.counts_[name];
    else if (kind == "failed")
      words >> name >> tally.failed_[name];
    else if (kind == "failure")
      tally.reproductions_.push_back(line.substr(kind.size() + 1));
    else if (kind == "worst") {
      std::string value; // which may be "inf" or "nan"
      words >> name >> value;
      tally.worst_[name] = std::stod(value);
    } else
      throw std::runtime_error(file.string() + " is not a file of counts");
  }
  return tally;
}

void Tally::write(const std::filesystem::path& file) const {
  std::filesystem::path partial = file;
  partial += ".partial";
  {
    std::ofstream out(partial);
    out << text();
    if (!out.flush()) throw std::runtime_error("cannot write " + partial.string());
  }
  std::filesystem::rename(partial, file);
}

} // namespace abbe::stress
