#include "app/view/light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pupflow::view {

namespace {

constexpr float kKey = 0.62f, kSky = 0.42f, kFloor = 0.14f;
constexpr float kCone = 35 * std::numbers::pi_v<float> / 180;
constexpr float kLampAzimuth = 100 * std::numbers::pi_v<float> / 180;
constexpr float kLampElevation = 60 * std::numbers::pi_v<float> / 180;
constexpr float kLeast = 0.04f, kLowSky = 0.6f;
constexpr float kCrevice = 1.3f;    // how much darker than by the sky alone it is between bodies
constexpr float kPenumbra = 0.35f;  // half-width of a soft shadow's edge, a distance away
constexpr float kReach = 3.2f;      // between the centres of neighbours, in radii
constexpr float kFloorReach = 3;    // of a body's shade on the floor, in radii from its middle

float encoded(float light) {
  return std::pow(light, 1 / LightModel::kGamma);
}

/// The light that counts as 1: the least within the cone of open surfaces around the lamp.
float full_light() {
  const float up = std::sin(kLampElevation - kCone);
  return kKey * std::cos(kCone) + kSky * (1 + up) / 2 + kFloor * (1 - up) / 2;
}

/// The share of the sky over a surface that a ball hides; `away` goes from the surface to its
/// centre (after Quilez, sphere ambient occlusion).
float hidden_sky(const Eigen::Vector3f& away, float radius, const Eigen::Vector3f& normal) {
  const float distance = std::max(away.norm(), 1e-6f);
  const float h = std::max(distance / radius, 1.0f);
  const float cosine = normal.dot(away) / distance;
  if (cosine * h > 1) return cosine / (h * h);
  if (cosine * h < -1) return 0;
  const float share = 0.5f * (cosine * h + 1) / (h * h);
  return share * std::sqrt(share);
}

/// The share of the lamp that a ball leaves.
float left_of_key(const Eigen::Vector3f& away, float radius, const Eigen::Vector3f& lamp) {
  const float along = away.dot(lamp);
  if (along <= 0) return 1;
  const float passes = std::sqrt(std::max(away.squaredNorm() - along * along, 0.0f));
  const float soft = kPenumbra * std::max(along, 0.5f * radius);
  const float share = std::clamp((passes - radius) / (2 * soft) + 0.5f, 0.0f, 1.0f);
  return share * share * (3 - 2 * share);
}

constexpr float kPixelsOfTexel = 2;
constexpr int kAtOnce = 8;  // texels of the floor

/// A row of the floor: x = first + column * step. Columns are taken kAtOnce at a time.
struct FloorRow {
  float step, first, y;
  int begin, end;
  float *sky, *key;  // its light
};

/// Takes from a row of the floor what a ball hides of the sky there (hidden_sky with the normal up)
/// and of the lamp (left_of_key). The ball's shade on the sky fades out `outside` away from `middle`.
void shade(const FloorRow& row, const Ball& ball, const Eigen::Vector3f& lamp,
           const Eigen::Vector2f& middle, float outside) {
  using Texels = Eigen::Array<float, kAtOnce, 1>;
  static const Texels steps = Texels::LinSpaced(kAtOnce, 0, kAtOnce - 1);
  constexpr float kFar = 1e6f;
  const float r = ball.radius, z = ball.centre.z();
  const float dy = ball.centre.y() - row.y, middle_y = row.y - middle.y();
  for (int column = row.begin; column < row.end; column += kAtOnce) {
    const Texels x = row.first + row.step * (static_cast<float>(column) + steps);
    const Texels dx = ball.centre.x() - x;
    const Texels distance2 = (dx.square() + (dy * dy + z * z)).max(1e-12f);
    const Texels through_h2 = r * r / distance2.max(r * r);
    Texels hidden;
    if (z > r) {
      hidden = z / distance2.sqrt() * through_h2;
    } else {
      const Texels cosine_h = z / distance2.sqrt().min(r);
      const Texels share = (0.5f * (cosine_h + 1) * through_h2).max(0.0f);
      hidden = share * share.sqrt();
    }
    const Texels far = ((x - middle.x()).square() + middle_y * middle_y) / (outside * outside);
    const Texels fade = (1 - far).max(0.0f).square();

    const Texels along = dx * lamp.x() + (dy * lamp.y() + z * lamp.z());
    // What is nearer to the lamp than the ball is as good as far from it.
    const Texels passes = (distance2 - along.square()).max(0.0f).sqrt() - kFar * along.min(0.0f);
    const Texels soft = 2 * kPenumbra * along.max(0.5f * r);
    const Texels share = ((passes - r) / soft + 0.5f).max(0.0f).min(1.0f);
    Eigen::Map<Texels>(row.sky + column) *= 1 - fade * hidden;
    Eigen::Map<Texels>(row.key + column) *= share.square() * (3 - 2 * share);
  }
}

}  // namespace

Eigen::Vector3f key_light() {
  return {std::cos(kLampElevation) * std::cos(kLampAzimuth),
          std::cos(kLampElevation) * std::sin(kLampAzimuth), std::sin(kLampElevation)};
}

const LightModel& light_model() {
  static const LightModel model{kKey, kSky, kFloor, full_light(), kLeast, kLowSky};
  return model;
}

Light::Light(std::span<const Ball> balls, bool occlusion)
    : balls_(balls), first_(balls.size() + 1) {
  if (!occlusion) return;
  // Along x, sorted, the neighbours of a ball stand near it.
  std::vector<int> order(balls.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto ball = [&](int i) -> const Ball& { return balls_[static_cast<std::size_t>(i)]; };
  std::ranges::sort(order, {}, [&](int i) { return ball(i).centre.x(); });
  float largest = 0;
  for (const Ball& each : balls) largest = std::max(largest, each.radius);
  std::vector<std::size_t> rank(balls.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[static_cast<std::size_t>(order[i])] = i;
  const float reach = kReach * largest;
  for (std::size_t own = 0; own < balls.size(); ++own) {
    const Eigen::Vector3f centre = balls[own].centre;
    const auto take = [&](int other) {
      const float far = std::abs(ball(other).centre.x() - centre.x());
      if (far > reach) return false;
      if ((ball(other).centre - centre).squaredNorm() < reach * reach) neighbours_.push_back(other);
      return true;
    };
    for (std::size_t i = rank[own] + 1; i < order.size() && take(order[i]); ++i) continue;
    for (std::size_t i = rank[own]; i-- > 0 && take(order[i]);) continue;
    first_[own + 1] = neighbours_.size();
  }
}

Light::Left Light::left(std::size_t own, const Eigen::Vector3f& place,
                        const Eigen::Vector3f& normal) const {
  static const Eigen::Vector3f lamp = key_light();
  Left left;
  const bool lit = normal.dot(lamp) > 0;
  for (std::size_t i = first_[own]; i < first_[own + 1]; ++i) {
    const Ball& ball = balls_[static_cast<std::size_t>(neighbours_[i])];
    const Eigen::Vector3f away = ball.centre - place;
    const bool below = normal.dot(away) < -ball.radius;  // the horizon: it hides nothing
    if (!below) left.sky *= 1 - std::min(kCrevice * hidden_sky(away, ball.radius, normal), 1.0f);
    if (lit) left.key *= left_of_key(away, ball.radius, lamp);
  }
  return left;
}

float Light::at(std::size_t own, const Eigen::Vector3f& place,
                const Eigen::Vector3f& normal) const {
  static const Eigen::Vector3f lamp = key_light();
  const auto [sky, key] = left(own, place, normal);
  // A body hides from its lower side the floor's light, the more the lower it lies.
  const float radius = std::max(balls_[own].radius, 1e-6f);
  const float height = std::clamp(place.z() / radius, 0.0f, 1.0f);
  const float light = kKey * std::max(normal.dot(lamp), 0.0f) * key * std::sqrt(sky) +
                      sky * (kSky * (1 + normal.z()) / 2 * (kLowSky + (1 - kLowSky) * height) +
                             kFloor * (1 - normal.z()) / 2 * height);
  return encoded(std::clamp(light / light_model().full, kLeast, 1.0f));
}

void Light::on_floor(float arena_radius, float pixel, FloorLight& floor) const {
  static const Eigen::Vector3f lamp = key_light();
  float smallest = arena_radius;
  for (const Ball& ball : balls_) smallest = std::min(smallest, std::max(ball.radius, 1e-3f));
  // Shades are as soft as this many texels a radius need; more than one a pixel are in vain.
  constexpr float kMostTexels = 10, kLeastTexels = 4;
  const float per_radius =
      std::clamp(smallest / (kPixelsOfTexel * pixel), kLeastTexels, kMostTexels);
  floor.size =
      static_cast<int>(std::clamp(2 * arena_radius / smallest * per_radius, 16.0f, 1024.0f));
  floor.reach = arena_radius;
  const auto size = static_cast<std::size_t>(floor.size);
  const std::size_t width = (size + kAtOnce - 1) / kAtOnce * kAtOnce;  // of a row in memory
  std::vector<float> key(size * width, 1), sky(size * width, 1);
  const float texel = 2 * arena_radius / static_cast<float>(floor.size);
  const auto index = [&](float coordinate) {
    return static_cast<int>(
        std::clamp((coordinate + arena_radius) / texel, 0.0f, static_cast<float>(floor.size)));
  };
  for (const Ball& ball : balls_) {
    const Eigen::Vector3f& centre = ball.centre;
    const float reach = kFloorReach * ball.radius;
    if (centre.z() > 2 * reach) continue;
    // The shadow lies away from the lamp.
    const Eigen::Vector2f shift = -centre.z() / lamp.z() * lamp.head<2>();
    const Eigen::Vector2f middle = centre.head<2>() + 0.5f * shift;
    const float outside = reach + 0.5f * shift.norm();
    const int rows_end = index(middle.y() + outside);
    for (int row = index(middle.y() - outside); row < rows_end; ++row) {
      const float y = (static_cast<float>(row) + 0.5f) * texel - arena_radius;
      const float half2 = outside * outside - (y - middle.y()) * (y - middle.y());
      if (half2 <= 0) continue;
      const float half = std::sqrt(half2);
      const std::size_t first = static_cast<std::size_t>(row) * width;
      shade({texel, texel / 2 - arena_radius, y, index(middle.x() - half) / kAtOnce * kAtOnce,
             index(middle.x() + half), &sky[first], &key[first]},
            ball, lamp, middle, outside);
    }
  }
  floor.texels.resize(size * size);
  std::array<std::uint8_t, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = static_cast<std::uint8_t>(std::lround(255 * encoded(static_cast<float>(i) / 255)));
  }
  const float open = kKey * lamp.z() + kSky;
  std::uint8_t* texel_of = floor.texels.data();
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t i = row * width; i < row * width + size; ++i) {
      const float light = (kKey * lamp.z() * key[i] + kSky * sky[i]) / open;
      *texel_of++ = table[static_cast<std::size_t>(255 * light + 0.5f)];
    }
  }
}

}  // namespace pupflow::view
