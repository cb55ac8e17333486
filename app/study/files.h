// The names of a sweep's files in its folder.
#pragma once

#include <string>
#include <vector>

#include "app/study/design.h"

namespace pupflow::study {

std::string runs_path(const std::string& folder);
std::string summary_path(const std::string& folder);
std::string manifest_path(const std::string& folder);
std::string journal_path(const std::string& folder);
std::string table_path(const std::string& folder);  // of a design that is a table

/// The figure: NAME.png and NAME.svg, and the script that draws them, NAME.gp.
std::vector<std::string> picture_paths(const std::string& folder, const Design& design);
std::string script_path(const std::string& folder, const Design& design);

/// The files that are made from the rows of a whole sweep, but for the figure's script.
std::vector<std::string> result_paths(const std::string& folder, const Design& design);

/// Removes a file if it is there. Throws io::Failure(bad_file).
void remove_file(const std::string& path);

}  // namespace pupflow::study
