// Arrays in numpy's .npy format (version 1.0).
#pragma once

#include <string>
#include <vector>

#include "app/io/data_set.h"

namespace pupflow::exporting {

/// What stands before the numbers of an array in C order. `type` is numpy's word for them, such as
/// "<f8".
std::string npy_header(const std::string& type, const std::vector<std::size_t>& shape);

/// numpy's word for numbers of this machine.
std::string npy_type(io::NumberType type);

}  // namespace pupflow::exporting
