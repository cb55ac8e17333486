#include "app/pictures/picture.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "app/context/headless.h"
#include "app/gl/target.h"
#include "app/io/failure.h"
#include "app/io/memory.h"
#include "app/io/text.h"
#include "app/view/canvas.h"

namespace pupflow::pictures {

namespace {

std::string limits(int least, int most) {
  return std::to_string(least) + " ... " + std::to_string(most);
}

}  // namespace

Headless::Headless(const Look& look) {
  context::ContextReport report;
  context = context::make_headless(report);
  if (look.verbose) {
    for (const std::string& line : report.tried) std::cerr << "OpenGL: " << line << '\n';
    std::cerr << "OpenGL: " << report.renderer << ", " << report.version << '\n';
  }
  renderer = std::make_unique<gl::Renderer>(look.shader_dir);
}

Simulation observed_litter(const Params& params, const Field& field) {
  std::string problems;
  for (const Problem& problem : check(params)) {
    problems += (problems.empty() ? "" : "; ") + problem.message;
  }
  if (!problems.empty()) io::refuse(problems);
  Simulation simulation(params);
  simulation.set_observed(field.parts);
  return simulation;
}

Picture::Picture(int width, int height, bool bar, const Look& look)
    : width_(width),
      height_(height),
      bar_(bar),
      scale_(look.scale),
      supersample_(look.supersample),
      style_{.text_size = std::clamp(height / 48.0, 9.0, 64.0)},
      margins_(view::color_bar_margins(look.scale, style_)),
      bar_width_(static_cast<int>(std::lround(1.3 * style_.text_size))) {
  check_samples(supersample_);
  for (const int side : {width, height}) {
    if (side >= kSmallestSide && side <= kLargestSide) continue;
    io::refuse("a picture's sides must be " + limits(kSmallestSide, kLargestSide) +
               " pixels, not " + std::to_string(width) + "x" + std::to_string(height));
  }
  const int gap = static_cast<int>(style_.text_size);
  const int strip = margins_.left + bar_width_ + margins_.right + gap;
  scene_width_ = bar ? width - strip : width;
  if (scene_width_ < kSmallestSide) {
    io::refuse("a picture " + std::to_string(width) + " pixels wide has no room for the color bar");
  }
}

void Picture::refuse_large() const {
  pictures::refuse_large(width_, height_, scene_width_, height_, supersample_);
}

io::Image Picture::draw(gl::Renderer& renderer, const LitterView& litter,
                        const view::Camera& camera) {
  list_.update(litter, scale_, camera);
  renderer.upload(list_);
  io::Image scene = renderer.picture(camera, scene_width_, height_, supersample_);
  return bar_ ? with_legend(scene, litter.params.preferred_temperature) : scene;
}

io::Image Picture::with_legend(const io::Image& scene, double tp) {
  io::Image picture(width_, height_);
  view::fill(picture, {0, 0, width_, height_}, gl::Palette{}.background);
  view::blit(picture, scene, 0, 0);
  const int inset = height_ / 8;
  const view::Box bar{scene_width_ + margins_.left, inset, bar_width_, height_ - 2 * inset};
  view::draw_color_bar(picture, text_,
                       view::lay_out_color_bar(bar, margins_, list_.scale(), tp, style_),
                       style_.ink);
  return picture;
}

io::TextEntries Picture::look_entries() const {
  return pictures::look_entries(list_.scale(), supersample_);
}

void check_samples(int supersample) {
  if (supersample >= 1 && supersample <= kMostSamples) return;
  io::refuse("the samples across a pixel must be " + limits(1, kMostSamples) + ", not " +
             std::to_string(supersample));
}

void refuse_large(int width, int height, int drawn_width, int drawn_height, int supersample) {
  // A sample has color and depth; a pixel passes through copies on its way to the file.
  constexpr double kOfSample = 8, kOfPixel = 32;
  gl::Target::refuse_large(drawn_width * supersample, drawn_height * supersample);
  const double samples = static_cast<double>(supersample) * supersample;
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  io::refuse_large("a picture of " + size + " pixels with " + std::to_string(supersample) + " x " +
                       std::to_string(supersample) + " samples each",
                   kOfSample * samples * drawn_width * drawn_height +
                       kOfPixel * static_cast<double>(width) * height,
                   "fewer of either need less");
}

io::TextEntries look_entries(const view::ColorScale& scale, int supersample) {
  io::TextEntries entries{{"color_by", std::string(scale.field->name)}};
  if (!scale.categorical()) {
    entries.emplace_back("colormap", scale.map_name);
    entries.emplace_back("scale", io::number_text(scale.min) + "," + io::number_text(scale.max));
  }
  entries.emplace_back("supersample", std::to_string(supersample));
  return entries;
}

}  // namespace pupflow::pictures
