#include "app/report/error.h"

#include "app/report/error_litter.h"
#include "app/report/error_scenes.h"
#include "app/report/savings.h"

namespace pupflow::report {

void report_error(const Options& options) {
  Report report(options, "Error against run time");
  for (const auto& make :
       {fall_scene, spin_scene, squeeze_scene, press_scene, cooling_scene, steering_scene}) {
    const Scene scene = make(options.quick);
    show(report, scene, measure(scene, options));
  }
  litter_section(report);
  divergence_section(report);
  savings_section(report);
  report.finish();
}

}  // namespace pupflow::report
