// How a litter is drawn, beside its colors.
#pragma once

#include <array>
#include <string_view>

namespace pupflow::view {

enum class Draw {
  points,  // a sphere for each point, by which it touches
  skin,    // a closed surface one point radius outside the points
  both     // the surface, with the points standing out of it
};

enum class Quality {
  fast,    // neither occlusion nor shadows, hard edges
  normal,  // all of it, soft edges
  print    // the same with many samples a pixel
};

constexpr std::array<std::string_view, 3> kDrawNames{"points", "skin", "both"};
constexpr std::array<std::string_view, 3> kQualityNames{"fast", "normal", "print"};

inline std::string_view name_of(Draw draw) {
  return kDrawNames[static_cast<std::size_t>(draw)];
}
inline std::string_view name_of(Quality quality) {
  return kQualityNames[static_cast<std::size_t>(quality)];
}

/// The samples across a pixel that a quality has unless told otherwise.
constexpr int usual_samples(Quality quality) {
  return quality == Quality::print ? 3 : 1;
}

enum class Culling {
  none,
  hidden  // leave out points on the far side of a pup whose skin has no holes
};

struct Drawing {
  Draw draw = Draw::skin;
  Quality quality = Quality::normal;
  int rows = 960;  // samples from top to bottom of the picture: they decide how fine bodies are
  Culling culling = Culling::hidden;
};

}  // namespace pupflow::view
