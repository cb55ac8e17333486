// What the fuzz targets share. Each target is a file with one function, one_input: it reads its input
// as the program would read a file or an option, and throws where the invariant at the file's top does
// not hold. replay.cpp feeds it the files of corpus/TARGET and such with changes by chance, libfuzzer.cpp
// what libFuzzer makes of them.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "app/io/failure.h"

namespace pupflow::fuzz {

/// The target's own: takes one input.
void one_input(std::string_view bytes);

/// Throws std::logic_error that says `what` unless `holds`.
void require(bool holds, const std::string& what);

/// Requires that a message has text and is short enough to be read. It may quote what it is about as it
/// is, control characters too: these are replaced where messages are printed.
void require_sound(const std::string& message);

/// Whether `read` refuses, with io::Failure and a sound message.
template <class Read>
bool refuses(const Read& read) {
  try {
    read();
    return false;
  } catch (const io::Failure& failure) {
    require_sound(failure.what());
    return true;
  }
}

/// What `read` makes of something that this program wrote; requires that it is not refused.
template <class Read>
auto read_back(const Read& read) {
  try {
    return read();
  } catch (const io::Failure& failure) {
    throw std::logic_error(std::string("what was written is refused: ") + failure.what());
  }
}

/// The path of a file with these bytes; each call of this process writes the same file. Targets call it,
/// or hdf5_file_of, once for an input.
std::string file_of(std::string_view bytes);

/// How many inputs were written to a file so far.
std::uint64_t input_number();

/// The same of an HDF5 file; where it does not begin with HDF5's signature, the user block with the
/// checksum is put right (user_block.h).
std::string hdf5_file_of(std::string_view bytes, const std::string& kind);

/// A path beside it where there is no file.
std::string no_file();

/// Whether the numbers in `range`, from:to:count or the like, multiply to more than so many: it is then
/// left out, since all that it would take is time.
bool is_long(std::string_view range);

/// Numbers from the bytes of an input; zeros once all are used.
class Source {
 public:
  explicit Source(std::string_view bytes) : rest_(bytes) {}
  bool empty() const { return rest_.empty(); }
  std::uint8_t byte();
  double share();   // 0 ... 1, of two bytes
  double number();  // any double, of eight bytes

 private:
  std::string_view rest_;
};

}  // namespace pupflow::fuzz
