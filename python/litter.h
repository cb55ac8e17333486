// A litter as Python holds it: a simulation, who observes it, and the arrays that show it.
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "pupflow/observer.h"
#include "pupflow/simulation.h"
#include "python/image.h"

namespace pupflow::python {

namespace py = pybind11;

/// All members are called with the GIL. They refuse with RuntimeError while another thread steps or
/// draws the litter.
class Litter : public std::enable_shared_from_this<Litter> {
 public:
  explicit Litter(Simulation simulation);
  Litter(const Litter&) = delete;
  Litter& operator=(const Litter&) = delete;

  std::shared_ptr<Litter> copy();

  const Simulation& simulation() const;

  /// Steps without the GIL. Throws BadNumbers, also when an earlier step did, and what a signal's
  /// handler throws, such as KeyboardInterrupt.
  void step(std::int64_t count);

  int threads() const { return threads_; }
  void set_threads(int threads);

  /// Sets a parameter for the steps to come. Throws AttributeError for one that defines the litter,
  /// TypeError and ValueError as python/values.h says.
  void set(const Parameter& parameter, py::handle value);

  /// Whether the last step recorded what the field shows, or it can be found out now.
  bool knows(const LitterField& field);

  /// Has the steps to come record what the field shows, beside all that they record anyway.
  void record(const LitterField& field);

  /// A read-only array, (pups,) or (pups, points), of numbers worked out once per step. Throws
  /// RuntimeError unless the field is known.
  py::array values(const LitterField& field);

  /// Read-only arrays (pups, points, 3) of float32 or float64, as the litter's precision is.
  py::array positions();
  py::array velocities();

  /// What is done to each pup in the steps to come: writable arrays (pups, 3), (pups,) and (pups,),
  /// which a step reads when it is called. A turn that is NaN is the pup's own.
  py::array force() const;
  py::array heat() const;
  py::array turn() const;

  /// The simulation with these actions. Throws ValueError where one is infinite.
  const Simulation& acted();

  /// The observables of the state as it is. Those that compare with an earlier state are NaN before
  /// the first step.
  Observables observe();

  /// A picture, as draw() gives it, made without the GIL.
  py::array image(const Look& look);

 private:
  class Busy;

  using Numbers = std::shared_ptr<std::vector<double>>;
  using Floats = std::shared_ptr<std::vector<float>>;

  void show_actions();  // of the simulation, in the arrays
  void require_known(const LitterField& field);
  py::array vectors(std::string_view name, PointVectors LitterView::*member);
  void run(std::int64_t count);

  Simulation simulation_;
  PartSet observed_;
  Observer observer_;
  bool unseen_ = false;              // the observer has not been told of the last step
  std::optional<Observables> seen_;  // after the last step
  Numbers force_, heat_, turn_;
  int threads_ = 1;
  bool busy_ = false;  // guarded by the GIL

  // What arrays show, by name, until the next step. No object of Python: letting go of one may run
  // code of Python that uses this litter.
  std::map<std::string_view, std::variant<Numbers, Floats>> shown_;
};

}  // namespace pupflow::python
