#pragma once

#include "geometry/rays/passage.h"
#include "geometry/rays/ray_state.h"
#include "geometry/world/shape.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace abbe {

/// Whether rays that run close together are handed to Embree together. The answers are the same.
enum class Tracing : std::uint8_t { single, packets };

/// The shapes of a scene in Embree's hierarchies. Embree, in single precision, only proposes
/// candidates; every crossing is found and compared in double, so the answer depends neither on
/// the order of traversal nor on the width of packets. Rays that are not finite are not handed on:
/// they meet nothing, and no light comes along them.
class World {
public:
  /// `farthest_coordinate` is the largest magnitude of a coordinate from which rays start outside
  /// the shapes (cameras, lights); bounds are padded for it. `embree_config` is what rtcNewDevice
  /// takes, such as "isa=sse4.2" for a narrow instruction set; null for Embree's own choice. Throws
  /// std::runtime_error when Embree fails.
  World(const std::vector<PlacedShape>& shapes, double farthest_coordinate,
        const char* embree_config = nullptr);
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// The first visible boundary along the ray. Boundaries between equal media, and those hidden
  /// inside a solid of higher priority, are passed.
  [[nodiscard]] std::optional<Hit> closest(const RayState& state) const;
  /// The same, written into the caller's hit: a copy would cost a good part of the query.
  void find_closest(const RayState& state, Hit& hit) const;
  /// The same for boundaries that are surely nearer than `distance`, for a ray that is followed
  /// straight on. One that rounding cannot tell from the end of that distance does not count, as
  /// for `occluded`.
  void find_closest(const RayState& state, double distance, Passage& passage, Hit& hit) const;
  /// The same for rays that run close together; `hits` has the length of `states`.
  void find_closest(std::span<const RayState> states, std::span<Hit> hits, Tracing tracing) const;

  /// True when a visible boundary (see `closest`) lies between the origin and `distance` along the
  /// ray. One that rounding cannot tell from the end does not count: a light may lie on a surface.
  [[nodiscard]] bool occluded(const RayState& state, double distance) const;

  // For measurements: the bare query with the callbacks above, and nothing made of what they find.
  // Both return how many rays met something. Rays go to Embree `width` at a time: 1, 4, 8 or 16.
  [[nodiscard]] std::size_t replay_closest(std::span<const RayState> states, int width) const;
  [[nodiscard]] std::size_t replay_occluded(std::span<const RayState> states,
                                            std::span<const double> distances) const;

  /// The solids around a point, for cameras and lights; what lies on a surface is on either side.
  [[nodiscard]] Nesting nesting_at(const dvec3& point) const;

  // Rays that begin somewhere rather than at what another ray has met. All surfaces that hold the
  // place but for rounding are one boundary, as for rays that meet it, and the solids are those
  // behind it.
  /// A ray that begins at a place.
  [[nodiscard]] RayState start_at(const Ray& ray) const;
  /// A ray that begins on a shape's surface and goes to the contact's side of it. Nothing where
  /// another surface shows there.
  [[nodiscard]] std::optional<RayState> start_on(const SurfaceContact& contact,
                                                 const Ray& ray) const;
  /// Whether a shape's surface, to which a ray comes at a distance, shows there. `hiders` are those
  /// of the shape.
  [[nodiscard]] bool shows(ShapeId shape, std::span<const ShapeId> hiders, const Ray& ray,
                           double distance) const;
  /// The other shapes that may show in a place of this one: none where it surely shows wherever it
  /// is seen.
  [[nodiscard]] std::vector<ShapeId> hiders(ShapeId shape) const;
  /// True when no other shape comes near this one: rays that begin on it begin in no solid and on
  /// no other surface.
  [[nodiscard]] bool stands_alone(ShapeId shape) const;
  /// The medium at a place inside these solids: that of the highest priority, among equals of
  /// the shape defined last. Invalid where no solid has a medium.
  [[nodiscard]] MediumId medium_of(const Nesting& nesting) const;

  [[nodiscard]] const std::vector<PlacedShape>& shapes() const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// "3.13.5", as the linked Embree reports it.
[[nodiscard]] std::string embree_version();

} // namespace abbe
