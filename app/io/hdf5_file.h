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
/// that are opened here see to it.
void quiet_hdf5();

/// HDF5's name for such numbers in memory.
hid_t hdf5_type(NumberType type);

/// A new HDF5 file, written aside and put in place by commit(). Throws Failure(bad_file).
class Hdf5Writer {
 public:
  Hdf5Writer(const std::string& path, bool force);
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

  void commit();

  /// `result` as it is; throws when it says that HDF5 failed.
  hid_t checked(hid_t result) const;

 private:
  void add_number(hid_t object, const std::string& name, hid_t type, const void* value) const;

  std::string path_;
  AtomicFile target_;
  hid_t file_;
};

/// An HDF5 file of this program, open for reading. Throws Failure(bad_file) when it cannot be read.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::string& path);

  /// All attributes of the file that are text or one number; numbers as text that reads back to
  /// them.
  TextEntries text() const;

  /// Whether the file has a data set of that name.
  bool has(const std::string& name) const;

  /// A whole dataset, flattened. Throws Failure(bad_input) when it is missing.
  std::vector<double> numbers(const std::string& name) const;
  std::vector<int> integers(const std::string& name) const;

  /// All data sets by name, without those that are only dimensions.
  std::vector<SetInfo> sets() const;

  /// The numbers of a part of a data set, converted to `type`: a box that begins at `first` and has
  /// `count` entries along each dimension. `values` has room for them.
  void part(const std::string& name, const std::vector<std::uint64_t>& first,
            const std::vector<std::uint64_t>& count, NumberType type, void* values) const;

  /// Whether the chunks of a data set that grows are all there, so that its size can be believed.
  bool is_filled(const std::string& name) const;

 private:
  template <class T>
  std::vector<T> read(const std::string& name, hid_t type) const;

  std::string path_;
  Handle file_;
};

}  // namespace pupflow::io
