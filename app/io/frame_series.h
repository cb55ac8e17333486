// A data set that grows by a row a frame, written in chunks by a second thread.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "app/io/background.h"
#include "app/io/deflate.h"
#include "app/io/hdf5_file.h"

namespace pupflow::io {

/// What several series of one file share. HDF5 is never called by two threads at a time: once there
/// are frames, only this thread works with the file.
struct SeriesWriter {
  explicit SeriesWriter(const Hdf5Writer& to) : file(to) {
    thread.run(quiet_hdf5);
    thread.wait_for_all();
  }
  const Hdf5Writer& file;
  ChunkDeflater deflater;  // of the thread
  Background thread;
};

/// A data set (frame, item, ...), or (frame) for one number a frame. A chunk holds 64 frames of one
/// item, shuffled and compressed by gzip, with a checksum. Where 64 frames of all items take more than
/// kMostBuffered, it holds fewer frames of more items. Memory: twice the frames of a chunk.
/// Members throw Failure(bad_file).
class FrameSeries {
 public:
  static constexpr std::size_t kChunkFrames = 64;
  static constexpr std::size_t kMostBuffered = std::size_t{1} << 25;  // bytes

  /// `shape` is that of a frame, without a 0; its first size counts the items.
  FrameSeries(SeriesWriter& writer, const std::string& name, const std::vector<hsize_t>& shape,
              NumberType type);

  hid_t id() const { return set_; }
  std::size_t items() const { return items_; }

  /// Where the numbers of an item go in the frame under way, in the order of the file.
  std::span<std::byte> row(std::size_t item);

  /// The numbers of all items, rounded to the type of the data set. What is not a number becomes
  /// kNotKnown of an integer type.
  void fill(std::span<const double> values);

  /// The frame under way is complete.
  void next_frame();

  /// Writes the frames of the chunk under way, where no chunk was completed since the last call and
  /// they have doubled since they were last written: their former place in the file is lost each time.
  void flush();

  /// Writes what is left. Last.
  void finish();

 private:
  void hand_over();
  void write(const std::vector<std::byte>& chunks, hsize_t first, hsize_t frames);
  hid_t make(const std::string& name);

  SeriesWriter& writer_;
  std::vector<hsize_t> extent_;  // of the data set with all frames so far
  std::vector<hsize_t> chunk_;
  NumberType type_;
  std::size_t items_, chunk_frames_, chunk_items_, row_bytes_;
  std::size_t frames_ = 0;                    // in `filling_`
  bool completed_ = false;                    // a chunk, since the last flush
  std::size_t flushed_ = 0;                   // of them, already in the file
  std::vector<std::byte> filling_, leaving_;  // chunk by chunk
  std::vector<std::byte> stored_;             // of the thread: a chunk as it goes to the file
  Background::Ticket left_ = 0;
  Handle set_;
};

}  // namespace pupflow::io
