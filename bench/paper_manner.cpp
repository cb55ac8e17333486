#include "bench/paper_manner.h"

#include <algorithm>
#include <cmath>

#include "bench/scalar_model.h"
#include "pupflow/geometry.h"

namespace pupflow::bench {
namespace {

/// The points of one pup, one per column, from what a snapshot keeps.
arma::mat as_matrix(const std::vector<double>& xyz, int points, std::size_t pup) {
  return arma::mat(xyz.data() + 3 * pup * points, 3, points);
}

void append(const arma::mat& from, std::vector<double>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

PaperManner::PaperManner(const Snapshot& start, PairSearch search)
    : params_(start.params), search_(search) {
  require_baseline_model(params_);
  const int n = points_per_pup(params_);
  const auto rest = cube_sphere(params_.face_points, params_.pup_radius);
  rest_.set_size(3, n);
  for (int i = 0; i < n; ++i) rest_.col(i) = arma::vec{rest[i].x(), rest[i].y(), rest[i].z()};
  rest_q_.set_size(9, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < 3; ++j) {
      rest_q_(j, i) = rest_(j, i);
      rest_q_(j + 3, i) = rest_(j, i) * rest_(j, i);
      rest_q_(j + 6, i) = rest_(j, i) * rest_((j + 1) % 3, i);
    }
  }
  rest_q_.each_col() -= arma::vec(arma::mean(rest_q_, 1));
  rest_aqq_ = arma::pinv(rest_q_ * rest_q_.t(), 1e-10 * arma::norm(rest_q_ * rest_q_.t()));
  for (std::size_t j = 0; j < start.body_temperature.size(); ++j) {
    Pup pup;
    pup.position = as_matrix(start.positions, n, j);
    pup.velocity = as_matrix(start.velocities, n, j);
    pup.tb = start.body_temperature[j];
    pup.heading = start.heading[j];
    pup.exposed = start.exposed[j];
    pups_.push_back(std::move(pup));
  }
}

void PaperManner::floor_and_wall(Pup& pup) const {
  const double r = params_.point_radius;
  for (arma::uword i = 0; i < pup.position.n_cols; ++i) {
    if (pup.position(2, i) - r < 0) {
      pup.velocity(2, i) = std::abs(pup.velocity(2, i));
      pup.position(2, i) = r;
    }
    const double x = pup.position(0, i), y = pup.position(1, i);
    if (std::pow(std::abs(x) + r, 2) + std::pow(std::abs(y) + r, 2) >
        params_.arena_radius * params_.arena_radius) {
      const double phi = std::atan2(y, x);
      const arma::vec inwards{-std::cos(phi), -std::sin(phi), 0.0};
      pup.velocity.col(i) = (pup.velocity.col(i) + inwards) / 2;
      pup.position.col(i) += params_.dt * pup.velocity.col(i);
    }
  }
}

double PaperManner::distance(const Pup& a, arma::uword i, const Pup& b, arma::uword j) const {
  if (search_ == PairSearch::elements) {
    const double dx = a.position(0, i) - b.position(0, j), dy = a.position(1, i) - b.position(1, j),
                 dz = a.position(2, i) - b.position(2, j);
    return std::sqrt(dx * dx + dy * dy + dz * dz);
  }
  const arma::vec e = a.position.col(i) - b.position.col(j);
  return std::sqrt(e(0) * e(0) + e(1) * e(1) + e(2) * e(2));
}

void PaperManner::meet(int first, arma::uword i, int second, arma::uword j, double d) {
  Pup &a = pups_[first], &b = pups_[second];
  if (touching_.empty() || !(touching_.back() == TouchingPair{first, second})) {
    touching_.push_back({first, second});
  }
  const auto feel = [&](Pup& pup, arma::uword point, int other) {
    if (pup.touched[point] >= 0 && !(d < pup.nearest(point))) return;
    pup.nearest(point) = d;
    pup.touched[point] = other;
  };
  feel(a, i, second);
  feel(b, j, first);
  const bool first_is_upper = a.position(2, i) >= b.position(2, j);
  Pup& upper = first_is_upper ? a : b;
  const arma::uword point = first_is_upper ? i : j;
  if (!(d < upper.lower(point))) return;
  upper.lower(point) = d;
  upper.partner.col(point) = first_is_upper ? b.position.col(j) : a.position.col(i);
}

void PaperManner::search_points(int first, int second) {
  for (const arma::uword i : pups_[first].near) {
    for (const arma::uword j : pups_[second].near) {
      const double d = distance(pups_[first], i, pups_[second], j);
      if (d < 2 * params_.point_radius) meet(first, i, second, j, d);
    }
  }
}

void PaperManner::search_pair(int first, int second) {
  Pup &a = pups_[first], &b = pups_[second];
  if (search_ != PairSearch::bounds) {
    a.near = b.near = arma::regspace<arma::uvec>(0, rest_.n_cols - 1);
    search_points(first, second);
    return;
  }
  const double reach = 2 * params_.point_radius;
  const auto inside = [reach](const Pup& pup, const Pup& other) {
    const arma::vec low = arma::min(other.position, 1) - reach;
    const arma::vec high = arma::max(other.position, 1) + reach;
    const arma::mat& p = pup.position;
    return arma::uvec(arma::find(p.row(0) >= low(0) && p.row(0) <= high(0) && p.row(1) >= low(1) &&
                                 p.row(1) <= high(1) && p.row(2) >= low(2) && p.row(2) <= high(2)));
  };
  a.near = inside(a, b);
  if (a.near.is_empty()) return;
  b.near = inside(b, a);
  search_points(first, second);
}

void PaperManner::clear_contacts() {
  touching_.clear();
  for (Pup& pup : pups_) {
    pup.partner.zeros(3, rest_.n_cols);
    pup.lower.set_size(rest_.n_cols);
    pup.lower.fill(arma::datum::inf);
    pup.nearest.zeros(rest_.n_cols);
    pup.touched.assign(rest_.n_cols, -1);
  }
}

void PaperManner::resolve_contacts() {
  for (Pup& pup : pups_) {
    double contacts = 0;
    for (arma::uword i = 0; i < rest_.n_cols; ++i) {
      if (pup.touched[i] >= 0) contacts += 1;
      if (pup.lower(i) == arma::datum::inf) continue;
      const arma::vec e = pup.position.col(i) - pup.partner.col(i);
      pup.position.col(i) += e * (2 * params_.point_radius - pup.lower(i));
      pup.velocity.col(i) = -e;
    }
    pup.exposed = 1 - contacts / static_cast<double>(rest_.n_cols);
  }
}

void PaperManner::contacts() {
  clear_contacts();
  const int pups = static_cast<int>(pups_.size());
  for (int first = 0; first < pups; ++first) {
    for (int second = first + 1; second < pups; ++second) search_pair(first, second);
  }
  resolve_contacts();
}

double PaperManner::touched_mean(const Pup& pup) const {
  double sum = 0;
  int count = 0;
  for (const int other : pup.touched) {
    if (other < 0) continue;
    sum += pups_[other].tb;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

void PaperManner::steer(Pup& pup) const {
  const arma::vec centre = arma::mean(pup.position, 1);
  const double cosine = std::cos(pup.heading), sine = std::sin(pup.heading);
  double sum[2] = {0, 0}, count[2] = {0, 0};
  for (arma::uword i = 0; i < rest_.n_cols; ++i) {
    const arma::vec offset = pup.position.col(i) - centre;
    const bool left = cosine * offset(1) - sine * offset(0) > 0;
    sum[left ? 0 : 1] +=
        pup.touched[i] >= 0 ? pups_[pup.touched[i]].tb : params_.ambient_temperature;
    count[left ? 0 : 1] += 1;
  }
  if (count[0] == 0 || count[1] == 0) return;
  const double turn = turn_of(params_, pup.tb, sum[0] / count[0], sum[1] / count[1]);
  pup.heading = wrapped(pup.heading + params_.dt * turn);
}

void PaperManner::warm() {
  arma::vec next(pups_.size());
  for (std::size_t j = 0; j < pups_.size(); ++j) {
    next(j) = warmed(params_, pups_[j].tb, pups_[j].exposed, touched_mean(pups_[j]));
  }
  for (std::size_t j = 0; j < pups_.size(); ++j) pups_[j].tb = next(j);
}

void PaperManner::move(Pup& pup) const {
  const arma::uword n = rest_.n_cols;
  const arma::vec force{params_.drive * std::cos(pup.heading),
                        params_.drive * std::sin(pup.heading), -params_.gravity};
  arma::mat predicted(3, n);
  for (arma::uword i = 0; i < n; ++i) {
    pup.velocity.col(i) += force * params_.dt;
    predicted.col(i) = pup.position.col(i) + pup.velocity.col(i) * params_.dt;
  }
  arma::vec centre(3, arma::fill::zeros);
  for (arma::uword i = 0; i < n; ++i) centre += predicted.col(i);
  centre /= static_cast<double>(n);
  arma::mat a(3, 9, arma::fill::zeros), a_linear(3, 3, arma::fill::zeros);
  for (arma::uword i = 0; i < n; ++i) {
    const arma::vec p = predicted.col(i) - centre;
    a_linear += p * rest_.col(i).t();
    a += p * rest_q_.col(i).t();
  }
  arma::mat u, v;
  arma::vec sigma;
  arma::svd(u, sigma, v, a_linear);
  if (arma::det(u * v.t()) < 0) u.col(2) = -u.col(2);
  const arma::mat rotation = u * v.t();
  arma::mat t =
      params_.deformation * (a * rest_aqq_) +
      (1 - params_.deformation) * arma::join_rows(rotation, arma::mat(3, 6, arma::fill::zeros));
  const double factor = std::pow(std::abs(arma::det(t.cols(0, 2))), -1.0 / 3.0);
  t.cols(0, 2) *= std::min(factor, 3.0);
  for (arma::uword i = 0; i < n; ++i) {
    const arma::vec goal = t * rest_q_.col(i) + centre;
    const arma::vec next = predicted.col(i) + (goal - predicted.col(i)) * params_.rigidity;
    pup.velocity.col(i) = (next - pup.position.col(i)) / params_.dt;
    pup.position.col(i) = next;
  }
}

void PaperManner::step() {
  for (Pup& pup : pups_) floor_and_wall(pup);
  contacts();
  for (Pup& pup : pups_) steer(pup);
  warm();
  for (Pup& pup : pups_) move(pup);
}

Outcome PaperManner::outcome() const {
  Outcome outcome;
  for (const Pup& pup : pups_) {
    append(pup.position, outcome.positions);
    append(pup.velocity, outcome.velocities);
    outcome.body_temperature.push_back(pup.tb);
    outcome.heading.push_back(pup.heading);
    outcome.exposed.push_back(pup.exposed);
  }
  outcome.touching = touching_;
  return outcome;
}

}  // namespace pupflow::bench
