// A design as a table of runs: --design FILE.csv.
#pragma once

#include <string>

#include "app/study/design.h"

namespace pupflow::study {

/// Reads a CSV text whose header names parameters and whose rows are the points. A column `seed`
/// gives the seed of each row; then a row is one run. Comment lines (#), empty lines, blanks around
/// cells and quotes around them are allowed. Values that no column gives are those of design.base.
/// Throws io::Failure(bad_input) with all problems, a line each, as "where:line:column: ...".
void parse_table(const std::string& text, const std::string& where, Design& design);

/// The same of a file ("-" is standard input). Also throws io::Failure(bad_file).
void read_table(const std::string& path, Design& design);

/// The table of a design, read back to the same design: numbers in their shortest form, `seed` last.
std::string table_text(const Design& design);

/// 16 hexadecimal digits that tell tables apart (FNV-1a of table_text).
std::string table_hash(const Design& design);

}  // namespace pupflow::study
