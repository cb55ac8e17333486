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
std::string table_path(const std::string& folder);     // of a design that is a table
std::string series_folder(const std::string& folder);  // of the series of its runs

/// The figure: NAME.png and NAME.svg, and the script that draws them, NAME.gp.
std::vector<std::string> picture_paths(const std::string& folder, const Design& design);
std::string script_path(const std::string& folder, const Design& design);

/// The files that are made from the rows of a whole sweep, but for the figure's script.
std::vector<std::string> result_paths(const std::string& folder, const Design& design);

/// The file by which one process at a time holds the folder (lock.h).
std::string lock_path(const std::string& folder);

/// Makes the folder, and those that it is in. Throws io::Failure(bad_file).
void make_folder(const std::string& folder);

/// Throws io::Failure(bad_file) where something is at `path` that is no regular file. The folder may
/// come from anybody, so nothing is written through a link that lies in it.
void refuse_no_file(const std::string& path);

/// The same for every file that a sweep writes into its folder, and for the folder of its series.
void refuse_links(const std::string& folder, const Design& design);

/// Removes a file if it is there. Throws io::Failure(bad_file).
void remove_file(const std::string& path);

/// Removes what killed processes left unfinished of a sweep's files, and of their drawings.
void remove_leftovers(const std::string& folder, const Design& design);

}  // namespace pupflow::study
