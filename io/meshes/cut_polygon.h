#pragma once

#include "geometry/meshes/mesh_hierarchy.h"
#include "io/meshes/corner_tree.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace abbe {

/// Cuts polygons into triangles whose corners are the polygons' own, by clipping ears with exact
/// predicates. It may be used for one polygon after another, and keeps its room.
class PolygonCutter {
public:
  /// Cuts the polygon whose corners are these vertices and appends its triangles, which run around
  /// as the polygon does. A polygon that is not flat is cut as its shadow on the plane of two axes
  /// is, in which it is largest. Each triangle has an area, and no corner is left out, where the
  /// polygon's edges do not cross; holes that are joined to the outline by a pair of equal edges
  /// are kept. A polygon that crosses itself is cut somehow, and the answer is false.
  [[nodiscard]] bool cut(std::span<const glm::dvec3> vertices,
                         std::span<const std::int32_t> polygon, std::vector<Triangle>& triangles);

private:
  struct Corner {
    std::int32_t before = 0, after = 0;
    std::int32_t watchers = -1; ///< the first in the list of those in whose way this one stands
    std::int32_t version = 0;   ///< counts how often its neighbours changed
    bool convex = false, gone = false, in_the_way = false;
  };
  /// A corner that is no ear while another one stands in its way.
  struct Watcher {
    std::int32_t corner, next;
  };
  struct Candidate {
    std::int32_t corner, version;
  };

  void project(std::span<const glm::dvec3> vertices, std::span<const std::int32_t> polygon);
  [[nodiscard]] bool is_convex() const;
  [[nodiscard]] bool clip_ears(std::span<const std::int32_t> polygon,
                               std::vector<Triangle>& triangles);
  void start();
  [[nodiscard]] bool is_ear(std::int32_t b, bool open);
  [[nodiscard]] bool is_spike(const Corner& corner, std::int32_t b) const;
  void take_out(std::int32_t b);
  void neighbour_changed(std::int32_t b);
  void clear_the_way(std::int32_t b);
  void ask_later(std::int32_t b);

  [[nodiscard]] Corner& at(std::int32_t i) { return corners_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const dvec2& point(std::int32_t i) const {
    return points_[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] int turn(std::int32_t a, std::int32_t b, std::int32_t c) const {
    return orientation(point(a), point(b), point(c));
  }

  std::vector<dvec2> points_; ///< the polygon's shadow, which runs counter-clockwise
  std::vector<Corner> corners_;
  std::vector<Candidate> queue_; ///< the corners that may be ears, the next to be asked first
  std::size_t asked_ = 0;        ///< how many of the queue have been asked
  std::vector<Watcher> watchers_;
  CornerTree in_the_way_; ///< the corners that are not convex
};

} // namespace abbe
