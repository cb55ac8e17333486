#include "app/view/camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "app/io/failure.h"

namespace pupflow::view {
namespace {

constexpr double kDegrees = std::numbers::pi / 180;
using Vector = Eigen::Vector3d;

double distance_between(const Vector& a, const Vector& b) {
  return (a - b).norm();
}

/// Normalised device coordinates of a world point.
Vector project(const Camera& camera, double aspect, const Bounds& bounds, const Vector& point) {
  const CameraMatrices m = camera.matrices(aspect, bounds);
  const Eigen::Vector4f clip =
      m.clip_from_eye * m.eye_from_world * point.cast<float>().homogeneous();
  return (clip.head<3>() / clip.w()).cast<double>();
}

const Bounds kBounds{Vector(-2, -2, 0), Vector(2, 2, 1)};

TEST(Camera, TopLooksDownWithYUpwards) {
  const Camera camera = Camera::parse("top");
  EXPECT_EQ(camera.projection(), Camera::Projection::orthographic);
  EXPECT_LT(distance_between(camera.right(), Vector::UnitX()), 1e-12);
  EXPECT_LT(distance_between(camera.up(), Vector::UnitY()), 1e-12);
  EXPECT_LT(distance_between(camera.backward(), Vector::UnitZ()), 1e-12);
}

TEST(Camera, SideLooksAlongYWithZUpwards) {
  const Camera camera = Camera::parse("side");
  EXPECT_EQ(camera.projection(), Camera::Projection::orthographic);
  EXPECT_LT(distance_between(camera.right(), Vector::UnitX()), 1e-12);
  EXPECT_LT(distance_between(camera.up(), Vector::UnitZ()), 1e-12);
}

TEST(Camera, OrbitReadsAnglesAndDistance) {
  const Camera camera = Camera::parse("orbit:30,45,8");
  EXPECT_EQ(camera.projection(), Camera::Projection::perspective);
  const double flat = 8 * std::cos(45 * kDegrees);
  const Vector eye(flat * std::cos(30 * kDegrees), flat * std::sin(30 * kDegrees),
                   8 * std::sin(45 * kDegrees));
  EXPECT_LT(distance_between(camera.eye(), eye), 1e-12);
  EXPECT_EQ(Camera::parse("orbit:390,45,8").eye().isApprox(eye, 1e-12), true);
  EXPECT_NO_THROW(Camera::parse("orbit:-12.5,-90"));
}

TEST(Camera, AViewIsTheAngleFromBottomToTop) {
  const Camera usual = Camera::parse("orbit:30,45,8"), wide = Camera::parse("orbit:30,45,8,90");
  EXPECT_NEAR(usual.half_height(), 8 * std::tan(15 * kDegrees), 1e-12);
  EXPECT_NEAR(wide.half_height(), 8, 1e-12);
  const Vector at_the_top = wide.target() + 8 * wide.up();
  EXPECT_NEAR(project(wide, 1.5, kBounds, at_the_top).y(), 1, 1e-6);
}

TEST(Camera, ACameraAlongTheFloorLooksStraightAheadAndCanBeWrittenDown) {
  const Vector eye(0.4, -0.3, 0.2);
  const Camera camera = Camera::along(eye, 2, 0.25, 1.5);
  EXPECT_LT(distance_between(camera.eye(), eye), 1e-12);
  EXPECT_LT(distance_between(-camera.backward(), Vector(std::cos(2), std::sin(2), 0)), 1e-12);
  EXPECT_LT(distance_between(camera.up(), Vector::UnitZ()), 1e-12);
  Camera framed = camera;
  framed.frame(2, 0.6, 1.5);
  EXPECT_EQ(framed, camera) << "framing leaves it alone";
  Camera read = Camera::parse(camera.spec());
  read.look_at(camera.target());
  EXPECT_LT(distance_between(read.eye(), eye), 1e-12);
  EXPECT_NEAR(read.half_height(), camera.half_height(), 1e-12);
  EXPECT_LT(distance_between(read.backward(), camera.backward()), 1e-12);
}

TEST(Camera, AxesAreRightHandedAtTheZenithToo) {
  for (const char* spec : {"top", "side", "orbit:200,89.9", "orbit:10,90", "orbit:77,-90"}) {
    const Camera camera = Camera::parse(spec);
    EXPECT_LT(distance_between(camera.right().cross(camera.up()), camera.backward()), 1e-12)
        << spec;
    EXPECT_NEAR(camera.up().norm(), 1, 1e-12) << spec;
  }
}

TEST(Camera, RefusesWhatIsNoCamera) {
  for (const char* spec : {"",
                           "Top",
                           "front",
                           "orbit",
                           "orbit:",
                           "orbit:30",
                           "orbit:30,",
                           "orbit:30,35,",
                           "orbit:,35",
                           "orbit:30,91",
                           "orbit:30,-90.5",
                           "orbit:30,35,0",
                           "orbit:30,35,-4",
                           "orbit:30,35,1e7",
                           "orbit:30,35,9,0.9",
                           "orbit:30,35,9,151",
                           "orbit:30,35,9,40,1",
                           "orbit:30 ,35",
                           "orbit:nan,35",
                           "orbit:inf,35",
                           "orbit:a,b",
                           "top "}) {
    try {
      Camera::parse(spec);
      ADD_FAILURE() << "'" << spec << "' was taken";
    } catch (const io::Failure& failure) {
      EXPECT_EQ(failure.code(), io::ExitCode::bad_input) << spec;
      EXPECT_NE(std::string(failure.what()).find("orbit:azimuth,elevation"), std::string::npos);
    }
  }
}

TEST(Camera, FramedArenaFillsThePictureAndStaysInside) {
  for (const char* spec : {"top", "side", "orbit:30,35", "orbit:-70,5", "orbit:0,90"}) {
    for (const double aspect : {0.5, 1.0, 4.0 / 3, 2.5}) {
      Camera camera = Camera::parse(spec);
      camera.frame(2, 0.6, aspect);
      Eigen::Array2d low(1e9, 1e9), high(-1e9, -1e9);
      for (int i = 0; i < 720; ++i) {
        const double angle = i / 2 * kDegrees;
        const Vector point(2 * std::cos(angle), 2 * std::sin(angle), i % 2 == 0 ? 0 : 0.6);
        const Eigen::Array2d place = project(camera, aspect, kBounds, point).head<2>();
        low = low.min(place);
        high = high.max(place);
      }
      EXPECT_LT(high.maxCoeff(), 1) << spec << " " << aspect;
      EXPECT_GT(low.minCoeff(), -1) << spec << " " << aspect;
      EXPECT_GT((high - low).maxCoeff(), 1.85) << spec << " " << aspect;  // of 2
    }
  }
}

TEST(Camera, FramingKeepsADistanceThatWasAskedFor) {
  Camera camera = Camera::parse("orbit:30,35,9");
  camera.frame(50, 1, 1);
  EXPECT_EQ(camera.distance(), 9);
  EXPECT_EQ(camera.target(), Vector(0, 0, 0));
}

TEST(Camera, EverythingInTheBoundsIsBetweenTheClipPlanes) {
  const Bounds tall{Vector(-2, -2, -0.1), Vector(2, 2, 1500)};
  for (const char* spec : {"top", "side", "orbit:30,35,12", "orbit:120,-20"}) {
    Camera camera = Camera::parse(spec);
    camera.frame(2, 0.6, 1.5);
    for (int corner = 0; corner < 8; ++corner) {
      const Vector point(corner & 1 ? 2 : -2, corner & 2 ? 2 : -2, corner & 4 ? 1500 : -0.1);
      if ((camera.eye() - point).dot(camera.backward()) <= 0 &&
          camera.projection() == Camera::Projection::perspective) {
        continue;  // behind the eye
      }
      EXPECT_LE(std::abs(project(camera, 1.5, tall, point).z()), 1) << spec << " " << corner;
    }
  }
}

TEST(Camera, OrbitTurnsAroundTheTargetAndStopsAtTheZenith) {
  Camera camera = Camera::parse("orbit:0,0,5");
  camera.orbit(90 * kDegrees, 30 * kDegrees);
  EXPECT_NEAR(camera.azimuth(), 90 * kDegrees, 1e-12);
  EXPECT_NEAR(camera.elevation(), 30 * kDegrees, 1e-12);
  EXPECT_NEAR(camera.eye().norm(), 5, 1e-12);
  camera.orbit(0, 10);
  EXPECT_NEAR(camera.elevation(), 90 * kDegrees, 1e-12);
  camera.orbit(0, -20);
  EXPECT_NEAR(camera.elevation(), -90 * kDegrees, 1e-12);
}

TEST(Camera, IsWrittenAsTypedUntilItIsMoved) {
  for (const char* spec : {"top", "side", "orbit:30,35", "orbit:030,35.0,9"}) {
    EXPECT_EQ(Camera::parse(spec).spec(), spec);
    EXPECT_FALSE(Camera::parse(spec).moved());
  }
  Camera camera = Camera::parse("orbit:10,20,8");
  camera.zoom(2);
  EXPECT_TRUE(camera.moved());
  EXPECT_EQ(Camera::parse(camera.spec()).eye().isApprox(camera.eye(), 1e-9), true);
  Camera flat = Camera::parse("top");
  flat.pan(0.1, 0);
  EXPECT_EQ(flat.spec(), "top");
}

TEST(Camera, FramingLeavesACameraThatWasMovedByHand) {
  Camera camera = Camera::parse("orbit:30,35");
  camera.frame(2, 0.6, 1);
  camera.orbit(0.1, 0);
  const double distance = camera.distance();
  camera.frame(50, 1, 1);
  EXPECT_EQ(camera.distance(), distance);
}

TEST(Camera, TurningTheViewFromTheTopGivesItPerspective) {
  Camera camera = Camera::parse("top");
  camera.frame(2, 0.6, 1);
  camera.pan(0.25, 0);
  const Vector seen = camera.target();
  camera.orbit(0, 0);
  EXPECT_EQ(camera.projection(), Camera::Projection::perspective);
  EXPECT_LT(distance_between(camera.target(), Vector(seen.x(), seen.y(), 0)), 1e-12);
}

TEST(Camera, PanMovesTheSceneByThatShareOfThePicture) {
  for (const char* spec : {"top", "orbit:30,35,9"}) {
    Camera camera = Camera::parse(spec);
    camera.frame(2, 0.6, 1);
    const Vector point = camera.target();  // in the middle of the picture
    camera.pan(0.25, -0.1);
    const Vector moved = project(camera, 1, kBounds, point);
    EXPECT_NEAR(moved.x(), 2 * 0.25, 1e-5) << spec;
    EXPECT_NEAR(moved.y(), 2 * -0.1, 1e-5) << spec;
  }
}

TEST(Camera, ZoomTowardsAPlaceKeepsWhatLiesThere) {
  for (const char* spec : {"top", "side", "orbit:30,35,9", "orbit:-100,80"}) {
    for (const double factor : {1.1, 3.0, 0.5}) {
      Camera camera = Camera::parse(spec);
      camera.frame(2, 0.6, 1);
      const double right = 0.31, up = -0.22;
      const Vector there =
          camera.target() + 2 * camera.half_height() * (right * camera.right() + up * camera.up());
      const double distance = camera.distance();
      camera.zoom_at(factor, right, up);
      EXPECT_DOUBLE_EQ(camera.distance(), distance / factor) << spec;
      const Vector seen = project(camera, 1, kBounds, there);
      EXPECT_NEAR(seen.x(), 2 * right, 1e-5) << spec;
      EXPECT_NEAR(seen.y(), 2 * up, 1e-5) << spec;
    }
  }
}

TEST(Camera, ZoomTowardsAPlaceStaysWhereItIsAtItsLimit) {
  Camera camera = Camera::parse("orbit:30,35,0.05");
  const Vector target = camera.target();
  camera.zoom_at(2, 0.4, 0.4);
  EXPECT_EQ(camera.target(), target);
}

TEST(Camera, ZoomDividesTheDistanceWithinLimits) {
  Camera camera = Camera::parse("orbit:30,35,8");
  camera.zoom(2);
  EXPECT_DOUBLE_EQ(camera.distance(), 4);
  camera.zoom(1e9);
  EXPECT_DOUBLE_EQ(camera.distance(), 0.05);
  camera.zoom(1e-12);
  EXPECT_DOUBLE_EQ(camera.distance(), 1e6);
}

}  // namespace
}  // namespace pupflow::view
