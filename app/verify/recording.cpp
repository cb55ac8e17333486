// Recordings, frame by frame.
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/io/failure.h"
#include "app/io/progress.h"
#include "app/io/recorded_run.h"
#include "app/io/text.h"
#include "app/verify/kinds.h"
#include "pupflow/fields.h"

namespace pupflow::verify {
namespace {

/// A recorded data set, and what the run has in its place.
struct Column {
  const io::SetInfo* set;
  const LitterField* field;  // null: positions
  std::string name;
  std::size_t size = 1;       // numbers of a frame
  std::vector<double> block;  // of the frames that are compared next
};

/// A number of the run as a data set of `type` keeps it.
double as_stored(double value, const std::string& type) {
  if (type == "f4") return static_cast<double>(static_cast<float>(value));
  if (!std::isnan(value)) return value;
  if (type == "i2") return io::kNotKnown<std::int16_t>;
  if (type == "u1") return io::kNotKnown<std::uint8_t>;
  return value;
}

std::vector<Column> columns_of(const io::RecordedRun& recording) {
  std::vector<Column> columns;
  for (const io::SetInfo& set : recording.fields()) {
    Column column{&set, nullptr, set.name.substr(set.name.rfind('/') + 1), 1, {}};
    column.field = find_field(column.name);
    if (!column.field && column.name != "position") {
      io::refuse(recording.path() + ": this version has no field " + io::quoted(column.name));
    }
    for (std::size_t i = 1; i < set.shape.size(); ++i) column.size *= set.shape[i];
    columns.push_back(std::move(column));
  }
  return columns;
}

std::vector<double> numbers_of(const Column& column, const LitterView& litter) {
  if (column.field) return column.field->values(litter);
  std::vector<double> positions(column.size);
  litter.positions.copy_to(std::span<double>(positions));
  return positions;
}

/// Whether a data set of `type` holds no value there.
bool is_unknown(double stored, const std::string& type) {
  const double mark = as_stored(std::numeric_limits<double>::quiet_NaN(), type);
  return stored == mark || (std::isnan(stored) && std::isnan(mark));
}

/// Where frame number `frame` of the block differs from the run. `begins`: the frame shows a
/// checkpoint, of which the file may not know all that a step records.
std::optional<std::string> compare(const Column& column, std::size_t frame,
                                   const LitterView& litter, bool begins) {
  const std::vector<double> run = numbers_of(column, litter);
  const double* file = column.block.data() + frame * column.size;
  const std::size_t of_pup = column.size / static_cast<std::size_t>(litter.pups);
  for (std::size_t i = 0; i < column.size; ++i) {
    const double expected = as_stored(run[i], column.set->type);
    if (file[i] == expected || (std::isnan(file[i]) && std::isnan(expected))) continue;
    if (begins && is_unknown(file[i], column.set->type)) continue;
    std::string where =
        "step " + std::to_string(litter.step) + ", pup " + std::to_string(i / of_pup);
    if (of_pup > 1) {
      const std::size_t each = column.field ? 1 : 3;
      where += ", point " + std::to_string(i % of_pup / each);
    }
    return difference(where, column.name, io::number_text(file[i]), io::number_text(expected));
  }
  return std::nullopt;
}

/// Frames that are read at a time: as many as a chunk has, fewer of large litters.
std::size_t block_size(const std::vector<Column>& columns) {
  constexpr std::size_t kFrames = 64, kNumbers = 1 << 22;
  std::size_t size = 1;
  for (const Column& column : columns) size += column.size;
  return std::clamp<std::size_t>(kNumbers / size, 1, kFrames);
}

}  // namespace

Verdict verify_recording(const std::string& path, const Options& options) {
  const io::RecordedRun recording(path);
  Simulation litter = litter_of(recording.about(), path, options);
  std::vector<Column> columns = columns_of(recording);
  PartSet parts;
  for (const Column& column : columns) {
    if (column.field) parts = parts | column.field->parts;
  }
  litter.set_observed(parts);
  io::Progress progress("verify", litter.recipe().steps, options.quiet);
  const std::size_t frames = recording.frames(), most = block_size(columns);
  for (std::size_t first = 0; first < frames; first += most) {
    const std::size_t count = std::min(most, frames - first);
    for (Column& column : columns) {
      column.block.resize(count * column.size);
      recording.read(*column.set, first, count, {}, io::NumberType::f8, column.block.data());
    }
    for (std::size_t frame = 0; frame < count; ++frame) {
      const std::int64_t step = recording.steps()[first + frame];
      if (step < litter.steps_done()) io::refuse(path + ": its steps do not rise");
      advance(litter, step, [&] { progress.update(litter.steps_done()); });
      if (!litter.status().ok()) {
        return {false, "the run goes wrong where the file goes on: " + litter.status().message()};
      }
      const bool begins = step > 0 && step == begun(recording.about());
      if (begins) {  // as the run did; centres and rotations are then found from the points alone
        litter = Simulation(litter.snapshot());
        litter.set_threads(options.threads);
        litter.set_observed(parts);
      }
      for (const Column& column : columns) {
        if (const auto other = compare(column, frame, litter, begins)) return {false, *other};
      }
    }
  }
  return {true, std::to_string(litter.steps_done()) + " steps, " + std::to_string(frames) +
                    " frames of " + std::to_string(columns.size()) + " fields"};
}

}  // namespace pupflow::verify
