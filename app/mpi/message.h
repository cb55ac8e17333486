// The messages between ranks. All ranks run the same executable, so a plain struct is sent as its
// bytes. A task is sent as text, since a schedule has any length.
#pragma once

#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "pupflow/ensemble.h"

namespace pupflow::mpi {

/// The MPI tag of a message: its kind, which says what its bytes hold.
enum class Tag {
  hello,      // from a worker: Hello, then its command line
  refused,    // from a worker, in place of hello: why it cannot take part
  task,       // from the leader: Task
  result,     // from a worker: Result, by pack_result
  failed,     // from a worker: it computes no more; the reason as text
  heartbeat,  // both ways: the sender is alive; no bytes
  stop,       // from the leader: compute no more; no bytes
  stopped,    // from a worker: it has stopped; no bytes
  shutdown    // from the leader, its last message: Shutdown
};

/// A message as it was received.
struct Message {
  int source;  // rank of the sender
  Tag tag;
  std::string bytes;
};

struct Hello {
  int threads;  // that compute on this rank
};

struct Task {
  std::int64_t run, series_every;
  Params params;
};

struct Result {
  std::int64_t run;
  RunResult result;
};

struct Shutdown {
  bool finalize;  // call MPI_Finalize; false if a rank is lost, since MPI_Finalize waits for all
};

template <class T>
std::string pack(const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

/// The struct at the beginning of `bytes`. Throws std::runtime_error if they are too short, as from
/// a rank that runs another version of the program.
template <class T>
T unpack(std::string_view bytes) {
  static_assert(std::is_trivially_copyable_v<T>);
  T value;
  if (bytes.size() < sizeof value) throw std::runtime_error("a message between ranks is too short");
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

/// A task as text, and back. Throws what io::params_from throws, or std::runtime_error.
std::string pack(const Task& task);
Task unpack_task(const std::string& bytes);

/// A result as the bytes of its parts: those of fixed size, then the series.
inline std::string pack_result(const Result& result) {
  const RunResult& r = result.result;
  std::string bytes = pack(result.run) + pack(r.status) + pack(r.means) + pack(r.exposed_sd) +
                      pack(r.warnings) + pack(r.steps) + pack(r.hash);
  for (const Sample& sample : r.series) bytes += pack(sample);
  return bytes;
}

/// Throws like unpack.
inline Result unpack_result(std::string_view bytes) {
  const auto take = [&]<class T>(T& value) {
    value = unpack<T>(bytes);
    bytes.remove_prefix(sizeof value);
  };
  Result result{};
  RunResult& r = result.result;
  take(result.run);
  take(r.status);
  take(r.means);
  take(r.exposed_sd);
  take(r.warnings);
  take(r.steps);
  take(r.hash);
  r.series.reserve(bytes.size() / sizeof(Sample));
  while (!bytes.empty()) take(r.series.emplace_back());
  return result;
}

}  // namespace pupflow::mpi
