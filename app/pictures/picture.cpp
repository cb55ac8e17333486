#include "app/pictures/picture.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <utility>

#include "app/context/headless.h"
#include "app/gl/target.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/memory.h"
#include "app/io/text.h"
#include "app/pictures/annotations.h"
#include "app/view/canvas.h"
#include "app/view/mark_painter.h"

namespace pupflow::pictures {

namespace {

std::string limits(int least, int most) {
  return std::to_string(least) + " ... " + std::to_string(most);
}

void refuse_interrupted() {
  if (io::interrupted()) throw io::Failure(io::ExitCode::interrupted, "interrupted while drawing");
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

Simulation observed_litter(const Params& params, PartSet parts) {
  std::string problems;
  for (const Problem& problem : check(params)) {
    problems += (problems.empty() ? "" : "; ") + problem.message;
  }
  if (!problems.empty()) io::refuse(problems);
  Simulation simulation(params);
  simulation.set_observed(parts);
  return simulation;
}

Picture::Picture(int width, int height, bool bar, const Look& look)
    : width_(width),
      height_(height),
      bar_(bar),
      look_(look),
      style_{.text_size = std::clamp(std::min<double>(height, 0.75 * width) / 48, 9.0, 64.0),
             .celsius = look.celsius},
      margins_(view::color_bar_margins(look.scale, style_)),
      bar_width_(static_cast<int>(std::lround(1.3 * style_.text_size))),
      trails_(look.trail) {
  check_samples(look.samples());
  for (const int side : {width, height}) {
    if (side >= kSmallestSide && side <= kLargestSide) continue;
    io::refuse("a picture's sides must be " + limits(kSmallestSide, kLargestSide) +
               " pixels, not " + std::to_string(width) + "x" + std::to_string(height));
  }
  const int gap = static_cast<int>(style_.text_size);
  const int strip = margins_.left + bar_width_ + margins_.right + gap;
  // The legend steps aside where it would take more than half of the picture, or lose words.
  bar_ = bar && 2 * strip <= width && view::color_bar_room(look.scale, style_, text_) <= height;
  scene_width_ = bar_ ? width - strip : width;
}

void Picture::set_scale(const view::ColorScale& scale) {
  look_.scale = scale;
  shown_.reset();
}

view::ColorScale Picture::scale_for(const LitterView& litter) {
  const std::vector<double> values = look_.scale.field->values(litter);
  view::ColorScale scale = look_.scale.fitted(values, litter.params.preferred_temperature);
  if (shown_ && scale.follows(*shown_) && litter.time >= shown_at_) {
    scale = scale.eased(*shown_, view::easing(litter.time - shown_at_));
  }
  shown_ = scale;
  shown_at_ = litter.time;
  return scale;
}

void Picture::refuse_large() const {
  pictures::refuse_large(width_, height_);
}

io::Image Picture::draw(gl::Renderer& renderer, const LitterView& litter,
                        const view::Camera& camera) {
  const view::Drawing drawing{
      .draw = look_.draw, .quality = look_.quality, .rows = height_ * look_.samples()};
  list_.update(litter, scale_for(litter), camera, drawing);
  renderer.upload(list_);
  gl::Palette palette;
  palette.transparent = look_.transparent;
  io::Image picture(width_, height_);  // one: large pictures fill the memory
  renderer.draw(camera, picture, scene_width_, height_, look_.samples(), palette,
                refuse_interrupted);
  if (look_.transparent) unmultiply(picture);
  add_overlays(picture, litter, camera);
  if (bar_) add_legend(picture, litter.params.preferred_temperature);
  return picture;
}

void Picture::add_overlays(io::Image& picture, const LitterView& litter,
                           const view::Camera& camera) {
  marks_ = more_;
  if (look_.overlays.has("trails")) trails_.add(litter);
  look_.overlays.draw({litter, list_.scale(), centres_of(litter), trails_}, marks_);
  const view::Projection projection(camera, list_.bounds(), scene_width_, height_, list_.balls());
  const view::TextWidth width_of = [&](const view::TextLine& line, double size) {
    return text_.width(line, size);
  };
  const Annotated annotated{.litter = litter,
                            .camera = camera,
                            .projection = projection,
                            .width = static_cast<double>(scene_width_),
                            .height = static_cast<double>(height_),
                            .text_size = style_.text_size,
                            .ink = style_.ink,
                            .width_of = width_of};
  view::paint(picture, text_, annotations(marks_, height_ / view::kMarkRows, look_, annotated));
}

void Picture::add_legend(io::Image& picture, double tp) {
  const view::Box strip{scene_width_, 0, width_ - scene_width_, height_};
  if (look_.transparent) {
    view::fill(picture, strip, {}, 0);
  } else {
    view::fill(picture, strip, gl::Palette{}.background);
  }
  const int inset = height_ / 8;
  const view::Box bar{scene_width_ + margins_.left, inset, bar_width_, height_ - 2 * inset};
  view::draw_color_bar(picture, text_,
                       view::lay_out_color_bar(bar, margins_, list_.scale(), tp, style_),
                       style_.ink);
}

io::TextEntries Picture::look_entries() const {
  return pictures::look_entries(look_, list_.scale());
}

void check_samples(int supersample) {
  if (supersample >= 1 && supersample <= kMostSamples) return;
  io::refuse("the samples across a pixel must be " + limits(1, kMostSamples) + ", not " +
             std::to_string(supersample));
}

void refuse_large(int width, int height) {
  // A part is drawn at a time, which has color and depth, as have its samples; a pixel of the whole
  // passes through copies on its way to the file.
  constexpr double kOfDrawn = 16, kOfPixel = 24;
  const auto part = [](int side) { return std::min(side, gl::kLargestPart); };
  gl::Target::refuse_large(part(width), part(height));
  io::refuse_large(
      "a picture of " + std::to_string(width) + "x" + std::to_string(height) + " pixels",
      kOfDrawn * part(width) * part(height) + kOfPixel * static_cast<double>(width) * height,
      "fewer need less");
}

io::TextEntries look_entries(const Look& look, const view::ColorScale& scale) {
  io::TextEntries entries{{"color_by", std::string(scale.field->name)}};
  if (!scale.categorical()) {
    entries.emplace_back("colormap", scale.map_name);
    entries.emplace_back("scale", io::number_text(scale.min) + "," + io::number_text(scale.max));
  }
  entries.emplace_back("draw", view::name_of(look.draw));
  entries.emplace_back("quality", view::name_of(look.quality));
  entries.emplace_back("supersample", std::to_string(look.samples()));
  if (!look.overlays.empty()) {
    entries.emplace_back("overlay", look.overlays.names());
    entries.emplace_back("trail", io::number_text(look.trail));
  }
  if (look.caption) entries.emplace_back("caption", "true");
  if (look.celsius) entries.emplace_back("celsius", "true");
  if (look.transparent) entries.emplace_back("transparent", "true");
  if (look.dpi > 0) entries.emplace_back("dpi", std::to_string(look.dpi));
  return entries;
}

io::TextEntries camera_entries(const view::Camera& camera) {
  io::TextEntries entries{{"camera", camera.spec()}};
  if (camera.moved() || camera.targeted()) {
    const Eigen::Vector3d& target = camera.target();
    entries.emplace_back("camera_target", io::number_text(target.x()) + ',' +
                                              io::number_text(target.y()) + ',' +
                                              io::number_text(target.z()));
  }
  return entries;
}

io::PngOptions png_options(const Look& look) {
  return {.alpha = look.transparent, .dpi = look.dpi};
}

void unmultiply(io::Image& scene) {
  for (std::size_t i = 0; i < scene.rgba.size(); i += 4) {
    const int alpha = scene.rgba[i + 3];
    if (alpha == 0 || alpha == 255) continue;
    for (std::size_t c = i; c < i + 3; ++c) {
      scene.rgba[c] = static_cast<std::uint8_t>(std::min(255, scene.rgba[c] * 255 / alpha));
    }
  }
}

}  // namespace pupflow::pictures
