#include "app/io/recorded_run.h"

#include <algorithm>

#include "app/io/failure.h"
#include "app/io/hdf5_reader.h"
#include "app/io/provenance.h"
#include "app/io/recording.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

constexpr std::uint64_t kMostFrames = std::uint64_t{1} << 32;

std::string value_of(const TextEntries& entries, std::string_view name) {
  for (const auto& [key, value] : entries) {
    if (key == name) return value;
  }
  return {};
}

std::string group_of(const SetInfo& set) {
  return set.name.substr(0, set.name.find('/'));
}

std::string name_in_group(const SetInfo& set) {
  return set.name.substr(set.name.find('/') + 1);
}

bool is_field(const SetInfo& set) {
  const std::string group = group_of(set);
  return set.shape.size() > 1 && (group == "pup" || group == "afferent" || group == "point");
}

}  // namespace

RecordedRun::RecordedRun(const std::string& path)
    : path_(path), file_(std::make_unique<Hdf5Reader>(path)), about_(file_->text()) {
  if (value_of(about_, "kind") != "recording") {
    refuse(path + ": is no recording; 'pupflow run --record FILE' writes one");
  }
  const std::string layout = value_of(about_, "layout");
  if (layout != std::to_string(kRecordingLayout)) {
    refuse(path + ": is a recording of layout " + (layout.empty() ? "1" : layout) +
           "; this version reads layout " + std::to_string(kRecordingLayout) +
           " (make it again with 'pupflow run --like')");
  }
  params_ = params_from(about_, path);
  for (const SetInfo& set : file_->sets()) {
    if (is_field(set)) fields_.push_back(set);
    if (set.name != "step") continue;
    if (set.shape.size() != 1 || set.shape[0] > kMostFrames ||
        file_->frames_there("step") < set.shape[0]) {
      damaged("the size of 'step' cannot be right");
    }
    steps_.resize(set.shape[0]);
  }
  check_sizes();
  times_.resize(frames());
  if (frames() == 0) return;
  file_->part("step", {0}, {frames()}, NumberType::i8, steps_.data());
  file_->part("time", {0}, {frames()}, NumberType::f8, times_.data());
}

RecordedRun::~RecordedRun() = default;

void RecordedRun::damaged(const std::string& what) const {
  throw Failure(ExitCode::bad_file, path_ + ": is damaged: " + what);
}

void RecordedRun::check_sizes() const {
  const auto pups = static_cast<std::uint64_t>(params_.pups);
  const auto points = static_cast<std::uint64_t>(points_per_pup(params_));
  for (const SetInfo& set : fields_) {
    const std::string group = group_of(set);
    std::vector<std::uint64_t> expected{frames(), pups};
    if (group != "pup") expected.push_back(points);
    if (group == "point") expected.push_back(3);
    if (set.shape != expected || !number_type(set.type)) {
      damaged(io::quoted(set.name) + " has another size than its parameters say");
    }
    if (file_->frames_there(set.name) < frames()) {
      damaged(io::quoted(set.name) + " has not all of its frames");
    }
  }
}

const SetInfo* RecordedRun::find(const std::string& name) const {
  const auto found = std::find_if(fields_.begin(), fields_.end(),
                                  [&](const SetInfo& set) { return name_in_group(set) == name; });
  return found == fields_.end() ? nullptr : &*found;
}

void RecordedRun::read(const SetInfo& field, std::size_t first, std::size_t count,
                       std::optional<int> pup, NumberType type, void* values) const {
  std::vector<std::uint64_t> begin(field.shape.size(), 0), size = field.shape;
  begin[0] = first;
  size[0] = count;
  if (pup) {
    begin[1] = static_cast<std::uint64_t>(*pup);
    size[1] = 1;
  }
  file_->part(field.name, begin, size, type, values);
}

RecordedRun::Sheet RecordedRun::sheet() const {
  const auto size = static_cast<std::uint64_t>(8 * params_.face_points);
  for (const SetInfo& set : file_->sets()) {
    if (set.name != "skin/sheet" || set.shape != std::vector<std::uint64_t>{size, size}) continue;
    std::vector<std::int16_t> pixels(size * size);
    file_->part(set.name, {0, 0}, {size, size}, NumberType::i2, pixels.data());
    const auto bad = [&](int afferent) {
      return afferent < 0 || afferent >= points_per_pup(params_);
    };
    if (std::any_of(pixels.begin(), pixels.end(), bad)) break;
    return {size, {pixels.begin(), pixels.end()}};
  }
  damaged("'skin/sheet' is not there, or not as its parameters say");
}

}  // namespace pupflow::io
