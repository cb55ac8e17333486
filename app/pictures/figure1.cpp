#include "app/pictures/figure1.h"

#include "app/io/failure.h"
#include "app/io/text.h"
#include "app/pictures/sheet.h"

namespace pupflow::pictures {

void figure1(const Figure1Job& job) {
  if (job.ta.empty()) io::refuse("figure1 needs a temperature");
  SheetJob sheet_job;
  sheet_job.params = job.params;
  sheet_job.axes = {{"ta", job.ta}};
  sheet_job.panel = job.panel;
  sheet_job.camera = view::Camera::parse("top");
  sheet_job.threads = job.threads;
  sheet_job.look = job.look;
  const view::Ends ends = job.look.scale.ends;
  sheet_job.own_scales = ends == view::Ends::automatic || ends == view::Ends::around_tp;
  sheet_job.output = job.output;
  sheet_job.verb = "figure1";
  sheet_job.entries = {{"picture", "figure1"},
                       {"panels_ta", io::joined(job.ta, ",", io::number_text)}};
  sheet(sheet_job);
}

}  // namespace pupflow::pictures
