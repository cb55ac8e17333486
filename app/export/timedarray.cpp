// Brian2: the arguments of a TimedArray in an .npz, which is a zip file of .npy files.
#include <zlib.h>

#include <cmath>
#include <cstring>

#include "app/export/array_file.h"
#include "app/export/export.h"
#include "app/export/field_stream.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/text.h"

namespace pupflow::exporting {
namespace {

constexpr std::uint64_t kMostBytes = 0xFFFFFFFF;  // of a zip file without its 64-bit extensions

/// A zip file being written, its entries stored as they are.
class ZipFile {
 public:
  ZipFile(const std::string& path, bool force) : file_(path, force) {}

  /// Begins an entry; `bytes` of it will follow.
  void begin(const std::string& name, std::uint64_t bytes) {
    entry_ = {name, static_cast<std::uint32_t>(bytes), 0, position_};
    // Checksum and sizes follow the data (flag 8).
    add(number(0x04034b50, 4) + number(20, 2) + number(8, 2) + number(0, 2) + kTime +
        number(0, 12) + number(name.size(), 2) + number(0, 2) + name);
  }

  void write(std::string_view bytes) {
    entry_.checksum = static_cast<std::uint32_t>(crc32(entry_.checksum,
                                                       reinterpret_cast<const Bytef*>(bytes.data()),
                                                       static_cast<uInt>(bytes.size())));
    add(bytes);
  }

  void end() {
    add(number(0x08074b50, 4) + sums(entry_));
    directory_ += number(0x02014b50, 4) + number(20, 2) + number(20, 2) + number(8, 2) +
                  number(0, 2) + kTime + sums(entry_) + number(entry_.name.size(), 2) +
                  number(0, 12) + number(entry_.begin, 4) + entry_.name;
    ++entries_;
  }

  void commit() {
    const std::uint64_t begin = position_;
    add(directory_);
    add(number(0x06054b50, 4) + number(0, 4) + number(entries_, 2) + number(entries_, 2) +
        number(directory_.size(), 4) + number(begin, 4) + number(0, 2));
    file_.commit();
  }

 private:
  struct Entry {
    std::string name;
    std::uint32_t bytes = 0, checksum = 0;
    std::uint64_t begin = 0;
  };

  /// Little-endian.
  static std::string number(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(i < 8 ? value >> (8 * i) & 0xFF : 0);
    return text;
  }
  static std::string sums(const Entry& entry) {
    return number(entry.checksum, 4) + number(entry.bytes, 4) + number(entry.bytes, 4);
  }
  void add(std::string_view bytes) {
    file_.write(bytes);
    position_ += bytes.size();
  }

  // Midnight of 1980-01-01, the first date there is: the same recording gives the same bytes.
  inline static const std::string kTime = number(0x00210000, 4);

  io::AtomicFile file_;
  Entry entry_;
  std::string directory_;
  std::uint64_t position_ = 0, entries_ = 0;
};

/// The time between frames, which a TimedArray holds once for all.
double frame_interval(const io::RecordedRun& recording) {
  const std::vector<double>& times = recording.times();
  if (times.size() < 2) return recording.params().dt;
  const double interval = times[1] - times[0];
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double rounding = 1e-9 * (interval + std::abs(times[i]));
    if (std::abs(times[i] - times[i - 1] - interval) > rounding) {
      io::refuse(recording.path() + ": frames " + std::to_string(i - 1) + " and " +
                 std::to_string(i) + " are further apart or nearer than the first two; a " +
                 "TimedArray has one dt");
    }
  }
  return interval;
}

void add_number(ZipFile& zip, const std::string& name, double value) {
  const std::string header = npy_header(npy_type(io::NumberType::f8), {});
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  zip.begin(name + ".npy", header.size() + sizeof value);
  zip.write(header);
  zip.write({bytes, sizeof value});
  zip.end();
}

/// What made the recording, as text.
void add_about(ZipFile& zip, const io::RecordedRun& recording) {
  const std::string text = io::joined(recording.about(), "\n", [](const auto& entry) {
    return entry.first + " = " + entry.second;
  });
  const std::string header = npy_header("|S" + std::to_string(text.size()), {});
  zip.begin("about.npy", header.size() + text.size());
  zip.write(header);
  zip.write(text);
  zip.end();
}

}  // namespace

void write_timedarray(const io::RecordedRun& recording, const Request& request,
                      io::Progress& progress) {
  const FieldStream stream(recording, request, {"temperature", "tb"}, request.sheet);
  const double interval = frame_interval(recording);
  const std::vector<std::size_t> shape{recording.frames(), stream.size()};
  const std::string header = npy_header(npy_type(io::NumberType::f8), shape);
  const std::uint64_t bytes = header.size() + sizeof(double) * shape[0] * shape[1];
  if (bytes > kMostBytes - (1 << 20)) {
    io::refuse(recording.path() + ": is too long for an .npz of " + stream.field().name +
               "; choose a pup with --pup, or record fewer frames");
  }
  ZipFile zip(request.out, request.force);
  add_number(zip, "dt", interval);
  add_number(zip, "start", recording.times().front());
  add_about(zip, recording);
  zip.begin("values.npy", bytes);
  zip.write(header);
  stream.for_each_frame(io::NumberType::f8, progress,
                        [&](std::size_t, std::span<const std::byte> row) {
                          zip.write({reinterpret_cast<const char*>(row.data()), row.size()});
                        });
  zip.end();
  zip.commit();
}

}  // namespace pupflow::exporting
