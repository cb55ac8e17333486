#include "python/tables.h"

#include <pybind11/stl.h>

#include <cmath>

#include "pupflow/observer.h"
#include "python/docstrings.h"
#include "python/litter_class.h"
#include "python/values.h"

namespace pupflow::python {
namespace {

py::object number_or_none(double value) {
  return std::isfinite(value) ? py::object(py::float_(value)) : py::none();
}

py::dict row(const Parameter& parameter) {
  py::list choices;
  for (const std::string_view choice : parameter.choices) choices.append(text(choice));
  py::dict row;
  row["symbol"] = text(parameter.symbol);
  row["title"] = text(parameter.title);
  row["unit"] = text(parameter.unit);
  row["default"] = value_of(parameter, Params{});
  row["range"] = range_text(parameter);
  row["choices"] = choices;
  row["doc"] = text(parameter.doc);
  row["source"] = text(parameter.source);
  return row;
}

py::dict row(const Field& field) {
  py::list categories;
  for (const std::string_view category : field.categories) categories.append(text(category));
  py::dict row;
  row["symbol"] = text(field.symbol);
  row["label"] = text(field.label);
  row["unit"] = text(field.unit);
  row["kind"] = text(kind_name(field.kind));
  row["low"] = number_or_none(field.low);
  row["high"] = number_or_none(field.high);
  row["categories"] = categories;
  row["equation"] = text(field.equation);
  row["doc"] = text(field.doc);
  return row;
}

template <class Table>
py::dict rows(const Table& table) {
  py::dict by_name;
  for (const auto& of_table : table) by_name[text(of_table.name)] = row(of_table);
  return by_name;
}

py::dict field_tables() {
  py::dict tables;
  tables["litter"] = rows(observables());
  tables["run"] = rows(run_statistics());
  tables["pup"] = rows(pup_fields());
  tables["afferent"] = rows(afferent_fields());
  return tables;
}

}  // namespace

void add_tables(py::module_& module) {
  module.def(
      "parameters", [] { return rows(parameters()); }, kParametersDoc);
  module.def("fields", field_tables, kFieldsDoc);
}

}  // namespace pupflow::python
