#include "app/io/checkpoint.h"

#include <algorithm>

#include "app/io/failure.h"
#include "app/io/hdf5_file.h"
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
  const Handle set(file.checked(H5Dcreate2(file.id(), name, stored, space, H5P_DEFAULT, H5P_DEFAULT,
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

}  // namespace

void write_checkpoint(const std::string& path, bool force, const Snapshot& snapshot) {
  Hdf5Writer file(path, force);
  for (const auto& [name, value] : provenance(snapshot.params)) file.text(name, value);
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
  snapshot.positions = file.numbers("position");
  snapshot.velocities = file.numbers("velocity");
  snapshot.body_temperature = file.numbers("body_temperature");
  // A version before 0.2.0 did not keep what others felt in the last step.
  snapshot.felt_tb = file.numbers(file.has("felt_tb") ? "felt_tb" : "body_temperature");
  snapshot.heading = file.numbers("heading");
  snapshot.exposed = file.numbers("exposed");
  snapshot.touched = file.integers("touched");
  const std::vector<int> touching = file.integers("touching");
  for (std::size_t i = 0; i + 1 < touching.size(); i += 2) {
    snapshot.touching.push_back({touching[i], touching[i + 1]});
  }
  const std::vector<double> clock = file.numbers("clock");
  const auto is_step = [](double number) { return number >= 0 && number <= 9e15; };
  if (clock.size() != 3 || !is_step(clock[0]) || !is_step(clock[1])) {
    refuse(path + ": is no checkpoint: its clock makes no sense");
  }
  snapshot.step = static_cast<std::int64_t>(clock[0]);
  snapshot.clock = {static_cast<std::int64_t>(clock[1]), clock[2]};
  return snapshot;
}

TextEntries read_hdf5_text(const std::string& path) {
  return Hdf5Reader(path).text();
}

}  // namespace pupflow::io
