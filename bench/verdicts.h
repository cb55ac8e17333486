// What was aimed at, what was measured, and whether the one reaches the other.
#pragma once

#include <map>
#include <string>

namespace pupflow::bench {

class Verdicts {
 public:
  /// `what` is a row of the table of aims in verdicts.cpp. Throws std::logic_error for any other.
  void measured(const std::string& what, double value);

  /// The rows that were measured, in Markdown and in the order of the table; nothing without any.
  void print() const;

 private:
  std::map<std::string, double> measured_;
};

}  // namespace pupflow::bench
