#include "python/litter_class.h"

#include <pybind11/stl.h>

#include <cinttypes>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/io/atomic_file.h"
#include "app/io/checkpoint.h"
#include "app/io/failure.h"
#include "app/io/named_field.h"
#include "app/io/text.h"
#include "app/view/camera.h"
#include "python/arrays.h"
#include "python/errors.h"
#include "python/image.h"
#include "python/litter.h"
#include "python/values.h"
#include "python/words.h"

namespace pupflow::python {
namespace {

using Shared = std::shared_ptr<Litter>;

constexpr const char* kLitterDoc =
    "Litter(scene=None, **parameters)\n"
    "\n"
    "A litter of pups in its arena.\n"
    "\n"
    "scene: the name of a shipped scene (pupflow.scenes()), or the path of a scene file.\n"
    "parameters: any parameter by name, over those of the scene: Litter('cold', seed=1, ta=0.3).\n"
    "\n"
    "Its attributes are the fields of its pups (numpy arrays) and its parameters. All of them are "
    "also\n"
    "in three groups: params (parameters), pup (fields of a pup), afferent (fields of an afferent, "
    "a\n"
    "point of a pup). Where a name stands for two things, the attribute is the first of: control, "
    "field,\n"
    "parameter; so heading is the direction of travel, and params.heading what a pup steers "
    "about.\n"
    "\n"
    "Arrays show the state after the last step. They are read-only and keep their numbers when "
    "the\n"
    "litter is stepped; read the attribute again for the next state. A field that the last step "
    "did not\n"
    "record raises RuntimeError: strain, until record('strain'), and a few right after load().\n"
    "\n"
    "Litters may be stepped in several threads at once, each litter by one thread at a time.";

constexpr const char* kStepDoc =
    "step(count=1)\n"
    "\n"
    "Takes count steps. Other threads run meanwhile, and Ctrl-C ends the call between two steps.\n"
    "Raises BadNumbers, then and at each later call.";

constexpr const char* kImageDoc =
    "image(width=1280, height=960, *, color_by='tb', colormap=None, scale=None, "
    "camera='orbit:30,35',\n"
    "      bar=True)\n"
    "\n"
    "A picture of the litter: a numpy array (height, width, 3) of uint8. Needs no display.\n"
    "\n"
    "color_by: a field of a pup or an afferent. colormap and scale (low, high): by default the "
    "field's.\n"
    "camera: 'top', 'side' or 'orbit:azimuth,elevation[,distance]'. bar: draw the legend.\n"
    "Raises RuntimeError where there is no OpenGL, with what to install.";

using LitterType = py::class_<Litter, std::shared_ptr<Litter>>;

/// A group of attributes of one litter, one for each row of a table.
template <auto Table>
struct Group {
  std::shared_ptr<Litter> litter;
};

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

bool is_known(const Litter&, const Parameter&) {
  return true;
}
bool is_known(const Litter& litter, const LitterField& field) {
  return litter.is_known(field);
}

template <auto Table>
py::list names_of(const Group<Table>& group) {
  py::list names;
  for (const auto& row : Table()) {
    if (is_known(*group.litter, row)) names.append(text(row.name));
  }
  return names;
}

/// What all classes have in common.
void finish(const py::object& type) {
  refuse_unknown_attributes(type);
  type.attr("__module__") = "pupflow";
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
  type.def("__getitem__", [](const py::object& self, const py::str& key) {
    if (!names_of(self.cast<const Owner&>()).contains(key)) throw py::key_error(key);
    return py::object(self.attr(key));
  });
  finish(type);
  litter.def_property_readonly(
      name, [](const std::shared_ptr<Litter>& self) { return Owner{self}; }, doc);
}

std::int64_t whole_number(const py::object& value) {
  const py::object number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!number) throw py::error_already_set();
  return number.cast<std::int64_t>();
}

std::string hash_text(Litter& litter) {
  return io::formatted("%016" PRIx64, litter.hash());
}

std::string path_text(const py::object& path) {
  return py::module_::import("os").attr("fspath")(path).cast<std::string>();
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
  if (!force && !io::is_stream(file) && std::filesystem::exists(file)) {
    PyErr_SetString(PyExc_FileExistsError,
                    (file + ": exists already; use force=True to replace it").c_str());
    throw py::error_already_set();
  }
  io::write_checkpoint(file, force, litter.snapshot());
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

py::array image(Litter& litter, int width, int height, const std::string& color_by,
                const std::optional<std::string>& colormap,
                const std::optional<std::pair<double, double>>& scale, const std::string& camera,
                bool bar) {
  return litter.image({width, height, color_by, colormap, scale, camera, bar});
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
  add_action(
      type, "force", &Litter::force,
      "(pups, 3) acceleration of each pup [length/s^2] in the steps to come, added to gravity "
      "and\ndrive. Writable: litter.force[3] = (1, 0, 0).");
  add_action(type, "heat", &Litter::heat,
             "(pups,) heat of each pup [normalised/s] in the steps to come, added to g. Writable.\n"
             "(params.heat is the parameter of that name.)");
  add_action(type, "turn", &Litter::turn,
             "(pups,) turn of each pup [rad/s] in the steps to come, in place of its own; nan: its "
             "own.\nWritable. (pup.turn is the turn that pups took in the last step.)");
}

/// What is of the litter as a whole.
void add_state(LitterType& type) {
  type.def_property_readonly(
      "steps_done", [](const Litter& l) { return l.simulation().steps_done(); }, "Steps taken.");
  type.def_property_readonly(
      "time", [](const Litter& l) { return l.simulation().time(); }, "Model time [s].");
  type.def_property_readonly(
      "points", [](const Litter& l) { return l.simulation().points(); },
      "Points of a pup, 6 face_points^2: face by face (+x, +y, +z, -x, -y, -z of the body), each "
      "a\n"
      "grid of face_points x face_points.");
  type.def_property_readonly("position", &Litter::positions,
                             "(pups, points, 3) positions of all points [length], of float32 or\n"
                             "float64 as precision is.");
  type.def_property_readonly("velocity", &Litter::velocities,
                             "(pups, points, 3) velocities of all points [length/s].");
  type.def_property_readonly(
      "hash", hash_text,
      "The hash of the state, as `pupflow run` prints it: equal for equal bits.");
  type.def_property_readonly("warnings", warnings_of,
                             "The impossible states so far, the first of each kind, as messages.");
  type.def_property("threads", &Litter::threads, &Litter::set_threads,
                    "Threads that share a step; results keep their bits.");
}

void add_methods(LitterType& type) {
  type.def(
      "step", [](Litter& litter, const py::object& count) { litter.step(whole_number(count)); },
      py::arg("count") = 1, kStepDoc);
  type.def(
      "record",
      [](Litter& litter, const std::string& field) {
        litter.record(io::named_field(field, "record"));
      },
      py::arg("field"),
      "record(field)\n\nHas the steps to come record what the field of that name shows; before the "
      "first step, at once.\nOnly strain needs it, which costs time.");
  type.def(
      "observe", [](Litter& litter) { return dict_of(litter.observe()); },
      "observe()\n\nThe observables of the litter after the last step: a dict by name. Those that\n"
      "compare with an earlier state (flow, membership_flow) are nan before the first step.");
  type.def("copy", &Litter::copy,
           "copy()\n\nA litter of its own that goes on bit for bit like this one.");
  type.def("__copy__", &Litter::copy);
  type.def("__deepcopy__", [](Litter& litter, const py::dict&) { return litter.copy(); });
  type.def(
      "save", save, py::arg("path"), py::arg("force") = false,
      "save(path, force=False)\n\nWrites a checkpoint, from which load() or `pupflow run --from` "
      "goes on bit for bit.\nforce: replace a file that exists.");
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
  add_group<parameters>(module, type, "Params", "params",
                        "All parameters by name, as attributes and as items.");
  add_group<pup_fields>(module, type, "PupFields", "pup",
                        "All fields of a pup by name, arrays (pups,), as attributes and as items.");
  add_group<afferent_fields>(
      module, type, "AfferentFields", "afferent",
      "All fields of an afferent by name, arrays (pups, points), as attributes and as items.");
  add_short_ways(type);
  finish(type);
  module.def(
      "load", load, py::arg("path"),
      "load(path)\n\nThe litter of a checkpoint, which goes on bit for bit like the one saved.");
}

}  // namespace pupflow::python
