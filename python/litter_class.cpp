#include "python/litter_class.h"

#include <pybind11/stl.h>

#include <cinttypes>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <system_error>
#include <vector>

#include "app/io/atomic_file.h"
#include "app/io/checkpoint.h"
#include "app/io/failure.h"
#include "app/io/named_field.h"
#include "app/io/text.h"
#include "app/view/camera.h"
#include "python/arrays.h"
#include "python/docstrings.h"
#include "python/errors.h"
#include "python/finished.h"
#include "python/image.h"
#include "python/litter.h"
#include "python/values.h"
#include "python/words.h"

namespace pupflow::python {

/// A group of attributes of one litter, one for each row of a table.
template <auto Table>
struct Group {
  std::shared_ptr<Litter> litter;
};

}  // namespace pupflow::python

namespace pybind11::detail {

template <>
class type_caster<pupflow::python::Litter>
    : public pupflow::python::FinishedCaster<pupflow::python::Litter> {};
template <auto Table>
class type_caster<pupflow::python::Group<Table>>
    : public pupflow::python::FinishedCaster<pupflow::python::Group<Table>> {};

}  // namespace pybind11::detail

namespace pupflow::python {
namespace {

using LitterType = py::class_<Litter, std::shared_ptr<Litter>>;

Litter& litter_of(Litter& litter) {
  return litter;
}
template <auto Table>
Litter& litter_of(Group<Table>& group) {
  return *group.litter;
}

/// Adds the parameter, or the field, as an attribute with its docstring.
template <class Owner, class... Options>
void add_attribute(py::class_<Owner, Options...>& type, const Parameter& parameter) {
  type.def_property(
      std::string(parameter.name).c_str(),
      [&parameter](Owner& owner) {
        return value_of(parameter, litter_of(owner).simulation().params());
      },
      [&parameter](Owner& owner, const py::object& value) {
        litter_of(owner).set(parameter, value);
      },
      words(parameter).c_str());
}
template <class Owner, class... Options>
void add_attribute(py::class_<Owner, Options...>& type, const LitterField& field) {
  type.def_property_readonly(
      std::string(field.name).c_str(),
      [&field](Owner& owner) { return litter_of(owner).values(field); },
      words(field, field.of_afferents ? "(pups, points)" : "(pups,)").c_str());
}

bool knows(Litter&, const Parameter&) {
  return true;
}
bool knows(Litter& litter, const LitterField& field) {
  return litter.knows(field);
}

template <auto Table>
py::list names_of(const Group<Table>& group) {
  py::list names;
  for (const auto& row : Table()) {
    if (knows(*group.litter, row)) names.append(text(row.name));
  }
  return names;
}

/// What all classes have in common. `instead` follows "cannot pickle 'Class'".
void finish(const py::object& type, const std::string& instead) {
  refuse_unknown_attributes(type);
  const auto refuse_pickle = [instead](const py::object& self) {
    const py::object name = py::type::of(self).attr("__name__");
    throw py::type_error("cannot pickle '" + name.cast<std::string>() + "'" + instead);
  };
  type.attr("__reduce__") = py::cpp_function(refuse_pickle, py::is_method(type));
  type.attr("__module__") = "pupflow";
}

/// Makes the class a Mapping, which has keys, __iter__, __len__ and __getitem__.
void make_mapping(const py::object& type) {
  const py::object mapping = py::module_::import("collections.abc").attr("Mapping");
  for (const char* const name : {"items", "values", "get", "__contains__"})
    type.attr(name) = mapping.attr(name);
  mapping.attr("register")(type);
}

/// Adds the class of a group, which is a mapping, too, and the attribute of Litter that gives it.
template <auto Table>
void add_group(py::module_& module, LitterType& litter, const char* class_name, const char* name,
               const char* doc) {
  using Owner = Group<Table>;
  py::class_<Owner> type(module, class_name, doc);
  for (const auto& row : Table()) add_attribute(type, row);
  type.def("keys", names_of<Table>, "The names of what is known.");
  type.def("__iter__", [](const Owner& self) { return names_of(self).attr("__iter__")(); });
  type.def("__len__", [](const Owner& self) { return names_of(self).size(); });
  type.def("__getitem__", [](const py::object& self, const py::object& key) {
    if (names_of(self.cast<const Owner&>()).contains(key)) return py::getattr(self, key);
    PyErr_SetObject(PyExc_KeyError, key.ptr());
    throw py::error_already_set();
  });
  make_mapping(type);
  finish(type, "; dict() of it can be");
  litter.def_property_readonly(
      name, [](Litter& self) { return Owner{self.shared_from_this()}; }, doc);
}

std::string hash_text(Litter& litter) {
  return io::formatted("%016" PRIx64, litter.acted().hash());
}

std::string repr(const Litter& litter) {
  const Simulation& simulation = litter.simulation();
  return io::formatted("<pupflow.Litter: %d pups of %d points, T_a %s, seed %lld, step %lld>",
                       simulation.pups(), simulation.points(),
                       io::number_text(simulation.params().ambient_temperature).c_str(),
                       static_cast<long long>(simulation.params().seed),
                       static_cast<long long>(simulation.steps_done()));
}

std::vector<std::string> warnings_of(const Litter& litter) {
  std::vector<std::string> messages;
  for (const Warning& warning : litter.simulation().warnings())
    messages.push_back(warning.message());
  return messages;
}

void save(Litter& litter, const py::object& path, bool force) {
  const std::string file = path_text(path);
  require_fine(litter.simulation().status());
  std::error_code unknown;  // write_checkpoint says what is wrong with the path
  if (!force && !io::is_stream(file) && std::filesystem::exists(file, unknown)) {
    const std::string message =
        io::printable(file) + ": exists already; use force=True to replace it";
    PyErr_SetString(PyExc_FileExistsError, message.c_str());
    throw py::error_already_set();
  }
  io::write_checkpoint(file, force, litter.acted());
}

std::shared_ptr<Litter> load(const py::object& path) {
  const std::string file = path_text(path);
  const Snapshot snapshot = io::read_checkpoint(file);
  try {
    return std::make_shared<Litter>(Simulation(snapshot));
  } catch (const std::invalid_argument& wrong) {
    io::refuse(file + ": " + wrong.what());
  }
}

void step(Litter& litter, const py::object& count) {
  using Limits = std::numeric_limits<std::int64_t>;
  litter.step(whole_number("count", count, Limits::min(), Limits::max()));
}

void set_threads(Litter& litter, const py::object& threads) {
  constexpr std::int64_t kMost = 1024;
  litter.set_threads(static_cast<int>(whole_number("threads", threads, 1, kMost)));
}

/// Width or height of a picture; the graphics module knows which are too large.
int side(const char* name, const py::object& value) {
  return static_cast<int>(whole_number(name, value, 1, std::numeric_limits<int>::max()));
}

py::array image(Litter& litter, const py::object& width, const py::object& height,
                const py::str& color_by, const std::optional<py::str>& colormap,
                const std::optional<std::pair<double, double>>& scale, const py::str& camera,
                bool bar) {
  Look look{side("width", width),
            side("height", height),
            text_of(color_by),
            {},
            scale,
            text_of(camera),
            bar};
  if (colormap) look.colormap = text_of(*colormap);
  return litter.image(look);
}

/// An array of actions as an attribute that can be assigned to as a whole, too.
void add_action(LitterType& type, const char* name, py::array (Litter::*array)() const,
                const char* doc) {
  type.def_property(
      name, array,
      [array](const Litter& litter, const py::object& values) {
        (litter.*array)().attr("__setitem__")(py::ellipsis(), values);
      },
      doc);
}

void add_actions(LitterType& type) {
  add_action(type, "force", &Litter::force, kForceDoc);
  add_action(type, "heat", &Litter::heat, kHeatDoc);
  add_action(type, "turn", &Litter::turn, kTurnDoc);
}

/// What is of the litter as a whole.
void add_state(LitterType& type) {
  const auto add = [&](const char* name, const auto& get, const char* doc) {
    type.def_property_readonly(name, get, doc);
  };
  add(
      "steps_done", [](const Litter& l) { return l.simulation().steps_done(); }, "Steps taken.");
  add(
      "time", [](const Litter& l) { return l.simulation().time(); }, "Model time [s].");
  add(
      "points", [](const Litter& l) { return l.simulation().points(); }, kPointsDoc);
  add("position", &Litter::positions, kPositionDoc);
  add("velocity", &Litter::velocities, kVelocityDoc);
  add("hash", hash_text, kHashDoc);
  add("warnings", warnings_of, kWarningsDoc);
  type.def_property("threads", &Litter::threads, set_threads, kThreadsDoc);
}

void add_methods(LitterType& type) {
  type.def("step", step, py::arg("count") = 1, kStepDoc);
  type.def(
      "record",
      [](Litter& litter, const py::str& field) {
        litter.record(io::named_field(text_of(field), "record"));
      },
      py::arg("field"), kRecordDoc);
  type.def(
      "observe", [](Litter& litter) { return dict_of(litter.observe()); }, kObserveDoc);
  type.def("copy", &Litter::copy, kCopyDoc);
  type.def("__copy__", &Litter::copy);
  type.def("__deepcopy__", [](Litter& litter, const py::dict&) { return litter.copy(); });
  type.def("save", save, py::arg("path"), py::arg("force") = false, kSaveDoc);
  type.def("image", image, py::arg("width") = 1280, py::arg("height") = 960, py::kw_only(),
           py::arg("color_by") = "tb", py::arg("colormap") = py::none(),
           py::arg("scale") = py::none(), py::arg("camera") = view::Camera::kUsual,
           py::arg("bar") = true, kImageDoc);
  type.def("__repr__", repr);
}

/// The short ways: fields of a pup, then parameters, where no attribute has their name yet.
void add_short_ways(LitterType& type) {
  const auto add = [&](const auto& row) {
    if (!py::hasattr(type, std::string(row.name).c_str())) add_attribute(type, row);
  };
  for (const LitterField& field : pup_fields()) add(field);
  for (const Parameter& parameter : parameters()) add(parameter);
}

}  // namespace

py::dict dict_of(const Observables& observables) {
  py::dict values;
  for (const ObservableField& field : pupflow::observables())
    values[text(field.name)] = observables.*field.value;
  return values;
}

void add_litter(py::module_& module) {
  LitterType type(module, "Litter", kLitterDoc);
  type.def(py::init([](const py::object& scene, const py::kwargs& parameters) {
             return std::make_shared<Litter>(Simulation(params_of(scene, parameters)));
           }),
           py::arg("scene") = py::none());
  add_state(type);
  add_actions(type);
  add_methods(type);
  add_group<parameters>(module, type, "Params", "params", kParamsDoc);
  add_group<pup_fields>(module, type, "PupFields", "pup", kPupDoc);
  add_group<afferent_fields>(module, type, "AfferentFields", "afferent", kAfferentDoc);
  add_short_ways(type);
  finish(type, "; save() and load() it, or copy() it");
  module.def("load", load, py::arg("path"), kLoadDoc);
}

}  // namespace pupflow::python
