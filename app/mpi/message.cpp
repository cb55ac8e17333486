#include "app/mpi/message.h"

#include "app/io/provenance.h"
#include "app/io/text.h"

namespace pupflow::mpi {

std::string pack(const Task& task) {
  std::string text = std::to_string(task.run) + "\n" + std::to_string(task.series_every);
  for (const auto& [name, value] : io::provenance(task.params)) {
    text.append("\n").append(name).append("\n").append(value);
  }
  return text;
}

Task unpack_task(const std::string& bytes) {
  const std::vector<std::string_view> lines = io::split(bytes, '\n');
  const auto run = io::read_number<std::int64_t>(lines.front());
  const auto series = lines.size() > 1 ? io::read_number<std::int64_t>(lines[1]) : std::nullopt;
  if (!run || !series || lines.size() % 2 != 0) {
    throw std::runtime_error("a task between ranks is no task");
  }
  io::TextEntries entries;
  for (std::size_t i = 2; i < lines.size(); i += 2) entries.emplace_back(lines[i], lines[i + 1]);
  return {*run, *series, io::params_from(entries, "a task between ranks")};
}

}  // namespace pupflow::mpi
