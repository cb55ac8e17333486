// The folder of a sweep, and the sweep that it belongs to.
#pragma once

#include <string>

#include "app/study/design.h"

namespace pupflow::study {

/// Makes the folder belong to this design. A new folder, and any with `force`, then holds only the
/// manifest, and the table of a design that is one. Otherwise a folder of the same sweep keeps all
/// its runs, and one whose sweep this one extends (extend.h) those that are finished. Call it with the folder held (lock.h). Throws io::Failure:
/// bad_input, naming the difference, when it holds another sweep and `force` is false; bad_file when
/// it cannot be made or written to, or holds files of the same names without a manifest, or links in
/// their place.
void claim_folder(const std::string& folder, const Design& design, bool force);

/// The design that a folder's manifest holds. Throws io::Failure: bad_file when it cannot be read,
/// bad_input when it is not as this version of the program writes it.
Design design_of_folder(const std::string& folder);

/// The first line in which two manifests differ, as text; of long lines the part that differs.
std::string manifest_difference(const std::string& there, const std::string& now);

}  // namespace pupflow::study
