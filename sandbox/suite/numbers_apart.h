// Finds the differences between two trees of numbers, such as newly computed matrices or measurements and the accepted
// ones.
#pragma once

#include <string>
#include <vector>

#include "state/file/document.h"

namespace viewing {

/// One difference, at a path such as "shadow_from_world[0][1]". A value that does not exist in one of the trees is
/// null.
struct NumberChange {
    std::string path;
    Json expected, actual;
};

/// Compares two trees. Numbers may differ by `tolerance`, absolutely or relative to the expected number; strings, null
/// and booleans must be equal. Returns at most `most` differences, in the order of the expected tree, with new values
/// last.
std::vector<NumberChange> numbers_apart(const Json& expected, const Json& actual, double tolerance,
                                        std::size_t most = 500);

}  // namespace viewing
