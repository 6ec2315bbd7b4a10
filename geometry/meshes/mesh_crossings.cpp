#include "geometry/meshes/mesh.h"

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

namespace abbe {
namespace {

constexpr float kNoReach = std::numeric_limits<float>::infinity();

/// A float not less than `value`.
float rounded_up(double value) {
  const auto nearest = static_cast<float>(value);
  return nearest + std::abs(nearest) * 0x1p-23f;
}

/// The same for four values.
__m128 rounded_up(const __m256d& values) {
  const __m128 nearest = _mm256_cvtpd_ps(values);
  const __m128 size = _mm_andnot_ps(_mm_set1_ps(-0.0f), nearest);
  return _mm_add_ps(nearest, _mm_mul_ps(size, _mm_set1_ps(0x1p-23f)));
}

/// A ray against eight boxes at once, in single precision. No box is missed whose content the
/// double ray may meet at t >= 0:
/// - The ray begins where it comes near the hierarchy (`advance`), at o from the centre, and has
///   met or left all boxes before t - advance reaches `duration`.
/// - The boxes grow by `margin`: four times what the solver may take a surface to be off its place,
///   and e = 2^-22 radius, since a component of the direction below e / duration is replaced by
///   that; this moves the ray by e at most, and no reciprocal overflows.
/// - o plus and minus the margin are rounded outwards, as the boxes are. So a difference has the
///   right sign. It, the reciprocal and their product round once each, u = 2^-24: the distances at
///   which a slab is entered and left are off by 4 u of themselves at most, their ratio by less
///   than the 2^-20 by which the later one grows [Ize13].
class BoxRay {
public:
  BoxRay(const Mesh& mesh, const LocalRay& ray) {
    const MeshHierarchy& boxes = mesh.hierarchy();
    const double speed = glm::length(ray.direction);
    dvec3 o = ray.origin - boxes.centre;
    const double nearest = -glm::dot(o, ray.direction) / (speed * speed);
    if (glm::length(o) > 2.0 * boxes.radius && nearest > 0.0) {
      advance_ = std::max(0.0, nearest - 2.0 * boxes.radius / speed);
      o += advance_ * ray.direction;
    }
    const double duration = (glm::length(o) + 2.0 * boxes.radius) / speed;
    const double moved = 0x1p-22 * boxes.radius;
    const double margin = 4.0 * ray.shift_at(advance_ + duration, mesh.size()) + moved;
    // All three axes at once; the fourth lane has no meaning.
    const __m256d origin = _mm256_setr_pd(o.x, o.y, o.z, 0.0);
    const __m256d direction =
        _mm256_setr_pd(ray.direction.x, ray.direction.y, ray.direction.z, 1.0);
    const __m256d sign = _mm256_set1_pd(-0.0), margins = _mm256_set1_pd(margin);
    const __m256d backwards = _mm256_cmp_pd(direction, _mm256_setzero_pd(), _CMP_LT_OQ);
    const __m256d least =
        _mm256_max_pd(_mm256_andnot_pd(sign, direction), _mm256_set1_pd(moved / duration));
    const __m256d turned = _mm256_xor_pd(least, _mm256_and_pd(backwards, sign));
    _mm_store_ps(per_axis_.data(), _mm256_cvtpd_ps(_mm256_div_pd(_mm256_set1_pd(1.0), turned)));
    const __m128 high = rounded_up(_mm256_add_pd(origin, margins));
    const __m128 low = _mm_xor_ps(_mm_set1_ps(-0.0f), rounded_up(_mm256_sub_pd(margins, origin)));
    const unsigned reversed = static_cast<unsigned>(_mm256_movemask_pd(backwards));
    std::array<float, 4> lows, highs;
    _mm_storeu_ps(lows.data(), low);
    _mm_storeu_ps(highs.data(), high);
    for (std::size_t i = 0; i < 3; ++i) {
      forwards_[i] = (reversed >> i & 1u) == 0;
      enter_from_[i] = forwards_[i] ? highs[i] : lows[i];
      leave_from_[i] = forwards_[i] ? lows[i] : highs[i];
    }
  }

  /// The boxes that the ray meets up to a distance, one bit each, and where it enters them.
  unsigned met(const MeshNode& node, float farthest, float* enters) const {
    __m256 first = _mm256_setzero_ps(), last = _mm256_set1_ps(farthest);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& near = forwards_[i] ? node.lower[i] : node.upper[i];
      const auto& far = forwards_[i] ? node.upper[i] : node.lower[i];
      const __m256 per = _mm256_set1_ps(per_axis_[i]);
      const __m256 enter = _mm256_mul_ps(
          _mm256_sub_ps(_mm256_load_ps(near.data()), _mm256_set1_ps(enter_from_[i])), per);
      const __m256 leave = _mm256_mul_ps(
          _mm256_sub_ps(_mm256_load_ps(far.data()), _mm256_set1_ps(leave_from_[i])), per);
      first = _mm256_max_ps(first, enter);
      last = _mm256_min_ps(last, leave);
    }
    _mm256_store_ps(enters, first);
    last = _mm256_mul_ps(last, _mm256_set1_ps(1.0f + 0x1p-20f));
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(first, last, _CMP_LE_OQ)));
  }

  /// A distance before which each box that holds a crossing at `t` is entered.
  [[nodiscard]] float entered_before(double t) const {
    return rounded_up(t - advance_) * (1.0f + 0x1p-20f);
  }

private:
  double advance_ = 0.0;
  std::array<float, 3> enter_from_{}, leave_from_{};
  alignas(16) std::array<float, 4> per_axis_{};
  std::array<bool, 3> forwards_{};
};

/// Where a line crosses four triangles, in lanes of which `crossed` has one bit each: those that it
/// crosses at all, and runs through with the normal.
struct Lanes {
  alignas(32) std::array<double, 4> t;
  unsigned crossed, outwards;
};

/// A line in a frame in which it runs along the third axis: the largest part of its direction is
/// the third axis, and the others are sheared so that it runs along that axis [WBW13]. A triangle's
/// edge then passes the origin on one side or the other, the same for both triangles that share it.
class ShearedLine {
public:
  explicit ShearedLine(const LocalRay& ray) {
    const dvec3& d = ray.direction;
    int z = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(d[i]) > std::abs(d[z])) z = i;
    const int x = (z + 1) % 3, y = (z + 2) % 3;
    axes_ = {static_cast<std::size_t>(x), static_cast<std::size_t>(y), static_cast<std::size_t>(z)};
    const dvec3 shear(d[x] / d[z], d[y] / d[z], 1.0 / d[z]);
    for (int i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(i);
      origin_[a] = _mm256_set1_pd(ray.origin[i]);
      shear_[a] = _mm256_set1_pd(shear[i]);
    }
    reversed_ = shear.z < 0.0;
  }

  /// Along which the line runs fastest.
  [[nodiscard]] int axis() const { return static_cast<int>(axes_[2]); }

  /// Where it crosses the triangles of a leaf. Whether it does, and in which sense, follows from
  /// the same signs, so that a line enters and leaves a closed mesh in turn.
  [[nodiscard]] Lanes crossed(const Mesh& mesh, const MeshLeaf& leaf) const {
    const Corner a = seen(mesh, leaf, 0), b = seen(mesh, leaf, 1), c = seen(mesh, leaf, 2);
    const __m256d u = edge(b, c), v = edge(c, a), w = edge(a, b);
    const __m256d zero = _mm256_setzero_pd();
    // The line passes beside a triangle where one sign is negative and another one positive.
    const __m256d least = _mm256_min_pd(_mm256_min_pd(u, v), w);
    const __m256d most = _mm256_max_pd(_mm256_max_pd(u, v), w);
    const __m256d beside = _mm256_and_pd(_mm256_cmp_pd(least, zero, _CMP_LT_OQ),
                                         _mm256_cmp_pd(most, zero, _CMP_GT_OQ));
    const __m256d sum = _mm256_add_pd(_mm256_add_pd(u, v), w); // 0: seen from its edge
    const __m256d met = _mm256_andnot_pd(beside, _mm256_cmp_pd(sum, zero, _CMP_NEQ_OQ));
    Lanes lanes{};
    lanes.crossed = bits(met) & ((1u << leaf.count) - 1u);
    if (lanes.crossed == 0) return lanes;
    const unsigned positive = bits(_mm256_cmp_pd(sum, zero, _CMP_GT_OQ));
    lanes.outwards = lanes.crossed & (reversed_ ? ~positive : positive);
    const __m256d weighed = _mm256_add_pd(
        _mm256_add_pd(_mm256_mul_pd(u, a.z), _mm256_mul_pd(v, b.z)), _mm256_mul_pd(w, c.z));
    // Triangles that are not crossed may have the sum 0.
    const __m256d divisor = _mm256_blendv_pd(_mm256_set1_pd(1.0), sum, met);
    _mm256_store_pd(lanes.t.data(), _mm256_div_pd(weighed, divisor));
    return lanes;
  }

private:
  /// One corner of four triangles, as the line sees it.
  struct Corner {
    __m256d x, y, z;
  };

  [[nodiscard]] Corner seen(const Mesh& mesh, const MeshLeaf& leaf, std::size_t corner) const {
    // Past the leaf's end its first triangle is taken again, and not counted.
    const auto vertex = [&](std::int32_t i) {
      const auto t = static_cast<std::size_t>(leaf.first + (i < leaf.count ? i : 0));
      const auto v = static_cast<std::size_t>(mesh.triangles()[t][corner]);
      const __m256i three = _mm256_setr_epi64x(-1, -1, -1, 0);
      return _mm256_maskload_pd(&mesh.vertices()[v].x, three);
    };
    const __m256d p0 = vertex(0), p1 = vertex(1), p2 = vertex(2), p3 = vertex(3);
    const __m256d xz01 = _mm256_unpacklo_pd(p0, p1), y01 = _mm256_unpackhi_pd(p0, p1);
    const __m256d xz23 = _mm256_unpacklo_pd(p2, p3), y23 = _mm256_unpackhi_pd(p2, p3);
    const __m256d p[3] = {
        _mm256_sub_pd(_mm256_permute2f128_pd(xz01, xz23, 0x20), origin_[0]),
        _mm256_sub_pd(_mm256_permute2f128_pd(y01, y23, 0x20), origin_[1]),
        _mm256_sub_pd(_mm256_permute2f128_pd(xz01, xz23, 0x31), origin_[2]),
    };
    const __m256d z = p[axes_[2]];
    return {_mm256_sub_pd(p[axes_[0]], _mm256_mul_pd(shear_[0], z)),
            _mm256_sub_pd(p[axes_[1]], _mm256_mul_pd(shear_[1], z)), _mm256_mul_pd(shear_[2], z)};
  }
  /// p.x q.y - p.y q.x with the right sign, and 0 only where it is 0: what the second product loses
  /// by rounding is added again [JLM13]. Rounded signs say nothing of a triangle that is seen from
  /// its edge: it would be met far beside it in its plane.
  static __m256d edge(const Corner& p, const Corner& q) {
    const __m256d product = _mm256_mul_pd(p.y, q.x);
    const __m256d lost = _mm256_fnmadd_pd(p.y, q.x, product);
    return _mm256_add_pd(_mm256_fmsub_pd(p.x, q.y, product), lost);
  }
  static unsigned bits(const __m256d& mask) {
    return static_cast<unsigned>(_mm256_movemask_pd(mask));
  }

  __m256d origin_[3], shear_[3];
  std::array<std::size_t, 3> axes_{};
  bool reversed_ = false; ///< the third axis points against the line: it sees all mirrored
};

bool before(const Root& a, const Root& b) {
  return std::tie(a.t, a.face.face) < std::tie(b.t, b.face.face);
}

/// One search through the hierarchy for the crossings of one ray.
class Search {
public:
  Search(const Mesh& mesh, const LocalRay& ray, std::span<const std::int32_t> touched,
         MeshSearch search)
      : mesh_(mesh), ray_(ray), touched_(touched), search_(search), boxes_(mesh, ray), line_(ray) {}

  MeshCrossings run() {
    struct Waiting {
      float enters;
      std::int32_t child;
    };
    std::array<Waiting, 7 * MeshHierarchy::kDeepest + 1> stack; // each level leaves seven boxes
    std::size_t top = 0;
    stack[top++] = {0.0f, 0};
    while (top > 0) {
      const Waiting next = stack[--top];
      if (next.enters > reach_) continue;
      if (MeshLeaf::is(next.child)) {
        ask(MeshLeaf::of(next.child));
        continue;
      }
      const MeshNode& node = mesh_.hierarchy().nodes[static_cast<std::size_t>(next.child)];
      alignas(32) std::array<float, 8> enters;
      const std::size_t bottom = top;
      for (unsigned met = boxes_.met(node, reach_, enters.data()); met != 0; met &= met - 1) {
        const auto box = static_cast<std::size_t>(std::countr_zero(met));
        const Waiting found{enters[box], node.child[box]};
        std::size_t place = top++; // the nearest comes last
        for (; place > bottom && stack[place - 1].enters < found.enters; --place)
          stack[place] = stack[place - 1];
        stack[place] = found;
      }
    }
    return found_;
  }

private:
  [[nodiscard]] bool touches(std::int32_t face) const {
    for (const std::int32_t touched : touched_)
      if (touched == face) return true;
    return false;
  }

  void ask(const MeshLeaf& leaf) {
    const Lanes lanes = line_.crossed(mesh_, leaf);
    for (unsigned left = lanes.crossed; left != 0; left &= left - 1) {
      const int lane = std::countr_zero(left);
      const int face = leaf.first + lane;
      const bool outwards = (lanes.outwards >> lane & 1u) != 0;
      const double t = lanes.t[static_cast<std::size_t>(lane)];
      Root& first = outwards ? found_.exit : found_.enter;
      if (t > first.t || touches(face)) continue;
      const double cosine = std::abs(glm::dot(outward_normal(mesh_, {}, face), ray_.direction));
      if (cosine == 0.0) continue;
      const double error = plane_root_error(ray_, cosine, t, mesh_.size());
      Root root{t, std::min(error, reach_of(face, t)), {0, face}};
      const bool ahead = root.t > root.t_error;
      if (search_ == MeshSearch::sum) {
        found_.exits_less_entries += !ahead ? 0 : outwards ? 1 : -1;
        continue;
      }
      const bool beside = search_ == (outwards ? MeshSearch::enter : MeshSearch::exit);
      if (beside ? !ahead : root.t < -root.t_error) continue;
      root.t = std::max(0.0, root.t);
      if (!before(root, first)) continue;
      first = root;
      reach_ = boxes_.entered_before(last());
    }
  }

  /// How far from `t` the triangle may be crossed: between its corners, whose places rounding
  /// moves. A ray that runs along the triangle's plane may cross that much farther away. Behind the
  /// origin only what is ahead of `t` counts.
  [[nodiscard]] double reach_of(int face, double t) const {
    const int axis = line_.axis();
    const double speed = ray_.direction[axis];
    double reach = 0.0;
    for (const dvec3& corner : mesh_.corners(face)) {
      const double ahead = (corner[axis] - ray_.origin[axis]) / speed - t;
      reach = std::max(reach, t < 0.0 ? ahead : std::abs(ahead));
    }
    return reach + plane_root_error(ray_, std::abs(speed), t, mesh_.size());
  }

  /// What lies beyond makes no difference any more.
  [[nodiscard]] double last() const {
    const Root& enter = found_.enter;
    const Root& exit = found_.exit;
    if (search_ == MeshSearch::enter) return enter.t + 2.0 * enter.t_error;
    if (search_ == MeshSearch::exit) return exit.t + 2.0 * exit.t_error;
    return std::min(enter.t, exit.t);
  }

  const Mesh& mesh_;
  const LocalRay& ray_;
  std::span<const std::int32_t> touched_;
  MeshSearch search_;
  BoxRay boxes_;
  ShearedLine line_;
  float reach_ = kNoReach;
  MeshCrossings found_;
};

} // namespace

MeshCrossings first_crossings(const Mesh& mesh, const LocalRay& ray,
                              std::span<const std::int32_t> touched, MeshSearch search) {
  return Search(mesh, ray, touched, search).run();
}

} // namespace abbe
