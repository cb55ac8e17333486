#include "app/pictures/figure1.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/progress.h"
#include "app/io/provenance.h"
#include "app/io/text.h"
#include "app/pictures/picture.h"
#include "app/view/canvas.h"
#include "app/view/color_bar.h"
#include "app/view/framing.h"
#include "app/view/mark_painter.h"
#include "app/view/text.h"
#include "pupflow/ensemble.h"

namespace pupflow::pictures {

namespace {

constexpr view::Rgb kPaper{255, 255, 255}, kInk{40, 40, 40};

/// What a caption tells.
PartSet caption_parts(const Look& look) {
  return look.caption ? PartSet{Part::exposure, Part::pairs} : PartSet();
}

std::vector<Simulation> litters(const Figure1Job& job) {
  if (job.ta.empty()) throw io::Failure(io::ExitCode::bad_input, "figure1 needs a temperature");
  std::vector<Simulation> list;
  for (const double ta : job.ta) {
    Params params = job.params;
    params.ambient_temperature = ta;
    list.push_back(observed_litter(params, job.look.parts() | caption_parts(job.look)));
  }
  return list;
}

/// Runs all litters to the end, side by side on the threads that were asked for. Throws
/// Failure(bad_numbers) when the numbers of a litter go wrong, and after Ctrl-C.
void run_all(std::vector<Simulation>& litters, const Figure1Job& job) {
  constexpr std::int64_t kAtOnce = 25;
  const auto count = static_cast<std::int64_t>(litters.size());
  io::Progress progress("figure1", job.params.steps * count, job.output.quiet);
  std::mutex mutex;  // for progress and done
  std::int64_t done = 0;
  for_each_index(count, job.threads, [&](std::int64_t i) {
    Simulation& litter = litters[static_cast<std::size_t>(i)];
    while (litter.steps_done() < job.params.steps) {
      if (io::interrupted()) {
        throw io::Failure(io::ExitCode::interrupted, "interrupted; no figure was written");
      }
      const std::int64_t steps = std::min(kAtOnce, job.params.steps - litter.steps_done());
      const Status status = litter.run(steps);
      if (!status.ok()) {
        throw io::Failure(io::ExitCode::bad_numbers,
                          "ta = " + io::number_text(litter.params().ambient_temperature) + ": " +
                              status.message());
      }
      const std::lock_guard lock(mutex);
      progress.update(done += steps);
    }
  });
}

/// Where everything goes, in pixels.
struct Layout {
  int panel, margin, title, columns, rows;
  double text;
  view::ColorBarStyle bar_style;
  view::ColorBarMargins bar_margins;

  Layout(int edge, int panels, const view::ColorScale& scale) : panel(edge) {
    constexpr int kPanelsAcross = 4;
    rows = (panels + kPanelsAcross - 1) / kPanelsAcross;
    columns = (panels + rows - 1) / rows;
    text = std::max(9.0, edge / 18.0);
    margin = static_cast<int>(std::lround(0.8 * text));
    title = static_cast<int>(std::lround(1.7 * text));
    bar_style.text_size = 0.72 * text;
    bar_style.ink = kInk;
    bar_margins = view::color_bar_margins(scale, bar_style);
  }

  int cell_width() const { return panel + margin; }
  int cell_height() const { return title + panel + margin; }
  view::Box panel_box(int i) const {
    return {margin + i % columns * cell_width(), margin + i / columns * cell_height() + title,
            panel, panel};
  }
  int bar_width() const { return static_cast<int>(std::lround(text)); }
  view::Box bar_box() const {
    const int inset = panel / 12;
    return {margin + columns * cell_width() + bar_margins.left, margin + title + inset, bar_width(),
            (rows - 1) * cell_height() + panel - 2 * inset};
  }
  int width() const {
    const view::Box bar = bar_box();
    return bar.x + bar.width + bar_margins.right + margin;
  }
  int height() const { return margin + rows * cell_height(); }
};

/// The look's scale, fitted to all litters.
view::ColorScale common_scale(const Look& look, const std::vector<Simulation>& litters) {
  std::vector<double> all;
  for (const Simulation& litter : litters) {
    const std::vector<double> values = look.scale.field->values(litter);
    all.insert(all.end(), values.begin(), values.end());
  }
  return look.scale.fitted(all, litters.front().params().preferred_temperature);
}

/// What a litter comes to, small, in the upper corners of its panel.
void add_caption(io::Image& scene, view::TextPainter& text, const LitterView& litter, double size) {
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
  line(margin, 0, view::symbol("T", "b") + io::formatted(" %.3f", mean(litter.tb)),
       view::Align::left);
  line(margin, 1, {{io::formatted("1 − A %.2f", 1 - mean(litter.exposed))}}, view::Align::left);
  line(right, 0, {{"groups " + std::to_string(sizes.size())}}, view::Align::right);
  line(right, 1, {{"largest " + std::to_string(largest)}}, view::Align::right);
}

/// One litter, from above.
io::Image panel(const Figure1Job& job, const Simulation& simulation, const view::ColorScale& scale,
                const view::Box& box, gl::Renderer& renderer, view::TextPainter& text,
                double size) {
  const LitterView litter = simulation.view();
  const view::Camera camera = view::framed(view::Camera::parse("top"), litter.params, 1);
  view::DrawList list;
  list.update(litter, scale, camera,
              {.draw = job.look.draw,
               .quality = job.look.quality,
               .rows = box.height * job.look.samples()});
  renderer.upload(list);
  gl::Palette palette;
  palette.transparent = job.look.transparent;
  io::Image scene = renderer.picture(camera, box.width, box.height, job.look.samples(), palette);
  if (job.look.transparent) unmultiply(scene);
  view::Marks marks;
  job.look.overlays.draw({litter, scale, centres_of(litter), view::Trails()}, marks);
  const view::Projection projection(camera, list.bounds(), scene.width, scene.height, list.balls());
  view::paint_marks(scene, text, marks, projection);
  paint_scale_bar(scene, text, camera, size, kInk);
  if (job.look.caption) add_caption(scene, text, litter, size);
  return scene;
}

io::Image compose(const Figure1Job& job, const std::vector<Simulation>& litters,
                  const view::ColorScale& scale, gl::Renderer& renderer) {
  const Layout layout(job.panel, static_cast<int>(litters.size()), job.look.scale);
  io::Image figure(layout.width(), layout.height());
  if (!job.look.transparent) view::fill(figure, {0, 0, figure.width, figure.height}, kPaper);
  view::TextPainter text;
  for (std::size_t i = 0; i < litters.size(); ++i) {
    const view::Box box = layout.panel_box(static_cast<int>(i));
    view::blit(figure,
               panel(job, litters[i], scale, box, renderer, text, layout.bar_style.text_size),
               box.x, box.y);
    text.draw(figure, box.x + box.width / 2.0, box.y - 0.45 * layout.text,
              view::symbol("T", "a") +
                  (" = " + view::tick_label(litters[i].params().ambient_temperature)),
              layout.text, kInk, view::Align::centre);
  }
  view::draw_color_bar(figure, text,
                       view::lay_out_color_bar(layout.bar_box(), layout.bar_margins, scale,
                                               job.params.preferred_temperature, layout.bar_style),
                       kInk);
  return figure;
}

}  // namespace

void figure1(const Figure1Job& job) {
  check_samples(job.look.samples());
  if (job.look.overlays.has("trails")) io::refuse("--overlay trails: figure1 has no trails");
  if (job.panel < kSmallestPanel || job.panel > kLargestPanel) {
    throw io::Failure(io::ExitCode::bad_input, "a panel's edge must be " +
                                                   std::to_string(kSmallestPanel) + " ... " +
                                                   std::to_string(kLargestPanel) + " pixels, not " +
                                                   std::to_string(job.panel));
  }
  io::refuse_existing(job.output.path, job.output.force);
  std::vector<Simulation> list = litters(job);
  const Headless headless(job.look);
  const Layout layout(job.panel, static_cast<int>(list.size()), job.look.scale);
  refuse_large(layout.width(), layout.height(), job.panel, job.panel);
  run_all(list, job);

  std::string panels;
  for (const double ta : job.ta) panels += (panels.empty() ? "" : ",") + io::number_text(ta);
  const view::ColorScale scale = common_scale(job.look, list);
  const std::string hashes =
      io::joined(list, ",", [](const Simulation& litter) { return io::hash_text(litter.hash()); });
  io::TextEntries extra = look_entries(job.look, scale);
  extra.insert(extra.begin(), {{"picture", "figure1"}, {"panels_ta", panels}, {"hash", hashes}});
  io::write_png(job.output.path, compose(job, list, scale, *headless.renderer),
                io::provenance(job.params, extra), job.output.force, png_options(job.look));
}

}  // namespace pupflow::pictures
