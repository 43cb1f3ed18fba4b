// Where two trees of numbers differ: matrices and measures against those that were accepted.
#pragma once

#include <string>
#include <vector>

#include "state/file/document.h"

namespace viewing {

/// One place: "shadow_from_world[0][1]". Null where one of them has nothing there.
struct NumberChange {
    std::string path;
    Json expected, actual;
};

/// Numbers may be off by `tolerance`, absolutely or as a share of the expected one; texts, null and truth values must
/// be equal. At most `most` places are told, in the order of the expected tree, what is new last.
std::vector<NumberChange> numbers_apart(const Json& expected, const Json& actual, double tolerance,
                                        std::size_t most = 500);

}  // namespace viewing
