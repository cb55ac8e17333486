#include "app/io/params_of_file.h"

#include "app/io/checkpoint.h"
#include "app/io/csv.h"
#include "app/io/png.h"
#include "app/io/provenance.h"
#include "app/io/read_file.h"

namespace pupflow::io {

Params params_of_file(const std::string& path) {
  const std::string beginning = read_beginning(path, 8);
  if (beginning == "\x89PNG\r\n\x1a\n") return params_from(read_png_text(path), path);
  if (beginning == "\x89HDF\r\n\x1a\n") return params_from(read_hdf5_text(path), path);
  return params_from(read_csv_header(path), path);
}

}  // namespace pupflow::io
