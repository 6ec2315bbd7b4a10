#pragma once

#include "core/lights/light_reach.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace abbe {

/// Chooses one light of many by what each can send to a place. Lights that stand near one another
/// and shine the same way hang in a binary tree, and each step down weighs its two halves
/// [Conty18]. A node bounds what it holds the worse the larger it is, so the walk does not begin at
/// the root: all of a *front* of at most 16 nodes, and light from infinitely far away, are weighed
/// against one another. Up to 16 lights are so chosen by their own irradiances.
class LightHierarchy {
public:
  LightHierarchy() = default;
  explicit LightHierarchy(std::span<const LightReach> lights);

  struct Chosen {
    int light;     ///< index into what the hierarchy was made of
    double chance; ///< of the choice, above 0
  };
  /// By a number in [0, 1). Nothing where no light can arrive.
  [[nodiscard]] std::optional<Chosen> choose(const dvec3& place, double u) const;

  /// The chance with which `choose` would have chosen this light.
  [[nodiscard]] double chance(int light, const dvec3& place) const;

private:
  static constexpr int kNone = -1;
  static constexpr std::size_t kFront = 16;

  /// A light, or two nodes.
  struct Node {
    LightReach reach;
    int parent = kNone;
    int light = kNone;               ///< of a leaf
    int left = kNone, right = kNone; ///< of an inner node
    bool in_front = false;
  };
  /// What the nodes of the front, and behind them distant lights, can send to a place.
  struct Weights {
    std::array<double, kFront> front{};
    double all = 0.0;
  };

  int build(std::span<const LightReach> lights, std::span<int> indices, int parent);
  void choose_front();
  [[nodiscard]] Weights weigh(const dvec3& place) const;
  [[nodiscard]] const Node& node(int id) const { return nodes_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] double left_part(const Node& node, const dvec3& place) const;

  std::vector<Node> nodes_;  ///< the root is the first
  std::vector<int> front_;   ///< nodes: each leaf is one of them or hangs under one of them
  std::vector<int> leaves_;  ///< by light; kNone for distant ones
  std::vector<int> distant_; ///< lights
  std::vector<double> distant_irradiance_; ///< by light; 0 for the others
  double all_distant_ = 0.0;
};

} // namespace abbe
