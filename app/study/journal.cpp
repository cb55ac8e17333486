#include "app/study/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <sstream>
#include <system_error>

#include "app/io/failure.h"
#include "app/io/read_file.h"
#include "app/io/text.h"

namespace pupflow::study {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw io::Failure(io::ExitCode::bad_file,
                    path + ": cannot write: " + std::generic_category().message(error));
}

}  // namespace

Journal::Journal(const std::string& path, const Design& design) : path_(path), design_(design) {
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(path, errno);
  try {
    read();
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

Journal::~Journal() {
  ::close(descriptor_);
}

void Journal::read() {
  const std::string bytes = io::read_file(path_, std::size_t{1} << 34);
  std::size_t good = 0;  // length of the part that is whole
  while (good < bytes.size()) {
    const std::size_t end = bytes.find('\n', good);
    if (end == std::string::npos) break;
    const std::string line = bytes.substr(good, end - good);
    const std::size_t comma = std::min(line.find(','), line.size());
    const auto number = io::read_number<std::int64_t>(std::string_view(line).substr(0, comma));
    const auto run = number ? design_.run_of(*number) : std::nullopt;
    if (!run || *run >= design_.runs() || comma == line.size()) break;
    const auto row = parse_row(design_, *run, line.substr(comma + 1));
    if (!row) break;
    rows_[*run] = *row;
    good = end + 1;
  }
  if (good < bytes.size() && ::ftruncate(descriptor_, static_cast<off_t>(good)) != 0)
    fail(path_, errno);
}

void Journal::add(const Row& row) {
  const std::string line =
      std::to_string(design_.number_of(row.run)) + "," + row_text(design_, row) + "\n";
  const ssize_t written =
      ::write(descriptor_, line.data(), line.size());  // one call: whole, or cut off
  if (written != static_cast<ssize_t>(line.size())) fail(path_, written < 0 ? errno : ENOSPC);
  rows_[row.run] = row;
}

}  // namespace pupflow::study
