#include "app/io/checkpoint.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/io/failure.h"
#include "app/io/hdf5_reader.h"
#include "app/io/provenance.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

constexpr const char* kKind = "checkpoint";

/// Writes a dataset of the given shape whole.
void write(const Hdf5Writer& file, const char* name, const std::vector<hsize_t>& shape,
           hid_t stored, hid_t type, const void* data) {
  const Handle space(
      file.checked(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr)),
      H5Sclose);
  const Handle properties(file.checked(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
  file.checked(H5Pset_obj_track_times(properties, false));  // equal litters give equal bytes
  const Handle set(file.checked(H5Dcreate2(file.id(), name, stored, space, H5P_DEFAULT, properties,
                                           H5P_DEFAULT)),
                   H5Dclose);
  const bool empty = std::find(shape.begin(), shape.end(), 0) != shape.end();
  if (!empty) file.checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
}

void write(const Hdf5Writer& file, const char* name, const std::vector<hsize_t>& shape,
           const std::vector<double>& values) {
  write(file, name, shape, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.data());
}

void write(const Hdf5Writer& file, const char* name, const std::vector<hsize_t>& shape,
           const std::vector<int>& values) {
  write(file, name, shape, H5T_STD_I32LE, H5T_NATIVE_INT, values.data());
}

constexpr const char* kActions = "action";  // a row a pup: force x y z, heat, turn or nan

std::vector<double> numbers_of(const std::vector<Action>& actions) {
  std::vector<double> numbers;
  for (const Action& action : actions) {
    numbers.insert(numbers.end(), action.force.begin(), action.force.end());
    numbers.insert(numbers.end(), {action.heat, action.turn.value_or(std::nan(""))});
  }
  return numbers;
}

std::vector<Action> actions_of(const std::vector<double>& numbers) {
  std::vector<Action> actions;
  for (std::size_t i = 0; i + 5 <= numbers.size(); i += 5) {
    const double* row = numbers.data() + i;
    Action& action = actions.emplace_back(Action{{row[0], row[1], row[2]}, row[3], {}});
    if (!std::isnan(row[4])) action.turn = row[4];
  }
  return actions;
}

/// The entry `edited` as a number. A file without hash is of a version that did not say.
std::optional<std::int64_t> edited_step(const TextEntries& entries, std::int64_t step) {
  const auto find = [&](const char* name) {
    return std::find_if(entries.begin(), entries.end(),
                        [&](const auto& entry) { return entry.first == name; });
  };
  if (find("hash") == entries.end()) return step;
  const auto edited = find("edited");
  if (edited == entries.end()) return std::nullopt;
  return read_number<std::int64_t>(edited->second).value_or(step);
}

/// Pairs of pups; each at most once.
std::vector<TouchingPair> read_touching(const Hdf5Reader& file, const std::string& path,
                                        std::uint64_t pups) {
  const std::vector<std::uint64_t> shape = file.shape("touching");
  if (shape.size() != 2 || shape[0] > pups * pups / 2) {
    throw Failure(ExitCode::bad_file, path + ": is damaged: more pairs touch than there are");
  }
  const std::vector<int> numbers = file.integers("touching", {shape[0], 2});
  std::vector<TouchingPair> pairs;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    pairs.push_back({numbers[i], numbers[i + 1]});
  }
  return pairs;
}

void read_clock(const Hdf5Reader& file, const std::string& path, Snapshot& snapshot) {
  const std::vector<double> clock = file.numbers("clock", {3});
  const auto is_step = [](double number) { return number >= 0 && number <= 9e15; };
  if (!is_step(clock[0]) || !is_step(clock[1])) {
    refuse(path + ": is no checkpoint: its clock makes no sense");
  }
  snapshot.step = static_cast<std::int64_t>(clock[0]);
  snapshot.clock = {static_cast<std::int64_t>(clock[1]), clock[2]};
}

}  // namespace

void write_checkpoint(const std::string& path, bool force, const Simulation& litter) {
  const Snapshot snapshot = litter.snapshot();
  Hdf5Writer file(path, force, Hdf5Kind::checkpoint);
  TextEntries entries = provenance(snapshot.params);
  add_state(litter, entries);
  for (const auto& [name, value] : entries) file.text(name, value);
  file.text("kind", kKind);
  const auto pups = static_cast<hsize_t>(snapshot.params.pups);
  const auto points = static_cast<hsize_t>(points_per_pup(snapshot.params));
  write(file, "position", {pups, points, 3}, snapshot.positions);
  write(file, "velocity", {pups, points, 3}, snapshot.velocities);
  write(file, "body_temperature", {pups}, snapshot.body_temperature);
  write(file, "felt_tb", {pups}, snapshot.felt_tb);
  write(file, "heading", {pups}, snapshot.heading);
  write(file, "exposed", {pups}, snapshot.exposed);
  write(file, "touched", {pups, points}, snapshot.touched);
  std::vector<int> touching;
  for (const TouchingPair& pair : snapshot.touching)
    touching.insert(touching.end(), {pair.first, pair.second});
  write(file, "touching", {snapshot.touching.size(), 2}, touching);
  if (!snapshot.actions.empty()) write(file, kActions, {pups, 5}, numbers_of(snapshot.actions));
  const std::vector<double> clock{static_cast<double>(snapshot.step),
                                  static_cast<double>(snapshot.clock.step), snapshot.clock.time};
  write(file, "clock", {3}, clock);
  file.commit();
}

Snapshot read_checkpoint(const std::string& path) {
  const Hdf5Reader file(path);
  const TextEntries entries = file.text();
  const auto kind =
      std::find(entries.begin(), entries.end(), std::pair<std::string, std::string>("kind", kKind));
  if (kind == entries.end()) {
    refuse(path + ": is no checkpoint; 'pupflow run --checkpoint FILE' writes one");
  }
  Snapshot snapshot;
  snapshot.params = params_from(entries, path);
  const auto pups = static_cast<std::uint64_t>(snapshot.params.pups);
  const auto points = static_cast<std::uint64_t>(points_per_pup(snapshot.params));
  snapshot.positions = file.numbers("position", {pups, points, 3});
  snapshot.velocities = file.numbers("velocity", {pups, points, 3});
  snapshot.body_temperature = file.numbers("body_temperature", {pups});
  // A version before 0.2.0 did not keep what others felt in the last step.
  snapshot.felt_tb = file.numbers(file.has("felt_tb") ? "felt_tb" : "body_temperature", {pups});
  snapshot.heading = file.numbers("heading", {pups});
  snapshot.exposed = file.numbers("exposed", {pups});
  snapshot.touched = file.integers("touched", {pups, points});
  snapshot.touching = read_touching(file, path, pups);
  read_clock(file, path, snapshot);
  if (file.has(kActions)) snapshot.actions = actions_of(file.numbers(kActions, {pups, 5}));
  snapshot.edited = edited_step(entries, snapshot.step);
  snapshot.in_force = params_of_step(snapshot.params, snapshot.step);
  return snapshot;
}

TextEntries read_hdf5_text(const std::string& path) {
  return Hdf5Reader(path).text();
}

}  // namespace pupflow::io
