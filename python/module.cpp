// The Python module pupflow._core, which the package pupflow shows. Attributes and their docstrings
// are made from the tables.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "app/io/scene_file.h"
#include "pupflow/ensemble.h"
#include "pupflow/version.h"
#include "python/docstrings.h"
#include "python/errors.h"
#include "python/gil.h"
#include "python/litter_class.h"
#include "python/tables.h"
#include "python/values.h"

namespace pupflow::python {
namespace {

/// run_to_end without the GIL.
RunResult run_watched(const Params& params) {
  WithoutGil others_may_run;
  return *run_to_end(params, [&] {
    others_may_run.look();
    return false;
  });
}

py::dict run(const py::object& scene, const py::kwargs& parameters) {
  const RunResult result = run_watched(params_of(scene, parameters));
  require_fine(result.status);
  constexpr int kCaller = 2;  // of the function of Python that calls this one
  for (const Warning& warning : result.warnings.all()) {
    if (PyErr_WarnEx(PyExc_RuntimeWarning, warning.message().c_str(), kCaller) != 0)
      throw py::error_already_set();
  }
  py::dict means = dict_of(result.means);
  means[text(run_statistics()[kExposedSd].name)] = result.exposed_sd;
  return means;
}

py::dict scenes() {
  py::dict titles;
  for (const io::ShippedScene& scene : io::shipped_scenes()) {
    std::vector<std::string> problems;
    titles[text(scene.name)] = io::parse_scene(scene.text, std::string(scene.name), problems).title;
  }
  return titles;
}

}  // namespace
}  // namespace pupflow::python

PYBIND11_MODULE(_core, module) {
  using namespace pupflow::python;
  py::options options;
  options.disable_function_signatures();
  module.attr("__version__") = std::string(pupflow::version_text());
  add_errors(module);
  add_litter(module);
  add_tables(module);
  module.def("run", run, py::arg("scene") = py::none(), kRunDoc);
  module.def("scenes", scenes, kScenesDoc);
}
