#include "app/io/frame_series.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>
#include <utility>

namespace pupflow::io {
namespace {

template <class Number>
void convert(std::span<const double> values, std::span<std::byte> to) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    Number number{};
    if constexpr (std::is_floating_point_v<Number>) {
      number = static_cast<Number>(values[i]);
    } else {
      number = std::isnan(values[i]) ? kNotKnown<Number> : static_cast<Number>(values[i]);
    }
    std::memcpy(to.data() + i * sizeof number, &number, sizeof number);
  }
}

/// Appends the checksum that HDF5's filter fletcher32 appends: that of big-endian words of two
/// bytes, a last odd byte being the upper one.
void append_fletcher32(std::vector<std::byte>& bytes) {
  constexpr std::size_t kWithoutOverflow = 720;  // bytes, after which the sums are folded
  const auto fold = [](std::uint32_t sum) { return (sum & 0xffff) + (sum >> 16); };
  std::uint32_t first = 0, second = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(at + kWithoutOverflow, bytes.size());
    for (; at < end; at += 2) {
      const auto low = at + 1 < bytes.size() ? static_cast<std::uint32_t>(bytes[at + 1]) : 0;
      first += static_cast<std::uint32_t>(bytes[at]) << 8 | low;
      second += first;
    }
    first = fold(first);
    second = fold(second);
  }
  const std::uint32_t sum = fold(second) << 16 | fold(first);
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::byte>(sum >> shift));
}

std::size_t product(std::span<const hsize_t> sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), std::size_t{1}, std::multiplies<>());
}

}  // namespace

FrameSeries::FrameSeries(SeriesWriter& writer, const std::string& name,
                         const std::vector<hsize_t>& shape, NumberType type)
    : writer_(writer),
      type_(type),
      items_(shape.empty() ? 1 : shape.front()),
      row_bytes_(byte_size(type) * product(shape) / items_),
      set_(hid_t{-1}, H5Dclose) {
  chunk_frames_ = std::clamp<std::size_t>(kMostBuffered / (items_ * row_bytes_), 1, kChunkFrames);
  chunk_items_ = std::min(items_, (kChunkFrames + chunk_frames_ - 1) / chunk_frames_);
  extent_ = chunk_ = shape;
  if (!shape.empty()) chunk_.front() = chunk_items_;
  extent_.insert(extent_.begin(), 0);
  chunk_.insert(chunk_.begin(), chunk_frames_);
  const std::size_t blocks = (items_ + chunk_items_ - 1) / chunk_items_;
  filling_.resize(blocks * chunk_frames_ * chunk_items_ * row_bytes_);
  leaving_.resize(filling_.size());
  set_ = Handle(make(name), H5Dclose);
}

hid_t FrameSeries::make(const std::string& name) {
  const Hdf5Writer& file = writer_.file;
  std::vector<hsize_t> limit = extent_;
  limit.front() = H5S_UNLIMITED;
  const auto rank = static_cast<int>(extent_.size());
  const Handle space(file.checked(H5Screate_simple(rank, extent_.data(), limit.data())), H5Sclose);
  const Handle properties(file.checked(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
  file.checked(H5Pset_chunk(properties, rank, chunk_.data()));
  file.checked(H5Pset_shuffle(properties));
  file.checked(H5Pset_deflate(properties, 1));
  file.checked(H5Pset_fletcher32(properties));
  const Handle link(file.checked(H5Pcreate(H5P_LINK_CREATE)), H5Pclose);
  file.checked(H5Pset_create_intermediate_group(link, 1));
  return file.checked(
      H5Dcreate2(file.id(), name.c_str(), hdf5_type(type_), space, link, properties, H5P_DEFAULT));
}

std::span<std::byte> FrameSeries::row(std::size_t item) {
  const std::size_t block = item / chunk_items_, within = item % chunk_items_;
  const std::size_t place = (block * chunk_frames_ + frames_) * chunk_items_ + within;
  return std::span(filling_).subspan(place * row_bytes_, row_bytes_);
}

void FrameSeries::fill(std::span<const double> values) {
  const std::size_t in_row = row_bytes_ / byte_size(type_);
  for (std::size_t item = 0; item < items_; ++item) {
    const auto from = values.subspan(item * in_row, in_row);
    switch (type_) {
      case NumberType::f8:
        std::memcpy(row(item).data(), from.data(), row_bytes_);
        break;
      case NumberType::f4:
        convert<float>(from, row(item));
        break;
      case NumberType::i8:
        convert<std::int64_t>(from, row(item));
        break;
      case NumberType::i4:
        convert<std::int32_t>(from, row(item));
        break;
      case NumberType::i2:
        convert<std::int16_t>(from, row(item));
        break;
      case NumberType::u1:
        convert<std::uint8_t>(from, row(item));
        break;
    }
  }
}

void FrameSeries::next_frame() {
  if (++frames_ == chunk_frames_) hand_over();
}

void FrameSeries::hand_over() {
  writer_.thread.wait(left_);  // until `leaving_` is free again
  filling_.swap(leaving_);
  const hsize_t first = extent_.front(), frames = frames_;
  extent_.front() += frames;
  frames_ = flushed_ = 0;
  completed_ = true;
  left_ = writer_.thread.run([this, first, frames] { write(leaving_, first, frames); });
}

void FrameSeries::write(const std::vector<std::byte>& chunks, hsize_t first, hsize_t frames) {
  const Hdf5Writer& file = writer_.file;
  std::vector<hsize_t> extent = extent_, place(extent_.size(), 0);
  extent.front() = first + frames;
  file.checked(H5Dset_extent(set_, extent.data()));
  place.front() = first;
  const std::size_t bytes = chunk_frames_ * chunk_items_ * row_bytes_;
  for (std::size_t begin = 0; begin < chunks.size(); begin += bytes) {
    const auto chunk = std::span(chunks).subspan(begin, bytes);
    const auto packed = writer_.deflater.deflate(chunk, byte_size(type_));
    constexpr std::uint32_t kAllFilters = 0, kOnlyChecksum = 3;  // bits of those that are left out
    const auto& numbers = packed.empty() ? chunk : packed;
    stored_.assign(numbers.begin(), numbers.end());
    append_fletcher32(stored_);
    file.checked(H5Dwrite_chunk(set_, H5P_DEFAULT, packed.empty() ? kOnlyChecksum : kAllFilters,
                                place.data(), stored_.size(), stored_.data()));
    if (place.size() > 1) place[1] += chunk_items_;
  }
}

void FrameSeries::flush() {
  const bool completed = std::exchange(completed_, false);
  if (completed || frames_ == 0 || frames_ < 2 * flushed_) return;
  writer_.thread.wait(left_);
  leaving_ = filling_;
  flushed_ = frames_;
  left_ = writer_.thread.run(
      [this, first = extent_.front(), frames = frames_] { write(leaving_, first, frames); });
}

void FrameSeries::finish() {
  if (frames_ > 0) hand_over();
  writer_.thread.wait(left_);
}

}  // namespace pupflow::io
