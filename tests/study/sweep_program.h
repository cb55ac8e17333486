// Sweeps that take milliseconds, run by the real executable.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "tests/app/program.h"
#include "tests/support/scratch.h"

namespace pupflow::study::test {

using pupflow::test::contents;
using pupflow::test::Outcome;
using pupflow::test::Running;
using pupflow::test::Scratch;
using Words = std::vector<std::string>;

/// `verb` for three pups of 54 points and 60 steps, with more words behind.
inline Words small(const std::string& verb, const Words& more) {
  Words words{verb,    "--set",    "pups=3", "--set",     "face_points=3",
              "--set", "steps=60", "--set",  "discard=20"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Every file of a folder and of those in it, by its path there, with its bytes.
inline std::map<std::string, std::string> files_of(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files[std::filesystem::relative(entry.path(), folder).string()] =
        contents(entry.path().string());
  }
  return files;
}

inline Words names_of(const std::string& folder) {
  Words names;
  for (const auto& [name, bytes] : files_of(folder)) names.push_back(name);
  return names;
}

/// The lines of a CSV behind its comments and column names, in cells.
inline std::vector<Words> rows_of(const std::string& path) {
  std::vector<Words> rows;
  std::istringstream lines(contents(path));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  rows.erase(rows.begin());
  return rows;
}

/// A folder in which the program runs.
class SweepProgram : public ::testing::Test {
 protected:
  Outcome pupflow(const Words& words) const {
    return pupflow::test::run_program(PUPFLOW_PROGRAM, words, scratch_.folder().string());
  }

  /// The same, behind some words of a shell: "ulimit -f 1; exec".
  Outcome pupflow_behind(const std::string& shell, const Words& words) const {
    Words all{"-c", shell + " \"$0\" \"$@\"", PUPFLOW_PROGRAM};
    all.insert(all.end(), words.begin(), words.end());
    return pupflow::test::run_program("/bin/sh", all, scratch_.folder().string());
  }

  /// Runs what must end with `code`, and returns its standard error.
  std::string expect(int code, const Words& words) const {
    const Outcome outcome = pupflow(words);
    EXPECT_EQ(outcome.code, code) << outcome.err << outcome.out;
    return outcome.err;
  }

  std::string path(const std::string& name) const { return scratch_.path(name); }

  const Scratch scratch_;
};

}  // namespace pupflow::study::test
