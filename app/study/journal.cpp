#include "app/study/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "app/io/atomic_file.h"
#include "app/io/checksum.h"
#include "app/io/failure.h"
#include "app/io/read_file.h"
#include "app/io/text.h"
#include "app/study/files.h"

namespace pupflow::study {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw io::Failure(io::ExitCode::bad_file,
                    path + ": cannot write: " + std::generic_category().message(error));
}

/// A number for everything that the rows depend on, the same when seeds or series are added.
std::uint64_t seed_of(Design design) {
  design.seeds = design.seed_block;
  design.record_every = 0;
  return io::checksum(manifest_text(design));
}

}  // namespace

Journal::Journal(const std::string& path, const Design& design)
    : path_(path), design_(design), seed_(seed_of(design)) {
  refuse_no_file(path);
  if (std::filesystem::exists(path)) read();
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(path, errno);
}

Journal::~Journal() {
  ::close(descriptor_);
}

void Journal::read() {
  const std::string bytes = io::read_file(path_, largest_file(design_));
  std::string good;
  std::size_t begin = 0;
  for (std::size_t end; (end = bytes.find('\n', begin)) != std::string::npos; begin = end + 1) {
    if (take(std::string_view(bytes).substr(begin, end - begin))) {
      good.append(bytes, begin, end + 1 - begin);
    } else {
      ++damaged_;
    }
  }
  if (good.size() == bytes.size()) return;
  io::AtomicFile file(path_, true);
  file.write(good);
  file.commit();
}

bool Journal::take(std::string_view line) {
  const std::size_t comma = line.find(','), last = line.rfind(',');
  if (last == comma) return false;  // none, or one
  const auto number = io::read_number<std::int64_t>(line.substr(0, comma));
  const auto run = number ? design_.run_of(*number) : std::nullopt;
  if (!run) return false;
  const auto row = parse_row(design_, *run, std::string(line.substr(comma + 1, last - comma - 1)));
  if (!row || line_of(*row) != line) return false;
  rows_[*run] = *row;
  return true;
}

std::string Journal::line_of(const Row& row) const {
  const std::string text =
      std::to_string(design_.number_of(row.run)) + "," + row_text(design_, row);
  return text + "," + io::hash_text(io::checksum(text, seed_));
}

void Journal::add(const Row& row) {
  const std::string line = line_of(row) + "\n";
  for (std::string_view rest = line; !rest.empty();) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno != EINTR) fail(path_, errno);
    if (written > 0) rest.remove_prefix(static_cast<std::size_t>(written));
  }
  rows_[row.run] = row;
}

}  // namespace pupflow::study
