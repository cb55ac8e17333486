// HDF5 files changed as only somebody else would change them.
#pragma once

#include <hdf5.h>

#include <functional>
#include <string>

#include "app/io/hdf5_file.h"
#include "app/io/user_block.h"
#include "tests/support/scratch.h"

namespace pupflow::test {

/// Opens `path`, a file of that kind, for `change`, then gives it a checksum that fits.
inline void edit_hdf5(const std::string& path, const std::string& kind,
                      const std::function<void(hid_t)>& change) {
  {
    const io::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    change(file);
  }
  const std::string block = io::block_text(io::block_of(kind, path));
  std::string bytes = contents(path);
  std::ofstream(path, std::ios::binary) << bytes.replace(0, block.size(), block);
}

}  // namespace pupflow::test
