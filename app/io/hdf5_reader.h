// HDF5 files of this program, read with every size checked.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/io/data_set.h"
#include "app/io/hdf5_file.h"
#include "app/io/png.h"

namespace pupflow::io {

/// A checkpoint or a recording, open for reading. Its checksum is compared before HDF5 looks at it.
/// A checkpoint is read into memory at once. What HDF5 crashes on is found in another process and
/// refused. Members throw Failure(bad_file) when the file cannot be
/// read, is damaged, or has what no file of this program has: links to other places, data outside,
/// other filters or types.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::string& path);

  /// Whether it is a recording whose run has not ended, or was killed. Then every data set that grows
  /// is as long as the shortest of them.
  bool unfinished() const { return unfinished_; }

  /// All attributes of the file that are text or one number; numbers as text that reads back to
  /// them.
  TextEntries text() const;

  /// Whether the file has a data set of that name.
  bool has(const std::string& name) const;

  /// The sizes of a data set. Throws Failure(bad_input) when it is missing.
  std::vector<std::uint64_t> shape(const std::string& name) const;

  /// A whole data set, flattened, which must have that shape. Throws Failure(bad_input) when it is
  /// missing.
  std::vector<double> numbers(const std::string& name,
                              const std::vector<std::uint64_t>& shape) const;
  std::vector<int> integers(const std::string& name, const std::vector<std::uint64_t>& shape) const;

  /// All data sets by name, without those that are only dimensions.
  std::vector<SetInfo> sets() const;

  /// The numbers of a part of a data set, converted to `type`: a box that begins at `first` and has
  /// `count` entries along each dimension. `values` has room for them.
  void part(const std::string& name, const std::vector<std::uint64_t>& first,
            const std::vector<std::uint64_t>& count, NumberType type, void* values) const;

  /// The frames of a data set that grows whose chunks are all there. Where it is less than its first
  /// size, that size cannot be believed.
  std::uint64_t frames_there(const std::string& name) const;

 private:
  template <class T>
  std::vector<T> read(const std::string& name, const std::vector<std::uint64_t>& shape,
                      hid_t type) const;
  [[noreturn]] void fail(const std::string& what) const;
  void open();
  void look_around();

  std::string path_;
  std::string image_;  // of a checkpoint; `file_` is closed before it goes
  bool unfinished_ = false;
  Handle file_;
};

}  // namespace pupflow::io
