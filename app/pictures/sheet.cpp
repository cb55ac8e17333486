#include "app/pictures/sheet.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

#include "app/io/atomic_file.h"
#include "app/io/celsius.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/progress.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "app/pictures/annotations.h"
#include "app/pictures/picture.h"
#include "app/pictures/sheet_layout.h"
#include "app/view/canvas.h"
#include "app/view/color_bar.h"
#include "app/view/framing.h"
#include "app/view/mark_painter.h"
#include "app/view/text.h"
#include "pupflow/ensemble.h"

namespace pupflow::pictures {

namespace {

constexpr view::Rgb kPaper{255, 255, 255}, kInk{40, 40, 40};

/// A litter, and the parameters that it differs in from those of other panels.
struct Panel {
  Simulation litter;
  std::string name;  // for messages
  view::TextLine title;
};

/// What a caption tells.
PartSet caption_parts(const Look& look) {
  return look.caption ? PartSet{Part::exposure, Part::pairs} : PartSet();
}

const Parameter& parameter_of(const Axis& axis) {
  const Parameter* parameter = find_parameter(axis.parameter);
  if (parameter == nullptr) io::refuse("a sheet cannot vary " + io::quoted(axis.parameter));
  return *parameter;
}

/// As it is typed.
std::string axis_text(const Axis& axis) {
  const Parameter& parameter = parameter_of(axis);
  return axis.parameter + "=" + io::joined(axis.values, ",", [&](double value) {
           Params params;
           parameter.set(params, value);
           return format_value(parameter, params);
         });
}

/// What is written over a panel of one value of the axis.
view::TextLine title_of(const Parameter& parameter, const Params& params, bool celsius) {
  const bool real = parameter.kind == Parameter::Kind::real;
  const double value = parameter.get(params);
  const view::TextLine name = parameter.symbol.empty()
                                  ? view::TextLine{{std::string(parameter.name)}}
                                  : view::symbol(parameter.symbol);
  return name +
         (" = " + io::with_celsius(real ? view::tick_label(value) : format_value(parameter, params),
                                   value, celsius && io::is_temperature(parameter)));
}

/// The litters at their starts, the values of the first axis side by side.
std::vector<Panel> make_panels(const SheetJob& job) {
  std::vector<Panel> panels;
  const std::size_t count = panel_count(job);
  for (std::size_t i = 0; i < count; ++i) {
    Params params = job.params;
    std::string name;
    view::TextLine title;
    std::size_t rest = i;
    for (const Axis& axis : job.axes) {
      const Parameter& parameter = parameter_of(axis);
      parameter.set(params, axis.values[rest % axis.values.size()]);
      rest /= axis.values.size();
      if (!name.empty()) {
        name += ", ";
        title = title + ",  ";
      }
      name += std::string(parameter.name) + " = " + format_value(parameter, params);
      title = title + title_of(parameter, params, job.look.celsius);
    }
    panels.push_back(
        {observed_litter(params, job.look.parts() | caption_parts(job.look)), name, title});
  }
  return panels;
}

/// Throws Failure(interrupted) after Ctrl-C.
void refuse_interrupted_figure() {
  if (!io::interrupted()) return;
  throw io::Failure(io::ExitCode::interrupted, "interrupted; no figure was written");
}

/// Runs all litters to the end, side by side on the threads that were asked for. Throws
/// Failure(bad_numbers) when the numbers of a litter go wrong, and after Ctrl-C.
void run_all(std::vector<Panel>& panels, const SheetJob& job) {
  constexpr std::int64_t kAtOnce = 25;
  std::int64_t total = 0;
  for (const Panel& panel : panels) total += panel.litter.params().steps;
  io::Progress progress(job.verb, total, job.output.quiet);
  std::mutex mutex;  // for progress and done
  std::int64_t done = 0;
  for_each_index(static_cast<std::int64_t>(panels.size()), job.threads, [&](std::int64_t i) {
    Simulation& litter = panels[static_cast<std::size_t>(i)].litter;
    while (litter.steps_done() < litter.params().steps) {
      refuse_interrupted_figure();
      const std::int64_t steps = std::min(kAtOnce, litter.params().steps - litter.steps_done());
      const Status status = litter.run(steps);
      if (!status.ok()) {
        throw io::Failure(io::ExitCode::bad_numbers,
                          panels[static_cast<std::size_t>(i)].name + ": " + status.message());
      }
      const std::lock_guard lock(mutex);
      progress.update(done += steps);
    }
  });
}

/// The scale of each panel: the look's, fitted to its litter or to all.
std::vector<view::ColorScale> scales_of(const SheetJob& job, const std::vector<Panel>& panels) {
  const auto fitted = [&](std::span<const double> values, const Panel& panel) {
    return job.look.scale.fitted(values, panel.litter.params().preferred_temperature);
  };
  std::vector<view::ColorScale> scales;
  std::vector<double> all;
  for (const Panel& panel : panels) {
    const std::vector<double> values = job.look.scale.field->values(panel.litter);
    all.insert(all.end(), values.begin(), values.end());
    scales.push_back(fitted(values, panel));
  }
  if (!job.own_scales) scales.assign(panels.size(), fitted(all, panels.front()));
  return scales;
}

/// What a litter comes to, small, in the upper corners of its panel.
void add_caption(io::Image& scene, view::TextPainter& text, const LitterView& litter, double size,
                 bool celsius) {
  const auto mean = [](std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) /
           static_cast<double>(std::max<std::size_t>(values.size(), 1));
  };
  const std::vector<int> sizes = group_sizes(group_labels(litter.pups, litter.touching));
  const int largest = sizes.empty() ? 0 : std::ranges::max(sizes);
  const double small = 0.8 * size, margin = 0.6 * size, right = scene.width - margin;
  const auto line = [&](double x, int row, const view::TextLine& words, view::Align align) {
    text.draw(scene, x, margin + (0.8 + 1.3 * row) * small, words, small, kInk, align);
  };
  const double tb = mean(litter.tb);
  line(margin, 0,
       view::symbol("T", "b") + (" " + io::with_celsius(io::formatted("%.3f", tb), tb, celsius)),
       view::Align::left);
  line(margin, 1, {{io::formatted("1 − A %.2f", 1 - mean(litter.exposed))}}, view::Align::left);
  line(right, 0, {{"groups " + std::to_string(sizes.size())}}, view::Align::right);
  line(right, 1, {{"largest " + std::to_string(largest)}}, view::Align::right);
}

/// The overlays over a litter.
view::Marks marks_of(const SheetJob& job, const LitterView& litter, const view::ColorScale& scale) {
  view::Marks marks;
  job.look.overlays.draw({litter, scale, centres_of(litter), view::Trails()}, marks);
  return marks;
}

/// One litter, without its title.
io::Image draw_panel(const SheetJob& job, const Simulation& simulation,
                     const view::ColorScale& scale, const view::Box& box, gl::Renderer& renderer,
                     view::TextPainter& text, double size) {
  const LitterView litter = simulation.view();
  const view::Camera camera = view::framed(job.camera, litter.params, 1);
  view::DrawList list;
  list.update(litter, scale, camera,
              {.draw = job.look.draw,
               .quality = job.look.quality,
               .rows = box.height * job.look.samples()});
  renderer.upload(list);
  gl::Palette palette;
  palette.transparent = job.look.transparent;
  io::Image scene = renderer.picture(camera, box.width, box.height, job.look.samples(), palette,
                                     refuse_interrupted_figure);
  if (job.look.transparent) unmultiply(scene);
  const view::Marks marks = marks_of(job, litter, scale);
  const view::Projection projection(camera, list.bounds(), scene.width, scene.height, list.balls());
  std::vector<view::Flat> flats;
  view::flatten(marks, projection, scene.height / view::kMarkRows, flats);
  add_scale_bar(flats, scene.width, scene.height, camera, size, kInk);
  view::paint(scene, text, flats);
  if (job.look.caption && box.height >= kLeastForWords) {
    add_caption(scene, text, litter, size, job.look.celsius);
  }
  return scene;
}

io::Image compose(const SheetJob& job, const SheetLayout& layout, const std::vector<Panel>& panels,
                  const std::vector<view::ColorScale>& scales,
                  const std::vector<view::LegendEntry>& legend, gl::Renderer& renderer,
                  view::TextPainter& text) {
  io::Image sheet(layout.width(), layout.height());
  if (!job.look.transparent) view::fill(sheet, {0, 0, sheet.width, sheet.height}, kPaper);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    refuse_interrupted_figure();
    const Panel& panel = panels[i];
    const view::Box box = layout.panel_box(static_cast<int>(i));
    view::blit(sheet,
               draw_panel(job, panel.litter, scales[i], box, renderer, text, layout.legend_text()),
               box.x, box.y);
    const double fitting = box.width / text.width(panel.title, layout.text());
    text.draw(sheet, box.x + box.width / 2.0, box.y - 0.45 * layout.text(), panel.title,
              layout.text() * std::min(1.0, fitting), kInk, view::Align::centre);
    if (!job.bar || (i > 0 && !job.own_scales)) continue;
    view::draw_color_bar(sheet, text,
                         view::lay_out_color_bar(
                             layout.bar_box(static_cast<int>(i)), layout.bar_margins(), scales[i],
                             panel.litter.params().preferred_temperature, layout.bar_style()),
                         kInk);
  }
  std::vector<view::Flat> flats;
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const Eigen::Vector2d& at = layout.legend()[i];
    view::flatten_legend({legend[i]}, at.x(), at.y(), layout.legend_text(), flats);
  }
  view::paint(sheet, text, flats);
  return sheet;
}

void check_job(const SheetJob& job) {
  check_samples(job.look.samples());
  if (job.look.overlays.has("trails"))
    io::refuse("--overlay trails: " + job.verb + " has no trails");
  if (job.axes.empty() || job.axes.size() > 2) io::refuse("a sheet varies one or two parameters");
  const std::size_t count = panel_count(job);
  if (count < 1 || count > kMostPanels) {
    io::refuse(std::to_string(count) + " panels do not fit a sheet; it has 1 to " +
               std::to_string(kMostPanels));
  }
  if (job.panel < kSmallestPanel || job.panel > kLargestPanel) {
    io::refuse("a panel's edge must be " + std::to_string(kSmallestPanel) + " ... " +
               std::to_string(kLargestPanel) + " pixels, not " + std::to_string(job.panel));
  }
}

void check_size(const SheetLayout& layout) {
  if (std::max(layout.width(), layout.height()) > kLargestSide) {
    io::refuse("a sheet of " + std::to_string(layout.width()) + "x" +
               std::to_string(layout.height()) + " pixels is too large; a side may have " +
               std::to_string(kLargestSide) + ": take a smaller --panel or fewer of them");
  }
  refuse_large(layout.width(), layout.height());
}

/// What the file says of itself, beside what `job.entries` says.
io::TextEntries sheet_entries(const SheetJob& job, const std::vector<Panel>& panels,
                              const view::ColorScale& scale) {
  io::TextEntries entries = job.entries;
  entries.emplace_back("grid", io::joined(job.axes, " ", axis_text));
  entries.emplace_back("panel", std::to_string(job.panel));
  entries.emplace_back("bar", job.bar ? "true" : "false");
  const io::TextEntries seen = camera_entries(job.camera);
  entries.insert(entries.end(), seen.begin(), seen.end());
  entries.emplace_back("hash", io::joined(panels, ",", [](const Panel& panel) {
                         return io::hash_text(panel.litter.hash());
                       }));
  io::TextEntries look = look_entries(job.look, scale);
  if (job.own_scales) {
    for (auto& [name, value] : look) {
      if (name == "scale") value = view::name_of(scale.ends);
    }
  }
  entries.insert(entries.end(), look.begin(), look.end());
  return entries;
}

}  // namespace

void sheet(const SheetJob& job) {
  check_job(job);
  io::refuse_existing(job.output.path, job.output.force);
  std::vector<Panel> panels = make_panels(job);
  const Simulation& first = panels.front().litter;
  const std::vector<view::LegendEntry> legend =
      marks_of(job, first.view(), job.look.scale.fitted({})).legend;
  view::TextPainter text;
  const SheetLayout layout(job, legend, text);
  const Headless headless(job.look);
  check_size(layout);
  run_all(panels, job);
  const std::vector<view::ColorScale> scales = scales_of(job, panels);
  io::write_png(job.output.path,
                compose(job, layout, panels, scales, legend, *headless.renderer, text),
                io::provenance(job.params, sheet_entries(job, panels, scales.front())),
                job.output.force, png_options(job.look));
}

}  // namespace pupflow::pictures
