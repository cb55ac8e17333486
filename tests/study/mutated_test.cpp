// Journals with damage of every kind: the sweep goes on to the files of an undisturbed one.
#include <gtest/gtest.h>

#include <random>

#include "app/study/files.h"
#include "app/study/journal.h"
#include "app/study/sweep.h"
#include "tests/study/small_design.h"
#include "tests/support/scratch.h"

namespace pupflow::study {
namespace {

using pupflow::test::contents;
using pupflow::test::Scratch;
using Generator = std::mt19937;

std::size_t below(std::size_t limit, Generator& generator) {
  return generator() % std::max<std::size_t>(limit, 1);
}

/// One or a few changes: bits, bytes, pieces that are lost, doubled, swapped or inserted.
std::string mutated(std::string text, Generator& generator) {
  const auto at = [&] { return below(text.size(), generator); };
  for (std::size_t i = 0, changes = 1 + below(3, generator); i < changes && !text.empty(); ++i) {
    const std::size_t place = at(), length = 1 + below(60, generator);
    switch (below(8, generator)) {
      case 0:
        text[place] = static_cast<char>(text[place] ^ (1 << below(8, generator)));
        break;
      case 1:
        text[place] = static_cast<char>(generator());
        break;
      case 2:
        text[place] = static_cast<char>('0' + below(10, generator));
        break;
      case 3:
        text.erase(place, length);
        break;
      case 4:
        text.resize(place);
        break;
      case 5:
        text.insert(at(), text.substr(place, length));
        break;
      case 6:
        std::swap(text[place], text[at()]);
        break;
      default:  // digits for digits, so that lines keep their form
        for (std::size_t c = place; c < std::min(place + length, text.size()); ++c)
          if (text[c] >= '0' && text[c] <= '9')
            text[c] = static_cast<char>('0' + below(10, generator));
    }
  }
  return text;
}

TEST(MutatedJournal, NeverChangesAResult) {
  SweepJob job;
  job.design = test::small_design({"ta=0,1", "beta=0,0.5", "sigma=0,1"}, 1);  // three: no figure
  job.design.base.steps = 25;
  job.quiet = true;
  const Scratch scratch;
  const auto run = [&](const std::string& folder) {
    job.folder = folder;
    run_sweep(job);
    return contents(runs_path(folder)) + contents(summary_path(folder));
  };
  const std::string right = run(scratch.path("undisturbed"));
  std::string journal;
  {
    const auto rows = read_runs(runs_path(job.folder), job.design);
    Journal file(scratch.path("journal.csv"), job.design);
    for (const std::size_t i : {5u, 0u, 3u, 7u, 1u, 2u, 6u}) file.add(rows[i]);
    journal = contents(scratch.path("journal.csv"));
  }
  const std::string folder = scratch.path("s"), manifest = manifest_text(job.design);
  Generator generator(13);
  for (int i = 0; i < 400; ++i) {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directory(folder);
    scratch.file("s/manifest.toml", manifest);
    const std::string changed = mutated(journal, generator);
    scratch.file("s/journal.csv", changed);
    ASSERT_EQ(run(folder), right) << i << "\n" << changed;
  }
}

}  // namespace
}  // namespace pupflow::study
