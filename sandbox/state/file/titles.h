// The entries of a state or scene file that describe the file itself; they are not fields.
#pragma once

#include <string>
#include <vector>

namespace viewing {

/// The titles of a file; a missing one is "".
struct Titles {
    std::string schema;            ///< "$schema": where editors find the schema
    std::string title;             ///< a few words
    std::string about;             ///< a sentence
    std::string group;             ///< the heading above it in a list
    std::string fixed_by;          ///< "mended_by", for a state that breaks the picture: the setting that fixes it
    std::vector<int> slides = {};  ///< the lecture slides to which the file belongs
    bool operator==(const Titles&) const = default;
};

}  // namespace viewing
