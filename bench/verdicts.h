// What was aimed at, what was measured, and whether the one reaches the other.
#pragma once

#include <string>
#include <vector>

namespace pupflow::bench {

class Verdicts {
 public:
  void at_least(const std::string& what, double target, double measured);
  void at_most(const std::string& what, double target, double measured);

  /// The table, in Markdown; nothing when it is empty.
  void print() const;

 private:
  struct Row {
    std::string what;
    double target, measured;
    bool at_least;
  };
  std::vector<Row> rows_;
};

}  // namespace pupflow::bench
