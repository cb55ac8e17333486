// The section of the error report about the parts that scenes leave out.
#include <limits>

#include "app/io/scene_file.h"
#include "app/report/report.h"
#include "app/report/savings/savings.h"

namespace pupflow::report {
namespace {

constexpr const char* kScenes[] = {"paper", "single", "rigid", "no_heat", "no_steering"};

io::Scene shipped(const std::string& name) {
  std::vector<std::string> problems;
  return io::load_scene(name, problems);
}

void add_rows(io::CsvFile& csv, const std::string& scene, const Savings& savings) {
  const auto add = [&](const PartCost& part, double saved) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    csv.cell(scene).cell(part.name).cell(std::int64_t{part.needed}).cell(part.planned);
    csv.cell(part.needed ? nan : part.forced).cell(part.needed ? nan : saved);
    csv.cell(agreement_words(part.agreement)).end_row();
  };
  for (const PartCost& part : savings.parts) add(part, part.forced - part.planned);
  add({"whole step", false, false, "", savings.planned_step, savings.full_step, savings.agreement},
      savings.saved);
}

}  // namespace

void savings_section(Report& report) {
  report.heading("Parts of a step that a scene leaves out");
  report.text(
      "Before a run the program determines which parts of a step can change its result and leaves "
      "out the others. Here each scene runs as planned and, in turn, with each left-out part "
      "forced in. Times are microseconds per step on one thread. `pupflow explain SCENE --measure` "
      "makes such a table for any scene.");
  io::CsvFile csv = report.csv("savings", Params{},
                               "scene,part,needed,planned_us,forced_us,saved_us,the_same_bits");
  MeasuredSteps steps;
  steps.count = report.options().quick ? 50 : 500;
  steps.quiet = true;
  for (const char* name : kScenes) {
    stop_if_interrupted();
    const io::Scene scene = shipped(name);
    const Savings savings = measure_savings(scene.params, steps);
    report.subheading(scene.title + " (`" + name + "`)");
    report.text(scene.description);
    report.table(savings_rows(savings));
    for (const std::string& note : savings_notes(savings)) report.text(note);
    require_same_bits(savings);
    add_rows(csv, name, savings);
  }
  csv.commit();
}

}  // namespace pupflow::report
