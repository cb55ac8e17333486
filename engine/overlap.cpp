#include "pupflow/overlap.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "engine/broad_phase.h"
#include "pupflow/geometry.h"

namespace pupflow {
namespace {

/// Distance of each centre from the nearest other.
std::vector<double> nearest_distances(const std::vector<Eigen::Vector3d>& centre) {
  std::vector<double> nearest(centre.size(), std::numeric_limits<double>::infinity());
  for (std::size_t a = 0; a < centre.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double squared = (centre[a] - centre[b]).squaredNorm();
      nearest[a] = std::min(nearest[a], squared);
      nearest[b] = std::min(nearest[b], squared);
    }
  }
  for (double& value : nearest) value = std::sqrt(value);
  return nearest;
}

/// The part of the edge from `a` to `b`, seen along z, in the winding round `p`: +-1 where it
/// crosses the line y = p.y at a larger x than p, else 0. For both directions of an edge the same
/// numbers are compared, so the two triangles beside it always agree.
int edge_crossing(const double* a, const double* b, const double* p) {
  const bool upward = a[1] <= p[1];
  if (upward == (b[1] <= p[1])) return 0;
  const double* low = upward ? a : b;
  const double* high = upward ? b : a;
  if ((high[0] - low[0]) * (p[1] - low[1]) <= (p[0] - low[0]) * (high[1] - low[1])) return 0;
  return upward ? 1 : -1;
}

/// Six times the signed volume between `p` and a triangle.
double volume(const double* a, const double* b, const double* c, const double* p) {
  using Vector = Eigen::Map<const Eigen::Vector3d>;
  const Vector from(p);
  return (Vector(a) - from).dot((Vector(b) - from).cross(Vector(c) - from));
}

}  // namespace

/// The measurement and its memory.
class OverlapMeter::Memory {
 public:
  Overlap measure(const LitterView& litter);

 private:
  /// A body's triangles, by the slabs of y that they cross.
  struct Slabs {
    double low = 0, per_length = 0;
    std::vector<int> begin;     // of each slab in `triangle`, and the end of the last
    std::vector<int> triangle;  // numbers in triangles_
    std::vector<int> next;      // while filling: the place for a slab's next triangle
  };
  struct Directed {
    int body, pup;  // whose boxes overlap: points of `pup` may be inside `body`
  };

  const double* points_of(int pup) const;
  void fill_slabs(int body);
  int slab_at(double y) const;
  // Both need `fill_slabs(body)` before them.
  int winding_number(int body, const double* point) const;
  void find_inside(int pup, int body);

  int face_points_ = 0, points_ = 0;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<double> xyz_;
  std::vector<Eigen::Vector3d> centres_;
  std::vector<Bounds<double>> bounds_;
  std::vector<Directed> directed_;
  std::vector<std::uint8_t> inside_;  // per point of the litter
  BroadPhase<double> broad_phase_;
  Slabs slabs_;
};

const double* OverlapMeter::Memory::points_of(int pup) const {
  return xyz_.data() + 3 * static_cast<std::size_t>(pup) * points_;
}

void OverlapMeter::Memory::fill_slabs(int body) {
  const double* xyz = points_of(body);
  const int count = 2 * face_points_;
  slabs_.low = bounds_[body].low[1];
  slabs_.per_length = count / std::max(bounds_[body].high[1] - slabs_.low, 1e-300);
  slabs_.begin.assign(count + 1, 0);
  slabs_.triangle.clear();
  const auto visit = [&](auto use) {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto [low, high] =
          std::minmax({xyz[3 * triangles_[t][0] + 1], xyz[3 * triangles_[t][1] + 1],
                       xyz[3 * triangles_[t][2] + 1]});
      for (int s = slab_at(low); s <= slab_at(high); ++s) use(s, static_cast<int>(t));
    }
  };
  visit([&](int s, int) { ++slabs_.begin[s + 1]; });
  std::partial_sum(slabs_.begin.begin(), slabs_.begin.end(), slabs_.begin.begin());
  slabs_.triangle.resize(slabs_.begin.back());
  slabs_.next.assign(slabs_.begin.begin(), slabs_.begin.end());
  visit([&](int s, int t) { slabs_.triangle[slabs_.next[s]++] = t; });
}

int OverlapMeter::Memory::slab_at(double y) const {
  const double slab = (y - slabs_.low) * slabs_.per_length;
  return std::clamp(static_cast<int>(slab), 0, 2 * face_points_ - 1);
}

int OverlapMeter::Memory::winding_number(int body, const double* p) const {
  const double* xyz = points_of(body);
  const int slab = slab_at(p[1]);
  int number = 0;
  for (int i = slabs_.begin[slab]; i < slabs_.begin[slab + 1]; ++i) {
    const auto& triangle = triangles_[slabs_.triangle[i]];
    const double *a = xyz + 3 * triangle[0], *b = xyz + 3 * triangle[1], *c = xyz + 3 * triangle[2];
    if (a[2] < p[2] && b[2] < p[2] && c[2] < p[2]) continue;  // the ray goes up
    const int round = edge_crossing(a, b, p) + edge_crossing(b, c, p) + edge_crossing(c, a, p);
    if (round != 0 && round * volume(a, b, c, p) > 0) number += round;
  }
  return number;
}

void OverlapMeter::Memory::find_inside(int pup, int body) {
  const Bounds<double>& box = bounds_[body];
  const double* p = points_of(pup);
  for (int i = 0; i < points_; ++i, p += 3) {
    std::uint8_t& inside = inside_[static_cast<std::size_t>(pup) * points_ + i];
    if (inside != 0) continue;
    bool within = true;
    for (int axis = 0; axis < 3; ++axis)
      within = within && p[axis] >= box.low[axis] && p[axis] <= box.high[axis];
    if (within && winding_number(body, p) > 0) inside = 1;
  }
}

Overlap OverlapMeter::Memory::measure(const LitterView& litter) {
  const int pups = litter.pups;
  points_ = litter.points;
  if (face_points_ != litter.params.face_points) {
    face_points_ = litter.params.face_points;
    triangles_ = surface_triangles(face_points_);
  }
  const std::size_t all = static_cast<std::size_t>(pups) * points_;
  xyz_.resize(3 * all);
  litter.positions.copy_to(xyz_);
  bounds_.resize(pups);
  centres_.assign(pups, Eigen::Vector3d::Zero());
  for (int pup = 0; pup < pups; ++pup) {
    const Eigen::Map<const Eigen::Matrix3Xd> points(points_of(pup), 3, points_);
    centres_[pup] = points.rowwise().mean();
    Eigen::Map<Eigen::Vector3d>(bounds_[pup].low) = points.rowwise().minCoeff();
    Eigen::Map<Eigen::Vector3d>(bounds_[pup].high) = points.rowwise().maxCoeff();
  }

  directed_.clear();
  for (const auto& [first, second] : broad_phase_.near_pairs(bounds_, 0)) {
    directed_.push_back({first, second});
    directed_.push_back({second, first});
  }
  std::sort(directed_.begin(), directed_.end(), [](const Directed& a, const Directed& b) {
    return a.body != b.body ? a.body < b.body : a.pup < b.pup;
  });
  inside_.assign(all, 0);
  int filled = -1;
  for (const auto& [body, pup] : directed_) {
    if (body != filled) fill_slabs(filled = body);
    find_inside(pup, body);
  }

  Overlap overlap;
  const std::vector<double> nearest = nearest_distances(centres_);
  overlap.least = overlap.nearest = std::numeric_limits<double>::infinity();
  if (pups > 1) {
    overlap.least = *std::min_element(nearest.begin(), nearest.end());
    overlap.nearest = std::accumulate(nearest.begin(), nearest.end(), 0.0) / pups;
  }
  const std::span<const int> touched = litter.touched;
  std::int64_t inside = 0, exposed = 0;
  for (std::size_t i = 0; i < all; ++i) {
    inside += inside_[i];
    exposed += inside_[i] != 0 && touched[i] < 0 ? 1 : 0;
  }
  if (inside == 0) return overlap;
  overlap.inside = static_cast<double>(inside) / static_cast<double>(all);
  overlap.inside_exposed = static_cast<double>(exposed) / static_cast<double>(inside);
  return overlap;
}

OverlapMeter::OverlapMeter() : memory_(std::make_unique<Memory>()) {}
OverlapMeter::OverlapMeter(OverlapMeter&&) noexcept = default;
OverlapMeter& OverlapMeter::operator=(OverlapMeter&&) noexcept = default;
OverlapMeter::~OverlapMeter() = default;

Overlap OverlapMeter::measure(const LitterView& litter) {
  return memory_->measure(litter);
}

Overlap measure_overlap(const LitterView& litter) {
  return OverlapMeter().measure(litter);
}

void OverlapMeans::add(const Overlap& overlap) {
  sum_.least = count_ == 0 ? overlap.least : std::min(sum_.least, overlap.least);
  sum_.nearest += overlap.nearest;
  sum_.inside += overlap.inside;
  sum_.inside_exposed += overlap.inside * overlap.inside_exposed;
  ++count_;
}

Overlap OverlapMeans::means() const {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (count_ == 0) return {nan, nan, nan, nan};
  const auto n = static_cast<double>(count_);
  return {sum_.nearest / n, sum_.least, sum_.inside / n,
          sum_.inside > 0 ? sum_.inside_exposed / sum_.inside : 0};
}

}  // namespace pupflow
