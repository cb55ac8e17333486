#include "app/view/camera.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "app/io/failure.h"
#include "app/io/text.h"

namespace pupflow::view {

namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kNearest = 0.05, kFurthest = 1e6;
constexpr double kNarrowest = 1, kWidest = 150;  // views, degrees
constexpr double kMargin = 1.04;                 // room left around a framed arena

[[noreturn]] void fail(const std::string& spec) {
  throw io::Failure(io::ExitCode::bad_input,
                    "camera '" + spec +
                        "' is none of: top, side, orbit:azimuth,elevation[,distance[,view]] with "
                        "the elevation in -90 ... 90 degrees, the distance in 0.05 ... 1e6 and "
                        "the view in 1 ... 150 degrees");
}

std::vector<double> numbers_in(const std::string& spec, std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    const std::string_view field = text.substr(0, text.find(','));
    double value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc{} || end != field.data() + field.size() || !std::isfinite(value)) {
      fail(spec);
    }
    numbers.push_back(value);
    if (field.size() == text.size()) return numbers;
    text.remove_prefix(field.size() + 1);
  }
}

}  // namespace

Camera Camera::parse(const std::string& spec) {
  Camera camera;
  camera.typed_ = spec;
  if (spec == "top" || spec == "side") {
    camera.projection_ = Projection::orthographic;
    camera.azimuth_ = -90 * kRadians;
    camera.elevation_ = spec == "top" ? 90 * kRadians : 0;
    return camera;
  }
  constexpr std::string_view kOrbit = "orbit:";
  if (!spec.starts_with(kOrbit)) fail(spec);
  const auto numbers = numbers_in(spec, std::string_view(spec).substr(kOrbit.size()));
  if (numbers.size() < 2 || numbers.size() > 4 || std::abs(numbers[1]) > 90) fail(spec);
  camera.azimuth_ = std::remainder(numbers[0], 360) * kRadians;
  camera.elevation_ = numbers[1] * kRadians;
  if (numbers.size() >= 3) {
    if (numbers[2] < kNearest || numbers[2] > kFurthest) fail(spec);
    camera.distance_ = numbers[2];
    camera.fixed_distance_ = true;
  }
  if (numbers.size() == 4) {
    if (numbers[3] < kNarrowest || numbers[3] > kWidest) fail(spec);
    camera.tan_half_view_ = std::tan(numbers[3] / 2 * kRadians);
  }
  return camera;
}

Camera Camera::along(const Eigen::Vector3d& eye, double azimuth, double distance, double view) {
  Camera camera;
  camera.moved_ = true;
  camera.azimuth_ = std::remainder(azimuth + std::numbers::pi, 2 * std::numbers::pi);
  camera.distance_ = std::max(distance, kNearest);
  camera.tan_half_view_ = std::tan(view / 2);
  camera.look_at(eye - camera.distance_ * camera.backward());
  return camera;
}

std::string Camera::spec() const {
  if (!moved_ || projection_ == Projection::orthographic) return typed_;
  std::string text = "orbit:" + io::number_text(azimuth_ / kRadians) + ',' +
                     io::number_text(elevation_ / kRadians) + ',' + io::number_text(distance_);
  if (tan_half_view_ != kTanHalfView) {
    text += ',' + io::number_text(2 * std::atan(tan_half_view_) / kRadians);
  }
  return text;
}

Eigen::Vector3d Camera::right() const {
  return {-std::sin(azimuth_), std::cos(azimuth_), 0};
}

Eigen::Vector3d Camera::backward() const {
  return {std::cos(elevation_) * std::cos(azimuth_), std::cos(elevation_) * std::sin(azimuth_),
          std::sin(elevation_)};
}

Eigen::Vector3d Camera::up() const {
  const Eigen::Vector3d b = backward(), r = right();
  return {b.y() * r.z() - b.z() * r.y(), b.z() * r.x() - b.x() * r.z(),
          b.x() * r.y() - b.y() * r.x()};
}

double Camera::half_height() const {
  return distance_ * tan_half_view_;
}

void Camera::look_at(const Eigen::Vector3d& target) {
  target_ = target;
  targeted_ = true;
}

void Camera::frame(double arena_radius, double height, double aspect) {
  if (fixed_distance_ || moved_) return;
  const Eigen::Vector3d given = target_;
  target_.setZero();
  const double tangent[2] = {tan_half_view_ * aspect / kMargin, tan_half_view_ / kMargin};
  // A point at (u, v, w) in camera axes is in the picture when |u - shift| <= tangent (d - w), and
  // |u - shift| <= tangent d without perspective. Both sides' bounds on d meet at the best shift.
  double least[2] = {-1e300, -1e300}, most[2] = {-1e300, -1e300};
  const Eigen::Vector3d axis[2] = {right(), up()};
  constexpr int kSamples = 64;
  for (int i = 0; i < 2 * kSamples; ++i) {
    const double angle = 2 * std::numbers::pi * (i / 2) / kSamples;
    const Eigen::Vector3d point(arena_radius * std::cos(angle), arena_radius * std::sin(angle),
                                i % 2 == 0 ? 0 : height);
    const double depth = projection_ == Projection::perspective ? point.dot(backward()) : 0;
    for (int a = 0; a < 2; ++a) {
      const double reach = point.dot(axis[a]) / tangent[a];
      least[a] = std::max(least[a], depth - reach);
      most[a] = std::max(most[a], depth + reach);
    }
  }
  distance_ = 0;
  for (int a = 0; a < 2; ++a) {
    distance_ = std::max(distance_, (least[a] + most[a]) / 2);
    target_ += tangent[a] * (most[a] - least[a]) / 2 * axis[a];
  }
  if (targeted_) target_ = given;
}

void Camera::orbit(double d_azimuth, double d_elevation) {
  moved_ = true;
  if (projection_ == Projection::orthographic) {
    projection_ = Projection::perspective;
    target_ -= target_.dot(backward()) * backward();
  }
  azimuth_ = std::remainder(azimuth_ + d_azimuth, 2 * std::numbers::pi);
  elevation_ = std::clamp(elevation_ + d_elevation, -90 * kRadians, 90 * kRadians);
}

void Camera::pan(double right_share, double up_share) {
  moved_ = true;
  target_ -= 2 * half_height() * (right_share * right() + up_share * up());
}

void Camera::zoom(double factor) {
  moved_ = true;
  distance_ = std::clamp(distance_ / factor, kNearest, kFurthest);
}

void Camera::zoom_at(double factor, double right_share, double up_share) {
  const double before = half_height();
  zoom(factor);
  const double gained = 2 * (before - half_height());
  target_ += gained * (right_share * right() + up_share * up());
}

CameraMatrices Camera::matrices(double aspect, const Bounds& bounds) const {
  const Eigen::Vector3d axes[3] = {right(), up(), backward()};
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  for (int i = 0; i < 3; ++i) {
    view.row(i) << axes[i].x(), axes[i].y(), axes[i].z(), -axes[i].dot(eye());
  }
  // Depth of the box along the line of sight: its middle, and the reach of its half edges.
  const Eigen::Vector3d middle = (bounds.low + bounds.high) / 2;
  const Eigen::Vector3d half = (bounds.high - bounds.low) / 2;
  const double depth = backward().dot(eye() - middle);
  const double reach = 1.01 * backward().cwiseAbs().dot(half) + 1e-3;
  double near = depth - reach, far = depth + reach;

  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  if (projection_ == Projection::perspective) {
    near = std::max(near, 0.02 * distance_);
    far = std::max(far, 2 * near);
    projection(0, 0) = 1 / (tan_half_view_ * aspect);
    projection(1, 1) = 1 / tan_half_view_;
    projection(2, 2) = -(far + near) / (far - near);
    projection(2, 3) = -2 * far * near / (far - near);
    projection(3, 2) = -1;
  } else {
    projection(0, 0) = 1 / (half_height() * aspect);
    projection(1, 1) = 1 / half_height();
    projection(2, 2) = -2 / (far - near);
    projection(2, 3) = -(far + near) / (far - near);
    projection(3, 3) = 1;
  }
  return {view.cast<float>(), projection.cast<float>(), projection_ == Projection::perspective};
}

}  // namespace pupflow::view
