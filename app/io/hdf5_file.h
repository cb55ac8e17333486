// The few things that this program does with HDF5, each checked.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/io/atomic_file.h"
#include "app/io/data_set.h"
#include "app/io/png.h"

namespace pupflow::io {

/// An HDF5 handle that closes itself.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor)

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// HDF5 prints its own account of every error, and crashes at the end of the program where a file
/// could not be closed because the disk is full. From now on it does neither, on this thread; files
/// that are opened here see to it. Throws std::bad_alloc where HDF5 cannot start; HDF5 has then printed
/// why.
void quiet_hdf5();

/// HDF5's name for such numbers in memory.
hid_t hdf5_type(NumberType type);

/// What a file is for. Those that this program reads again begin with a user block (user_block.h).
enum class Hdf5Kind {
  plain,       // for other programs: no block
  checkpoint,  // made in memory and written at once
  recording    // grows; may be read while it does, and after a kill
};

/// A new HDF5 file, written aside and put in place by commit(). Members throw Failure(bad_file).
/// When a recording cannot be written any more, what was flushed stays aside, and the message says
/// where.
class Hdf5Writer {
 public:
  Hdf5Writer(const std::string& path, bool force, Hdf5Kind kind);
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  hid_t id() const { return file_; }

  /// Adds a text attribute to the file, or to `object` in it, in place of one of that name.
  void text(const std::string& name, const std::string& value) const { text(file_, name, value); }
  void text(hid_t object, const std::string& name, const std::string& value) const;

  /// Adds a number as an attribute.
  void number(hid_t object, const std::string& name, double value) const;
  void number(hid_t object, const std::string& name, std::int64_t value) const;

  /// Adds `entries` to the file: parameters that are numbers as such, the rest as text.
  void about(const TextEntries& entries) const;

  /// Adds a data set as a whole, in groups that are made where they are missing, and returns it.
  /// `values` has as many numbers as `shape` says.
  Handle whole(const std::string& name, const std::vector<hsize_t>& shape, NumberType type,
               const void* values) const;

  /// From now on data sets only grow: what is flushed can be read whatever happens next. For a
  /// recording whose data sets are all there.
  void only_grow();

  /// Hands everything to the operating system.
  void flush() const;

  void commit();

  /// `result` as it is; throws when it says that HDF5 failed.
  hid_t checked(hid_t result) const;

 private:
  void add_number(hid_t object, const std::string& name, hid_t type, const void* value) const;

  std::string image() const;

  std::string path_;
  Hdf5Kind kind_;
  AtomicFile target_;
  hid_t file_;
  // By whoever works with the file, one thread at a time.
  mutable bool failed_ = false, flushed_ = false;
};

}  // namespace pupflow::io
