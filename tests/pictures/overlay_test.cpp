#include "app/view/overlay.h"

#include <gmock/gmock.h>

#include <cmath>

#include "app/io/failure.h"
#include "app/view/canvas.h"
#include "app/view/mark_painter.h"
#include "pupflow/fields.h"
#include "pupflow/simulation.h"

namespace pupflow::view {
namespace {

using ::testing::HasSubstr;

Simulation huddle() {
  Params params;
  params.ambient_temperature = 0.2;
  params.pups = 6;
  params.arena_radius = 1;
  Simulation simulation(params);
  simulation.set_observed(PartSet::all());
  simulation.run(300);
  return simulation;
}

Marks marks_of(const char* name, const Simulation& simulation, const Trails& trails = Trails()) {
  const LitterView litter = simulation.view();
  std::vector<Eigen::Vector3d> centres;
  for (int pup = 0; pup < litter.pups; ++pup) centres.push_back(litter.positions.mean(pup));
  Marks marks;
  OverlaySet::parse(name).draw({litter, ColorScale(), centres, trails}, marks);
  return marks;
}

template <class Kind>
std::vector<Kind> of_kind(const Marks& marks) {
  std::vector<Kind> found;
  for (const Mark& mark : marks.marks) {
    if (const auto* it = std::get_if<Kind>(&mark)) found.push_back(*it);
  }
  return found;
}

TEST(Overlays, AreNamedOnceAndHaveALegend) {
  const Simulation simulation = huddle();
  for (const Overlay& overlay : overlays()) {
    const OverlaySet set = OverlaySet::parse(overlay.name);
    EXPECT_EQ(set.names(), overlay.name);
    EXPECT_TRUE(set.has(overlay.name));
    EXPECT_FALSE(marks_of(std::string(overlay.name).c_str(), simulation).legend.empty())
        << overlay.name;
  }
}

TEST(Overlays, AreASet) {
  EXPECT_TRUE(OverlaySet::parse("").empty());
  const OverlaySet set = OverlaySet::parse("ids,contacts,ids");
  EXPECT_EQ(set, OverlaySet::parse("contacts,ids"));
  EXPECT_EQ(set, OverlaySet::parse(set.names()));
  EXPECT_FALSE(set.has("trails"));
  EXPECT_TRUE(set.parts().has(Part::pairs));
  for (const char* wrong : {"id", "contacts,,ids", "nonsense", ","}) {
    EXPECT_THROW(OverlaySet::parse(wrong), io::Failure) << wrong;
  }
  try {
    OverlaySet::parse("headigns");
    FAIL();
  } catch (const io::Failure& failure) {
    EXPECT_THAT(failure.what(), HasSubstr("did you mean 'headings'?"));
  }
}

TEST(Overlays, ContactsAreLinesBetweenCentresAsWideAsTheyTouch) {
  const Simulation simulation = huddle();
  const LitterView litter = simulation.view();
  ASSERT_GT(litter.touching.size(), 2u);
  std::vector<Segment> lines;
  for (const Segment& segment : of_kind<Segment>(marks_of("contacts", simulation))) {
    if (segment.from != segment.to) lines.push_back(segment);
  }
  ASSERT_EQ(lines.size(), litter.touching.size());
  std::vector<int> points(litter.touching.size(), 0);
  for (std::size_t i = 0; i < litter.touched.size(); ++i) {
    const int pup = static_cast<int>(i) / litter.points;
    for (std::size_t pair = 0; pair < points.size(); ++pair) {
      const auto [first, second] = litter.touching[pair];
      points[pair] += (pup == first && litter.touched[i] == second) ||
                      (pup == second && litter.touched[i] == first);
    }
  }
  for (std::size_t a = 0; a < lines.size(); ++a) {
    EXPECT_EQ(lines[a].from, litter.positions.mean(litter.touching[a].first));
    EXPECT_EQ(lines[a].to, litter.positions.mean(litter.touching[a].second));
    for (std::size_t b = 0; b < lines.size(); ++b) {
      if (points[a] > points[b]) continue;
      EXPECT_LE(lines[a].width, lines[b].width);
    }
  }
}

TEST(Overlays, HeadingsPointWherePupsTravel) {
  const Simulation simulation = huddle();
  const auto arrows = of_kind<Arrow>(marks_of("headings", simulation));
  ASSERT_EQ(arrows.size(), 6u);
  for (std::size_t pup = 0; pup < arrows.size(); ++pup) {
    const Eigen::Vector3d way = arrows[pup].to - arrows[pup].from;
    EXPECT_NEAR(
        std::remainder(std::atan2(way.y(), way.x()) - simulation.view().heading[pup], 6.283185307),
        0, 1e-6);
  }
}

TEST(Overlays, GroupsAreSurroundedAndCounted) {
  const Simulation simulation = huddle();
  const LitterView litter = simulation.view();
  const auto labels = group_labels(litter.pups, litter.touching);
  const auto sizes = group_sizes(labels);
  const Marks marks = marks_of("groups", simulation);
  const auto polygons = of_kind<Polygon>(marks);
  const auto numbers = of_kind<Label>(marks);
  ASSERT_EQ(polygons.size(), numbers.size());
  std::size_t outlined = 0;
  for (std::size_t group = 0; group < sizes.size(); ++group) {
    if (sizes[group] < 2) continue;
    EXPECT_EQ(numbers[outlined].text.front().text, std::to_string(sizes[group]));
    // Each centre is to the left of every edge: inside.
    const auto& corners = polygons[outlined++].corners;
    for (int pup = 0; pup < litter.pups; ++pup) {
      if (labels[static_cast<std::size_t>(pup)] != static_cast<int>(group)) continue;
      const Eigen::Vector3d centre = litter.positions.mean(pup);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector3d &a = corners[i], &b = corners[(i + 1) % corners.size()];
        EXPECT_GT((b - a).x() * (centre - a).y() - (b - a).y() * (centre - a).x(), 0);
      }
    }
  }
  EXPECT_EQ(outlined, polygons.size());
  EXPECT_GT(outlined, 0u);
}

TEST(Overlays, IdsNumberThePups) {
  const auto labels = of_kind<Label>(marks_of("ids", huddle()));
  ASSERT_EQ(labels.size(), 6u);
  for (std::size_t pup = 0; pup < 6; ++pup) {
    EXPECT_EQ(labels[pup].text.front().text, std::to_string(pup));
  }
}

TEST(Overlays, TrailsGoBackAsFarAsTheyAreLong) {
  Simulation simulation = huddle();
  Trails trails(0.2);  // 20 steps
  for (int step = 0; step < 50; ++step) {
    simulation.step();
    trails.add(simulation.view());
  }
  const auto lines = of_kind<Polyline>(marks_of("trails", simulation, trails));
  ASSERT_EQ(lines.size(), 6u);
  for (std::size_t pup = 0; pup < 6; ++pup) {
    EXPECT_EQ(lines[pup].points.size(), 21u);
    const Eigen::Vector3d now = simulation.view().positions.mean(static_cast<int>(pup));
    EXPECT_LT((lines[pup].points.back() - now).norm(), 1e-5);
  }
  const Simulation another(huddle().params());  // back at t = 0
  trails.add(another.view());
  EXPECT_EQ(trails.of(0).size(), 1u);
}

TEST(Overlays, ForcesPushTheUpperOfTwoPupsUp) {
  Params params;
  params.pups = 2;
  params.start_spread = 0;
  params.drive = 0;
  Simulation simulation(params);
  simulation.set_observed(PartSet::all());
  simulation.run(150);  // one lies on the other
  ASSERT_FALSE(simulation.view().touching.empty());
  const auto arrows = of_kind<Arrow>(marks_of("forces", simulation));
  ASSERT_EQ(arrows.size(), 2u);  // no drive
  double highest = 0;
  for (const Arrow& arrow : arrows) highest = std::max(highest, (arrow.to - arrow.from).z());
  EXPECT_GT(highest, 0.1);
}

TEST(Marks, ArePaintedWhereTheyAre) {
  Camera camera = Camera::parse("top");
  camera.frame(2, 0.6, 1);
  const Bounds bounds{{-2, -2, 0}, {2, 2, 1}};
  const Projection projection(camera, bounds, 200, 200);
  io::Image image(200, 200);
  fill(image, {0, 0, 200, 200}, {255, 255, 255});
  TextPainter text;
  Marks marks;
  const Ink black{{0, 0, 0}};
  marks.marks.emplace_back(Segment{{-1, 0, 0}, {1, 0, 0}, 20, black});
  marks.marks.emplace_back(
      Polygon{{{-1, 1, 0}, {1, 1, 0}, {1, 1.5, 0}, {-1, 1.5, 0}}, 2, black, {{0, 0, 255}, 1}});
  paint_marks(image, text, marks, projection);
  Eigen::Vector2d place;
  const auto at = [&](double x, double y) {
    EXPECT_TRUE(projection.place({x, y, 0}, place));
    const std::uint8_t* p = image.pixel(static_cast<int>(place.x()), static_cast<int>(place.y()));
    return Rgb{p[0], p[1], p[2]};
  };
  EXPECT_EQ(at(0, 0), (Rgb{0, 0, 0}));
  EXPECT_EQ(at(0.95, 0), (Rgb{0, 0, 0}));
  EXPECT_EQ(at(1.2, 0), (Rgb{255, 255, 255}));
  EXPECT_EQ(at(0, 0.5), (Rgb{255, 255, 255}));
  EXPECT_EQ(at(0.5, 1.25), (Rgb{0, 0, 255}));
}

TEST(Marks, OfTheFloorAreHiddenByBodiesInFrontOfThem) {
  Camera camera = Camera::parse("side");
  const Ball body{{0, 0, 0.3f}, 0.3f};
  const Projection projection(camera, {{-2, -2, 0}, {2, 2, 1}}, 100, 100, std::span(&body, 1));
  EXPECT_TRUE(projection.hidden({0, 1, 0.2}));  // behind it: the side view looks along +y
  EXPECT_FALSE(projection.hidden({0, -1, 0.2}));
  EXPECT_FALSE(projection.hidden({1, 1, 0.2}));
}

}  // namespace
}  // namespace pupflow::view
