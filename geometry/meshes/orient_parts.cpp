#include "geometry/meshes/orient_parts.h"

#include "geometry/meshes/edge_table.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

namespace abbe {
namespace {

/// Sets of numbers that grow together: find with path halving.
class Groups {
public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  [[nodiscard]] std::size_t of(std::size_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[of(a)] = of(b); }

private:
  std::vector<std::size_t> parent_;
};

/// What the triangles of one edge that more than two of them share have in common.
struct Junction {
  std::vector<std::pair<std::size_t, int>> patches; ///< and the sense in which each runs along it
};

/// Finds the orientation of one mesh.
class Orienting {
public:
  explicit Orienting(const Mesh& mesh)
      : mesh_(mesh), table_(mesh.vertices().size(), mesh.triangles()),
        patch_(mesh.triangles().size(), kNone), sense_(mesh.triangles().size(), 1) {
    flood();
    collect_junctions();
    balance_junctions();
    count_open_edges();
    if (found_.open_edges == 0 && !found_.one_sided) turn_parts();
    found_.turn.resize(sense_.size());
    for (std::size_t t = 0; t < sense_.size(); ++t)
      found_.turn[t] = sense_[t] * patch_sense_[patch_[t]] < 0;
  }
  [[nodiscard]] PartOrientation take() { return std::move(found_); }

private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Gives triangles that share an edge with no third one the same sense and patch.
  void flood() {
    std::vector<std::array<std::int32_t, 3>> neighbours(sense_.size(), {-1, -1, -1});
    std::vector<std::array<bool, 3>> alike(sense_.size());
    table_.for_each_edge([&](std::span<const TriangleSide> edge) {
      if (edge.size() != 2) return;
      for (std::size_t k = 0; k < 2; ++k) {
        const auto t = static_cast<std::size_t>(edge[k].triangle);
        const auto side = static_cast<std::size_t>(edge[k].side);
        neighbours[t][side] = edge[1 - k].triangle;
        alike[t][side] = edge[0].forward != edge[1].forward;
      }
    });
    std::vector<std::size_t> waiting, members;
    for (std::size_t first = 0; first < sense_.size(); ++first) {
      if (patch_[first] != kNone) continue;
      const std::size_t patch = patch_sense_.size();
      patch_[first] = patch;
      waiting = members = {first};
      std::size_t kept = 1;
      while (!waiting.empty()) {
        const std::size_t t = waiting.back();
        waiting.pop_back();
        for (std::size_t side = 0; side < 3; ++side) {
          if (neighbours[t][side] < 0) continue;
          const auto other = static_cast<std::size_t>(neighbours[t][side]);
          const int sense = alike[t][side] ? sense_[t] : -sense_[t];
          if (patch_[other] != kNone) {
            found_.one_sided = found_.one_sided || sense_[other] != sense;
            continue;
          }
          patch_[other] = patch;
          sense_[other] = static_cast<std::int8_t>(sense);
          kept += sense > 0 ? 1 : 0;
          waiting.push_back(other);
          members.push_back(other);
        }
      }
      patch_sense_.push_back(2 * kept >= members.size() ? 1 : -1);
    }
  }

  void collect_junctions() {
    at_.resize(patch_sense_.size());
    table_.for_each_edge([&](std::span<const TriangleSide> edge) {
      if (edge.size() <= 2 || edge.size() % 2 != 0) return;
      Junction junction;
      for (const TriangleSide& side : edge) {
        const auto t = static_cast<std::size_t>(side.triangle);
        const int along = side.forward ? sense_[t] : -sense_[t];
        const auto known = std::find_if(junction.patches.begin(), junction.patches.end(),
                                        [&](const auto& p) { return p.first == patch_[t]; });
        if (known == junction.patches.end())
          junction.patches.emplace_back(patch_[t], along);
        else
          known->second += along;
      }
      std::erase_if(junction.patches, [](const auto& p) { return p.second == 0; });
      if (junction.patches.empty()) return;
      for (const auto& [patch, along] : junction.patches)
        at_[patch].push_back(junctions_.size());
      junctions_.push_back(std::move(junction));
    });
  }

  [[nodiscard]] int imbalance(const Junction& junction) const {
    int sum = 0;
    for (const auto& [patch, along] : junction.patches)
      sum += along * patch_sense_[patch];
    return std::abs(sum);
  }

  /// Turns patches as long as that brings the edges where they meet nearer to a balance.
  void balance_junctions() {
    std::vector<std::size_t> waiting;
    for (std::size_t patch = 0; patch < patch_sense_.size(); ++patch)
      if (!at_[patch].empty()) waiting.push_back(patch);
    while (!waiting.empty()) {
      const std::size_t patch = waiting.back();
      waiting.pop_back();
      const auto sum = [&] {
        int all = 0;
        for (const std::size_t j : at_[patch])
          all += imbalance(junctions_[j]);
        return all;
      };
      const int before = sum();
      patch_sense_[patch] = -patch_sense_[patch];
      if (sum() >= before) {
        patch_sense_[patch] = -patch_sense_[patch];
        continue;
      }
      for (const std::size_t j : at_[patch])
        for (const auto& [other, along] : junctions_[j].patches)
          if (other != patch) waiting.push_back(other);
    }
  }

  void count_open_edges() {
    table_.for_each_edge([&](std::span<const TriangleSide> edge) {
      int sum = 0;
      for (const TriangleSide& side : edge) {
        const auto t = static_cast<std::size_t>(side.triangle);
        const int sense = sense_[t] * patch_sense_[patch_[t]];
        sum += side.forward ? sense : -sense;
      }
      if (sum == 0) return;
      if (found_.open_edges++ > 0) return;
      found_.open_from = mesh_.vertices()[static_cast<std::size_t>(edge[0].lower)];
      found_.open_to = mesh_.vertices()[static_cast<std::size_t>(edge[0].upper)];
    });
  }

  /// Patches that need each other to be closed are one part.
  void turn_parts() {
    Groups groups(patch_sense_.size());
    for (const Junction& junction : junctions_)
      for (const auto& [patch, along] : junction.patches)
        groups.join(patch, junction.patches[0].first);
    struct Part {
      double volume = 0.0; ///< times six
      std::vector<std::size_t> triangles;
      bool turn = false;
    };
    std::vector<Part> parts(patch_sense_.size());
    const dvec3& origin = mesh_.vertices()[0];
    for (std::size_t t = 0; t < sense_.size(); ++t) {
      Part& part = parts[groups.of(patch_[t])];
      const auto [a, b, c] = mesh_.corners(static_cast<int>(t));
      part.volume += sense_[t] * patch_sense_[patch_[t]] *
                     glm::dot(a - origin, glm::cross(b - origin, c - origin));
      part.triangles.push_back(t);
    }
    const bool alone = std::count_if(parts.begin(), parts.end(),
                                     [](const Part& part) { return !part.triangles.empty(); }) == 1;
    for (Part& part : parts) {
      if (part.volume == 0.0) continue;
      part.turn = part.volume < 0.0;
      if (!alone && lies_inside(part.triangles, part.turn)) part.turn = !part.turn;
    }
    for (std::size_t patch = 0; patch < patch_sense_.size(); ++patch)
      if (parts[groups.of(patch)].turn) patch_sense_[patch] = -patch_sense_[patch];
  }

  /// True where a part lies inside an odd number of others: it does so beside each of a few of its
  /// triangles. Beside one that touches another part this says nothing, so one is not enough.
  [[nodiscard]] bool lies_inside(const std::vector<std::size_t>& triangles, bool turned) const {
    constexpr std::size_t kAsked = 16;
    const std::size_t step = std::max<std::size_t>(1, triangles.size() / kAsked);
    for (std::size_t i = 0; i < triangles.size(); i += step)
      if (!lies_inside_beside(triangles[i], turned)) return false;
    return true;
  }

  /// The same for the place outside the part, next to one of its triangles. From there to far away
  /// a ray crosses its own part an even number of times.
  [[nodiscard]] bool lies_inside_beside(std::size_t triangle, bool turned) const {
    const auto face = static_cast<std::int32_t>(triangle);
    const auto [a, b, c] = mesh_.corners(face);
    const bool inwards = (sense_[triangle] * patch_sense_[patch_[triangle]] < 0) != turned;
    const dvec3 normal = outward_normal(mesh_, a, face);
    LocalRay ray;
    ray.origin = (a + b + c) / 3.0;
    ray.direction = inwards ? -normal : normal;
    // Exits and entries as the triangles have it now; their sum is odd where their difference is.
    const MeshCrossings ahead = first_crossings(mesh_, ray, {&face, 1}, MeshSearch::sum);
    return ahead.exits_less_entries % 2 != 0;
  }

  const Mesh& mesh_;
  EdgeTable table_;
  std::vector<std::size_t> patch_; ///< of each triangle
  std::vector<std::int8_t> sense_; ///< of each triangle within its patch
  std::vector<int> patch_sense_;
  std::vector<Junction> junctions_;
  std::vector<std::vector<std::size_t>> at_; ///< the junctions of each patch
  PartOrientation found_;
};

} // namespace

PartOrientation orient_parts(const Mesh& mesh) {
  return Orienting(mesh).take();
}

} // namespace abbe
