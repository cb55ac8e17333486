#include "app/mpi/message.h"

#include "app/io/provenance.h"
#include "app/io/text.h"

namespace pupflow::mpi {

std::string pack(const Task& task) {
  std::string text = std::to_string(task.run);
  for (const auto& [name, value] : io::provenance(task.params)) {
    text.append("\n").append(name).append("\n").append(value);
  }
  return text;
}

Task unpack_task(const std::string& bytes) {
  const std::vector<std::string_view> lines = io::split(bytes, '\n');
  const auto run = io::read_number<std::int64_t>(lines.front());
  if (!run || lines.size() % 2 != 1) throw std::runtime_error("a task between ranks is no task");
  io::TextEntries entries;
  for (std::size_t i = 1; i < lines.size(); i += 2) entries.emplace_back(lines[i], lines[i + 1]);
  return {*run, io::params_from(entries, "a task between ranks")};
}

}  // namespace pupflow::mpi
