#include "engine/start.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/elementary.h"
#include "engine/rng.h"
#include "pupflow/geometry.h"

namespace pupflow {
namespace {

using Eigen::Vector3d;

// Each pup has two random streams: one for its centre, one for its orientation and heading.
enum class Stream : std::uint64_t { centre, pose };

Rng random_of(const Params& params, int pup, Stream stream) {
  return Rng(static_cast<std::uint64_t>(params.seed),
             2 * static_cast<std::uint64_t>(pup) + static_cast<std::uint64_t>(stream));
}

/// Radius of a pup with the spheres at its points.
double body_radius(const Params& params) {
  return params.pup_radius + params.point_radius;
}

struct Site {
  double x, y;
};

/// Sites of a hexagonal grid within `radius` of the centre, nearest first.
std::vector<Site> hexagonal_sites(double spacing, double radius) {
  std::vector<Site> sites;
  const double row_height = spacing * std::sqrt(0.75);
  const auto rows = static_cast<int>(radius / row_height);
  for (int row = -rows; row <= rows; ++row) {
    const double y = row * row_height, offset = row % 2 != 0 ? spacing / 2 : 0;
    const auto columns = static_cast<int>(radius / spacing) + 1;
    for (int column = -columns; column <= columns; ++column) {
      const double x = column * spacing + offset;
      if (x * x + y * y <= radius * radius) sites.push_back({x, y});
    }
  }
  std::stable_sort(sites.begin(), sites.end(), [](const Site& a, const Site& b) {
    return a.x * a.x + a.y * a.y < b.x * b.x + b.y * b.y;
  });
  return sites;
}

/// The number of sites of such a grid, counted row by row without a list.
std::size_t count_sites(double spacing, double radius) {
  std::size_t count = 0;
  const double row_height = spacing * std::sqrt(0.75);
  const auto rows = static_cast<int>(std::min(radius / row_height, 1e6));
  for (int row = -rows; row <= rows; ++row) {
    const double y = row * row_height, offset = row % 2 != 0 ? spacing / 2 : 0;
    const double half = std::sqrt(std::max(radius * radius - y * y, 0.0));
    const double sites =
        std::floor((half - offset) / spacing) + std::floor((half + offset) / spacing) + 1;
    count += static_cast<std::size_t>(std::clamp(sites, 0.0, 1e6));
  }
  return count;
}

/// The largest spacing of at least `least` at which `wanted` sites fit, by bisection.
double widest_spacing(double least, double radius, std::size_t wanted) {
  double fits = least, too_wide = 2 * radius + 2 * least;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (fits + too_wide);
    (count_sites(middle, radius) >= wanted ? fits : too_wide) = middle;
  }
  return fits;
}

std::vector<Vector3d> carpet(const Params& params) {
  const double body = body_radius(params);
  constexpr double kGap = 1.05;  // least distance of centres, in diameters of a body
  const double least = 2 * body * kGap, radius = params.arena_radius - body;
  const auto pups = static_cast<std::size_t>(params.pups);
  const std::size_t capacity = std::max<std::size_t>(count_sites(least, radius), 1);
  const std::size_t layers = (pups + capacity - 1) / capacity;
  const std::size_t per_layer = (pups + layers - 1) / layers;
  // Slightly smaller, so that rounding cannot make the list shorter than the count.
  const double spacing = widest_spacing(least, radius, per_layer) * (1 - 1e-9);
  const std::vector<Site> sites = hexagonal_sites(spacing, radius);
  const double jitter = (spacing - 2 * body) / 4;
  std::vector<Vector3d> centres;
  for (std::size_t j = 0; j < pups; ++j) {
    const Site site = sites.empty() ? Site{0, 0} : sites[j % per_layer % sites.size()];
    Rng random = random_of(params, static_cast<int>(j), Stream::centre);
    const double x = site.x + random.uniform(-jitter, jitter);
    const double y = site.y + random.uniform(-jitter, jitter);
    const double inward = std::min(1.0, radius / std::max(std::sqrt(x * x + y * y), 1e-300));
    const double layer = static_cast<double>(j / per_layer);
    centres.emplace_back(x * inward, y * inward, body * kGap + layer * least);
  }
  return centres;
}

/// rotation * v. Written out, since Eigen's product uses fused multiply-add where the processor has
/// it, which gives other bits.
Vector3d turned(const Eigen::Matrix3d& rotation, const Vector3d& v) {
  Vector3d result;
  for (int i = 0; i < 3; ++i) {
    result[i] = rotation(i, 0) * v[0] + rotation(i, 1) * v[1] + rotation(i, 2) * v[2];
  }
  return result;
}

std::vector<Vector3d> column(const Params& params) {
  const double body = body_radius(params);
  const double spacing = std::max(1.0, 2 * body);
  std::vector<Vector3d> centres;
  for (int j = 0; j < params.pups; ++j) {
    Rng random = random_of(params, j, Stream::centre);
    const double x = random.uniform(-params.start_spread, params.start_spread);
    const double y = random.uniform(-params.start_spread, params.start_spread);
    centres.emplace_back(x, y, j * spacing + params.pup_radius + params.point_radius);
  }
  return centres;
}

}  // namespace

std::vector<Vector3d> start_centres(const Params& params) {
  if (params.pups == 0) return {};
  return params.start == Start::column ? column(params) : carpet(params);
}

template <class Real>
void lay_out(const Params& params, const std::vector<Vector3d>& rest, State<Real>& state) {
  assert(state.pups == params.pups && rest.size() == static_cast<std::size_t>(state.points));
  const std::vector<Vector3d> centres = start_centres(params);
  for (int pup = 0; pup < state.pups; ++pup) {
    Rng random = random_of(params, pup, Stream::pose);
    const Eigen::Matrix3d rotation = random.rotation();
    for (int i = 0; i < state.stride; ++i) {
      const bool padding = i >= state.points;
      const Vector3d position =
          padding ? centres[pup] : Vector3d(centres[pup] + turned(rotation, rest[i]));
      const std::size_t k = state.row(pup) + i;
      state.x[k] = static_cast<Real>(position.x());
      state.y[k] = static_cast<Real>(position.y());
      state.z[k] = static_cast<Real>(position.z());
    }
    state.tb[pup] = state.felt_tb[pup] = params.initial_temperature;
    state.heading[pup] = wrap_angle(random.uniform(-kPi, kPi));
    update_bounds(state, pup);
  }
}

template void lay_out<float>(const Params&, const std::vector<Vector3d>&, State<float>&);
template void lay_out<double>(const Params&, const std::vector<Vector3d>&, State<double>&);

}  // namespace pupflow
