#include "app/export/field_stream.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>

#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/text.h"

namespace pupflow::exporting {
namespace {

const io::SetInfo& choose(const io::RecordedRun& recording, const std::string& name,
                          const std::vector<std::string>& usual) {
  for (const std::string& candidate : name.empty() ? usual : std::vector{name}) {
    if (const io::SetInfo* set = recording.find(candidate)) return *set;
  }
  const std::string there =
      io::joined(recording.fields(), ", ", [](const io::SetInfo& set) { return set.name; });
  const std::string wanted = name.empty() ? io::joined(usual, " nor ") : io::quoted(name);
  io::refuse(recording.path() + ": does not hold " + wanted + "; it holds " + there +
             " ('pupflow run --record-fields' chooses)");
}

std::size_t product(const std::vector<std::size_t>& sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), std::size_t{1}, std::multiplies<>());
}

}  // namespace

FieldStream::FieldStream(const io::RecordedRun& recording, const Request& request,
                         const std::vector<std::string>& usual, bool sheet)
    : recording_(recording),
      pup_(request.pup),
      field_(&choose(recording, request.field, usual)),
      shape_(field_->shape.begin() + (pup_ ? 2 : 1), field_->shape.end()) {
  in_file_ = product(shape_);
  if (!sheet) return;
  if (!field_->name.starts_with("afferent/")) {
    io::refuse(field_->name + " is no field of afferents, so there is no sheet of it");
  }
  const io::RecordedRun::Sheet image = recording.sheet();
  sheet_ = image.afferent;
  afferents_ = shape_.back();
  shape_.back() = image.size;
  shape_.push_back(image.size);
}

std::size_t FieldStream::size() const {
  return product(shape_);
}

void FieldStream::for_each_frame(io::NumberType type, io::Progress& progress,
                                 const Use& use) const {
  constexpr std::size_t kMostAtOnce = std::size_t{1} << 25;  // bytes
  const std::size_t width = io::byte_size(type), bytes = in_file_ * width;
  const std::size_t at_once = std::clamp<std::size_t>(kMostAtOnce / bytes, 1, 64);
  std::vector<std::byte> block(at_once * bytes), image(sheet_.empty() ? 0 : size() * width);
  for (std::size_t first = 0; first < recording_.frames(); first += at_once) {
    const std::size_t count = std::min(at_once, recording_.frames() - first);
    recording_.read(*field_, first, count, pup_, type, block.data());
    for (std::size_t i = 0; i < count; ++i) {
      if (io::interrupted()) throw io::Failure(io::ExitCode::interrupted, "interrupted");
      const auto recorded = std::span(block).subspan(i * bytes, bytes);
      if (sheet_.empty()) {
        use(first + i, recorded);
      } else {
        for (std::size_t pixel = 0; pixel < size(); ++pixel) {
          const std::size_t pup = pixel / sheet_.size();
          const auto afferent = static_cast<std::size_t>(sheet_[pixel % sheet_.size()]);
          std::memcpy(&image[pixel * width], &recorded[(pup * afferents_ + afferent) * width],
                      width);
        }
        use(first + i, image);
      }
      progress.update(static_cast<std::int64_t>(first + i + 1));
    }
  }
}

}  // namespace pupflow::exporting
