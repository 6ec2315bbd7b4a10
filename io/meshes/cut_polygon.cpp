// An ear is a triangle of three corners in a row that lies in the polygon and that no other corner
// touches. Each polygon of four corners or more has two [Meisters75], and without one it is a
// polygon again. A corner that is no ear, since another one is in the way, is asked again when that
// one has become convex or its own neighbours have changed.

#include "io/meshes/cut_polygon.h"

#include <array>
#include <cmath>
#include <utility>

namespace abbe {
namespace {

using glm::dvec3;

/// The axes that remain when one is left out, in an order that keeps the sense.
dvec2 without_axis(const dvec3& p, int axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

/// Newell's normal: twice the areas of the polygon's three shadows.
dvec3 rough_normal(std::span<const dvec3> vertices, std::span<const std::int32_t> polygon) {
  const auto vertex = [&](std::size_t i) { return vertices[static_cast<std::size_t>(polygon[i])]; };
  const dvec3 origin = vertex(0);
  dvec3 normal(0.0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    normal += glm::cross(vertex(i) - origin, vertex(i + 1) - origin);
  return normal;
}

/// The axes, the one along which the vector is longest first.
std::array<int, 3> axes_by_length(const dvec3& v) {
  std::array<int, 3> axes{0, 1, 2};
  const auto order = [&](std::size_t i, std::size_t k) {
    if (std::abs(v[axes[k]]) > std::abs(v[axes[i]])) std::swap(axes[i], axes[k]);
  };
  order(0, 1);
  order(0, 2);
  order(1, 2);
  return axes;
}

/// True where the way from p to q leads to the right, or straight up.
bool leads_on(const dvec2& p, const dvec2& q) {
  return q.x > p.x || (q.x == p.x && q.y > p.y);
}

} // namespace

bool PolygonCutter::cut(std::span<const dvec3> vertices, std::span<const std::int32_t> polygon,
                        std::vector<Triangle>& triangles) {
  if (polygon.size() < 3) return true;
  if (polygon.size() > 3) {
    project(vertices, polygon);
    if (!is_convex()) return clip_ears(polygon, triangles);
  }
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
  return true;
}

/// Of the shadows on the planes of two axes, takes the largest one that has an area.
void PolygonCutter::project(std::span<const dvec3> vertices,
                            std::span<const std::int32_t> polygon) {
  int sign = 0;
  for (const int axis : axes_by_length(rough_normal(vertices, polygon))) {
    points_.clear();
    for (const std::int32_t i : polygon)
      points_.push_back(without_axis(vertices[static_cast<std::size_t>(i)], axis));
    sign = area_sign(points_);
    if (sign != 0) break;
  }
  if (sign < 0)
    for (dvec2& p : points_)
      std::swap(p.x, p.y);
}

/// True for a convex polygon without corners on a straight line: it turns to the left everywhere
/// and runs around once, so that its way leads to the right in one part and to the left in another.
bool PolygonCutter::is_convex() const {
  const std::size_t n = points_.size();
  int changes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const dvec2 &a = points_[i], &b = points_[(i + 1) % n], &c = points_[(i + 2) % n];
    if (orientation(a, b, c) <= 0) return false;
    if (leads_on(a, b) != leads_on(b, c)) ++changes;
  }
  return changes == 2;
}

void PolygonCutter::start() {
  const auto n = static_cast<std::int32_t>(points_.size());
  corners_.assign(points_.size(), {});
  queue_.clear();
  asked_ = 0;
  watchers_.clear();
  std::vector<std::int32_t> reflex;
  for (std::int32_t i = 0; i < n; ++i) {
    Corner& corner = at(i);
    corner.before = i > 0 ? i - 1 : n - 1;
    corner.after = i + 1 < n ? i + 1 : 0;
    corner.convex = turn(corner.before, i, corner.after) > 0;
    corner.in_the_way = !corner.convex;
    if (corner.in_the_way) reflex.push_back(i);
    ask_later(i);
  }
  in_the_way_.build(points_, reflex);
}

bool PolygonCutter::clip_ears(std::span<const std::int32_t> polygon,
                              std::vector<Triangle>& triangles) {
  // A round asks all corners again. For polygons that do not touch themselves one is enough.
  constexpr int kMostRounds = 1000;
  start();
  std::size_t left = points_.size(), left_before = left;
  bool open = false;
  int rounds = 0;
  std::int32_t some = 0; // a corner that is still there
  const auto vertex = [&](std::int32_t i) { return polygon[static_cast<std::size_t>(i)]; };
  while (left > 2) {
    if (asked_ == queue_.size()) {
      // Nothing was an ear. First it must do that no corner lies within, then all is lost.
      if (left == left_before || ++rounds > kMostRounds) {
        if (open) break;
        open = true;
      }
      left_before = left;
      queue_.clear();
      asked_ = 0;
      std::int32_t i = some;
      do {
        ask_later(i);
        i = at(i).after;
      } while (i != some);
    }
    const Candidate next = queue_[asked_++];
    Corner& corner = at(next.corner);
    if (corner.gone || corner.version != next.version) continue;
    const bool spike = is_spike(corner, next.corner);
    if (!spike && !(corner.convex && is_ear(next.corner, open))) continue;
    if (!spike)
      triangles.push_back({vertex(corner.before), vertex(next.corner), vertex(corner.after)});
    some = corner.before;
    take_out(next.corner);
    --left;
  }
  if (left <= 2) return true;
  for (std::int32_t i = at(some).after; at(i).after != some; i = at(i).after)
    triangles.push_back({vertex(some), vertex(i), vertex(at(i).after)});
  return false;
}

/// True for the tip of a needle without area, and for a corner that stands twice in a row.
bool PolygonCutter::is_spike(const Corner& corner, std::int32_t b) const {
  if (corner.convex) return false;
  const dvec2 &p = point(corner.before), &q = point(b), &r = point(corner.after);
  if (p == q || q == r || p == r) return true;
  return turn(corner.before, b, corner.after) == 0 && leads_on(p, q) != leads_on(q, r);
}

bool PolygonCutter::is_ear(std::int32_t b, bool open) {
  const std::int32_t a = at(b).before, c = at(b).after;
  // Where corners of one place follow each other, the cut must leave and arrive inside, too.
  const std::int32_t z = at(a).before, d = at(c).after;
  const auto leaves_inside = [&](std::int32_t from, std::int32_t to, std::int32_t edge, int side) {
    return !at(from).convex || point(edge) == point(to) || side * turn(from, to, edge) > 0;
  };
  if (!open && z != c && !(leaves_inside(a, c, z, 1) && leaves_inside(c, a, d, -1))) return false;
  const std::int32_t blocker = in_the_way_.find({point(a), point(b), point(c)}, open);
  if (blocker < 0) return true;
  const auto number = static_cast<std::int32_t>(watchers_.size());
  watchers_.push_back({b, std::exchange(at(blocker).watchers, number)});
  return false;
}

void PolygonCutter::take_out(std::int32_t b) {
  Corner& corner = at(b);
  const std::int32_t a = corner.before, c = corner.after;
  corner.gone = true;
  at(a).after = c;
  at(c).before = a;
  clear_the_way(b);
  neighbour_changed(a);
  neighbour_changed(c);
}

void PolygonCutter::neighbour_changed(std::int32_t b) {
  Corner& corner = at(b);
  ++corner.version;
  ask_later(b);
  corner.convex = turn(corner.before, b, corner.after) > 0;
  if (corner.convex) clear_the_way(b);
}

/// Has those asked again in whose way the corner stood.
void PolygonCutter::clear_the_way(std::int32_t b) {
  Corner& corner = at(b);
  if (!corner.in_the_way) return;
  corner.in_the_way = false;
  in_the_way_.remove(b);
  for (std::int32_t i = std::exchange(corner.watchers, -1); i >= 0;) {
    const Watcher watcher = watchers_[static_cast<std::size_t>(i)];
    if (!at(watcher.corner).gone) ask_later(watcher.corner);
    i = watcher.next;
  }
}

void PolygonCutter::ask_later(std::int32_t b) {
  queue_.push_back({b, at(b).version});
}

} // namespace abbe
