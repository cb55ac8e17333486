#include "python/litter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "app/io/failure.h"
#include "app/io/named_field.h"
#include "app/io/text.h"
#include "python/arrays.h"
#include "python/errors.h"
#include "python/gil.h"
#include "python/values.h"

namespace pupflow::python {
namespace {

/// A turn that the pup chooses.
constexpr double kItsOwn = std::numeric_limits<double>::quiet_NaN();

/// What every step records. Strain costs time, the others next to nothing.
constexpr PartSet kRecorded = kContactRecords | PartSet{Part::sides};

Simulation observed(Simulation simulation) {
  simulation.set_observed(kRecorded);
  return simulation;
}

template <class Real>
std::shared_ptr<std::vector<Real>> copy_of(const PointVectors& vectors) {
  const auto count = static_cast<std::size_t>(vectors.pups()) * vectors.points() * 3;
  auto numbers = std::make_shared<std::vector<Real>>(count);
  vectors.copy_to(std::span<Real>(*numbers));
  return numbers;
}

/// `numbers` is a copy: code of Python that runs here may change what it was copied from.
template <class Shown>
py::array array_of(const Shown numbers, const Shape& shape) {
  return std::visit([&](const auto& memory) { return read_only_array(memory, shape); }, numbers);
}

}  // namespace

/// Marks the litter as being worked on without the GIL.
class Litter::Busy {
 public:
  explicit Busy(Litter& litter) : litter_(litter) { litter_.busy_ = true; }
  ~Busy() { litter_.busy_ = false; }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  Litter& litter_;
};

Litter::Litter(Simulation simulation)
    : simulation_(observed(std::move(simulation))), observed_(kRecorded), observer_(simulation_) {
  show_actions();
}

std::shared_ptr<Litter> Litter::copy() {
  auto other = std::make_shared<Litter>(acted());
  other->observed_ = observed_;
  other->simulation_.set_observed(observed_);
  other->observer_ = observer_;
  other->unseen_ = unseen_;
  other->seen_ = seen_;
  other->set_threads(threads_);
  return other;
}

const Simulation& Litter::simulation() const {
  if (!busy_) return simulation_;
  throw std::runtime_error(
      "another call steps or draws this litter; make a copy() for each thread");
}

void Litter::step(std::int64_t count) {
  if (count < 0)
    throw py::value_error("step(" + std::to_string(count) + "): must be 0 or more steps");
  acted();
  shown_.clear();
  const Busy busy(*this);
  run(count);
  require_fine(simulation_.status());
}

void Litter::run(std::int64_t count) {
  WithoutGil others_may_run;
  for (std::int64_t i = 0; i < count; ++i) {
    if (i > 0) others_may_run.look();
    if (unseen_) observer_.pass(simulation_);
    seen_.reset();
    unseen_ = simulation_.step().ok();
    if (!unseen_) return;
  }
}

void Litter::set_threads(int threads) {
  simulation();
  simulation_.set_threads(threads);
  threads_ = threads;
}

void Litter::set(const Parameter& parameter, py::handle value) {
  std::vector<std::string> problems;
  Params wanted;  // code of Python that a value runs may step this litter meanwhile
  take_value(parameter, value, wanted, problems);
  Params params = simulation().params();
  if (problems.empty()) parameter.set(params, parameter.get(wanted));
  if (needs_restart(simulation_.params(), params)) {
    const std::string name(parameter.name);
    throw py::attribute_error(
        name + " defines the litter and cannot change; make a new one: Litter(" + name + "=...)");
  }
  for (const Problem& problem : check(params)) problems.push_back(problem.message);
  io::refuse_all(problems);
  const bool other_lag = params.flow_lag != simulation_.params().flow_lag;
  simulation_.set_params(params);
  if (other_lag) {
    observer_ = Observer(simulation_);
    unseen_ = false;
    seen_.reset();
  }
  shown_.clear();
}

bool Litter::knows(const LitterField& field) {
  if (is_known(field, simulation().view())) return true;
  // Some things are recorded as soon as they are observed.
  simulation_.set_observed(observed_ | field.parts);
  simulation_.set_observed(observed_);
  return is_known(field, simulation_.view());
}

void Litter::require_known(const LitterField& field) {
  if (knows(field)) return;
  const std::string name(field.name);
  throw std::runtime_error("the last step did not record " + name + "; call record('" + name +
                           "') before the step");
}

void Litter::record(const LitterField& field) {
  simulation();
  observed_ = observed_ | field.parts;
  simulation_.set_observed(observed_);
  shown_.clear();
}

py::array Litter::values(const LitterField& field) {
  require_known(field);
  const LitterView litter = simulation().view();
  if (!shown_.contains(field.name))
    shown_[field.name] = std::make_shared<std::vector<double>>(field.values(litter));
  Shape shape{litter.pups};
  if (field.of_afferents) shape.push_back(litter.points);
  return array_of(shown_[field.name], shape);
}

py::array Litter::positions() {
  return vectors("position", &LitterView::positions);
}

py::array Litter::velocities() {
  return vectors("velocity", &LitterView::velocities);
}

py::array Litter::vectors(std::string_view name, PointVectors LitterView::*member) {
  const LitterView litter = simulation().view();
  const PointVectors& vectors = litter.*member;
  if (!shown_.contains(name)) {
    if (litter.params.precision == Precision::float_) {
      shown_[name] = copy_of<float>(vectors);
    } else {
      shown_[name] = copy_of<double>(vectors);
    }
  }
  return array_of(shown_[name], {litter.pups, litter.points, 3});
}

py::array Litter::force() const {
  return array_over(force_, {simulation_.pups(), 3});
}
py::array Litter::heat() const {
  return array_over(heat_, {simulation_.pups()});
}
py::array Litter::turn() const {
  return array_over(turn_, {simulation_.pups()});
}

void Litter::show_actions() {
  force_ = std::make_shared<std::vector<double>>();
  heat_ = std::make_shared<std::vector<double>>();
  turn_ = std::make_shared<std::vector<double>>();
  for (int pup = 0; pup < simulation_.pups(); ++pup) {
    const Action action = simulation_.action(pup);
    force_->insert(force_->end(), action.force.begin(), action.force.end());
    heat_->push_back(action.heat);
    turn_->push_back(action.turn.value_or(kItsOwn));
  }
}

const Simulation& Litter::acted() {
  simulation();
  for (int pup = 0; pup < simulation_.pups(); ++pup) {
    Action action;
    std::copy_n(force_->begin() + 3 * pup, 3, action.force.begin());
    action.heat = (*heat_)[pup];
    if (!std::isnan((*turn_)[pup])) action.turn = (*turn_)[pup];
    if (action != simulation_.action(pup)) simulation_.set_action(pup, action);
  }
  return simulation_;
}

Observables Litter::observe() {
  require_fine(simulation().status());
  if (!seen_ && unseen_) seen_ = observer_.observe(simulation_);
  if (!seen_) {
    seen_ = Observer(simulation_).observe(simulation_);
    seen_->flow = seen_->membership_flow = std::numeric_limits<double>::quiet_NaN();
  }
  unseen_ = false;
  return *seen_;
}

py::array Litter::image(const Look& look) {
  require_known(io::named_field(look.color_by, "color_by"));
  const LitterView litter = simulation().view();
  const Busy busy(*this);
  return draw(litter, look);
}

}  // namespace pupflow::python
