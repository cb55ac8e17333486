// Baseline: the step of docs/model.md in the manner of the paper's own program (armadillo; the
// author's public shape matching and huddling code is the pattern): a 3 x n matrix per pup, columns
// and products as temporaries, every point against every point of the other pups with a root per
// pair.
#pragma once

#include <armadillo>
#include <vector>

#include "bench/outcome.h"
#include "pupflow/parameters.h"

namespace pupflow::bench {

/// How the contact search goes about it.
enum class PairSearch {
  vectors,   // all pairs, the difference of two columns as a vector
  elements,  // all pairs, element by element
  bounds     // as vectors, but only points that lie in the other pup's box
};

/// A litter stepped in that manner, in double precision.
class PaperManner {
 public:
  /// Goes on from `start`. Throws std::invalid_argument as require_baseline_model does.
  PaperManner(const Snapshot& start, PairSearch search);

  void step();
  Outcome outcome() const;

 private:
  struct Pup {
    arma::mat position, velocity;  // 3 x n
    arma::mat partner;             // 3 x n: the nearest touching lower point
    arma::vec lower;               // distance to it; infinite where there is none
    arma::vec nearest;             // distance to the nearest touching point
    std::vector<int> touched;      // its pup, or -1
    arma::uvec near;               // points to be searched
    double tb, heading, exposed;
  };

  void floor_and_wall(Pup& pup) const;
  void contacts();
  void clear_contacts();
  void search_pair(int first, int second);
  void search_points(int first, int second);
  double distance(const Pup& a, arma::uword i, const Pup& b, arma::uword j) const;
  void meet(int first, arma::uword i, int second, arma::uword j, double d);
  void resolve_contacts();
  double touched_mean(const Pup& pup) const;
  void steer(Pup& pup) const;
  void warm();
  void move(Pup& pup) const;

  Params params_;
  PairSearch search_;
  std::vector<Pup> pups_;
  arma::mat rest_;      // 3 x n
  arma::mat rest_q_;    // 9 x n: x, y, z, x^2, y^2, z^2, xy, yz, zx, less their means
  arma::mat rest_aqq_;  // 9 x 9: pseudo-inverse of sum q q^T
  std::vector<TouchingPair> touching_;
};

}  // namespace pupflow::bench
