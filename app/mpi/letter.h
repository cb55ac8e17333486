// What ranks tell each other. All run the same executable, so structs travel as their bytes.
#pragma once

#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "pupflow/ensemble.h"

namespace pupflow::mpi {

/// The kinds of letters, as MPI tags.
enum class Subject {
  hello,   // worker: Hello, then the text of its job
  task,    // leader: Task
  result,  // worker: Result
  failed,  // worker: why it computes no more, as text
  beat,    // both: I am alive
  home,    // leader: stop
  bye,     // worker: I have stopped
  leave    // leader: its last one, a Leave
};

struct Letter {
  int from;
  Subject subject;
  std::string bytes;
};

struct Hello {
  int threads;
};

struct Task {
  std::int64_t run;
  Params params;
};

struct Result {
  std::int64_t run;
  RunResult result;
};

/// How ranks go: MPI_Finalize waits for all of them, and for ever when one is lost.
struct Leave {
  bool together;
};

template <class T>
std::string pack(const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

/// The struct at the beginning of `bytes`. Throws std::runtime_error when they are too short.
template <class T>
T unpack(const std::string& bytes) {
  static_assert(std::is_trivially_copyable_v<T>);
  T value;
  if (bytes.size() < sizeof value) throw std::runtime_error("a letter between ranks was cut off");
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

}  // namespace pupflow::mpi
