#include "app/pictures/annotations.h"

#include <algorithm>
#include <string>

#include "app/gl/renderer.h"
#include "app/io/celsius.h"
#include "app/io/text.h"
#include "app/view/color_bar.h"

namespace pupflow::pictures {

namespace {

constexpr double kLeastText = 6.5;  // pixels
constexpr double kMargin = 0.8;     // around words, in text sizes

view::TextLine caption_of(const LitterView& litter, const Look& look) {
  const Params& params = litter.params;
  view::TextLine caption = view::symbol("T", "a");
  const std::string label(look.scale.field->label);
  return caption + (" = " +
                    io::with_celsius(view::tick_label(params.ambient_temperature),
                                     params.ambient_temperature, look.celsius) +
                    ", " + io::formatted("%.2f", litter.time) + " s, seed " +
                    std::to_string(params.seed) + ", " + std::to_string(litter.pups) +
                    (litter.pups == 1 ? " pup, " : " pups, ") + "color: " + label);
}

}  // namespace

std::vector<view::Flat> annotations(const view::Marks& marks, double mark_scale, const Look& look,
                                    const Annotated& scene) {
  std::vector<view::Flat> flats;
  view::flatten(marks, scene.projection, mark_scale, flats);
  if (scene.height < kLeastForWords) return flats;
  const double size = scene.text_size, margin = kMargin * size;
  if (view::legend_width(scene.width_of, marks.legend, size) + 2 * margin < scene.width) {
    view::flatten_legend(marks.legend, margin, margin, size, flats);
  }
  const double bar = add_scale_bar(flats, scene.width, scene.height, scene.camera, size, scene.ink);
  if (!look.caption) return flats;
  const view::TextLine caption = caption_of(scene.litter, look);
  // Smaller where it would run into the scale bar, and not at all where nobody could read it.
  const double room = scene.width - bar - 2 * margin;
  const double fitting = std::min(size, size * room / scene.width_of(caption, size));
  if (fitting < kLeastText) return flats;
  flats.emplace_back(view::FlatText{{margin, scene.height - margin}, caption, fitting, scene.ink});
  return flats;
}

double add_scale_bar(std::vector<view::Flat>& flats, double width, double height,
                     const view::Camera& camera, double text_size, view::Rgb ink) {
  const double unit = height / (2 * camera.half_height()), size = text_size;
  double length = static_cast<double>(gl::kGridSpacing);
  while (length * unit < 2 * size) length *= 2;
  const double right = width - kMargin * size, left = right - length * unit;
  const double bottom = height - kMargin * size, tick = 0.3 * size;
  if (left < kMargin * size || height < kLeastForWords) return 0;
  const auto stroke = [&](double x0, double y0, double x1, double y1) {
    flats.emplace_back(view::FlatLine{{x0, y0}, {x1, y1}, size / 9, {ink}});
  };
  stroke(left, bottom, right, bottom);
  stroke(left, bottom - tick, left, bottom + tick);
  stroke(right, bottom - tick, right, bottom + tick);
  flats.emplace_back(view::FlatText{{(left + right) / 2, bottom - 0.5 * size},
                                    {{view::tick_label(length)}},
                                    size,
                                    ink,
                                    view::Align::centre});
  return width - left;
}

std::vector<Eigen::Vector3d> centres_of(const LitterView& litter) {
  std::vector<Eigen::Vector3d> centres;
  for (int pup = 0; pup < litter.pups; ++pup) centres.push_back(litter.positions.mean(pup));
  return centres;
}

}  // namespace pupflow::pictures
