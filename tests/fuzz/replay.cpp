// Feeds files to a fuzz target: each one that is named, and all in each folder that is. With --mutate
// also COUNT inputs made from them, from number FIRST on (mutate.h). Prints what is wrong and ends
// with 1 at the first input that breaks the target's invariant; --write keeps that input.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "app/io/text.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/mutate.h"
#include "tests/support/scratch.h"

namespace {

namespace fs = std::filesystem;
using pupflow::io::read_number;

struct Work {
  std::vector<fs::path> files;
  std::uint64_t first = 0, count = 0;
  std::string kept;  // where the input goes that is being read; nowhere when empty
};

void add(const fs::path& path, Work& work) {
  if (!fs::is_directory(path)) return work.files.push_back(path);
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) add(entry, work);
}

/// Throws std::invalid_argument for options that it does not know.
Work work_of(int argc, char** argv) {
  Work work;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--mutate" && i + 2 < argc) {
      const auto first = read_number<std::uint64_t>(argv[++i]);
      const auto count = read_number<std::uint64_t>(argv[++i]);
      if (!first || !count) throw std::invalid_argument("--mutate takes FIRST and COUNT");
      work.first = *first, work.count = *count;
    } else if (word == "--write" && i + 1 < argc) {
      work.kept = argv[++i];
    } else if (word.starts_with("--")) {
      throw std::invalid_argument("usage: [--mutate FIRST COUNT] [--write FILE] FILE|FOLDER...");
    } else {
      add(word, work);
    }
  }
  std::sort(work.files.begin(), work.files.end());  // folders have no order
  if (work.files.empty()) throw std::invalid_argument("there are no inputs");
  return work;
}

/// The input that a crash is about.
char current[4096];

extern "C" void tell(int signal) {
  const std::string_view name = current;
  static_cast<void>(!::write(STDERR_FILENO, name.data(), name.size()));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void feed(const Work& work, const std::string& name, const std::string& bytes) {
  std::snprintf(current, sizeof current, "%s\n", name.c_str());
  if (!work.kept.empty()) std::ofstream(work.kept, std::ios::binary) << bytes;
  try {
    pupflow::fuzz::one_input(bytes);
  } catch (const std::exception& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

void feed_all(const Work& work) {
  std::vector<std::string> seeds;
  for (const fs::path& file : work.files) {
    seeds.push_back(pupflow::test::contents(file.string()));
    feed(work, file.string(), seeds.back());
  }
  for (std::uint64_t i = work.first; i < work.first + work.count; ++i) {
    feed(work, "--mutate " + std::to_string(i) + " 1", pupflow::fuzz::mutated(seeds, i));
  }
}

}  // namespace

int main(int argc, char** argv) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, tell);
  // What the program notes on standard error would fill it.
  if (std::FILE* const nowhere = std::fopen("/dev/null", "w")) stderr = nowhere;
  try {
    const Work work = work_of(argc, argv);
    feed_all(work);
    std::printf("%zu inputs\n", work.files.size() + static_cast<std::size_t>(work.count));
  } catch (const std::exception& error) {
    ::dprintf(STDERR_FILENO, "%s\n", error.what());
    return 1;
  }
  return 0;
}
