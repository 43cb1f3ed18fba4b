// What the file of a state or scene says about itself, beside its fields.
#pragma once

#include <string>

namespace viewing {

/// Each "" where the file does not have it.
struct Titles {
    std::string schema;     ///< "$schema": where editors find what a state may hold
    std::string title;      ///< a few words
    std::string about;      ///< a sentence
    std::string group;      ///< the headline that it stands below in a list
    std::string mended_by;  ///< of one that breaks the picture: the setting that puts it right
    bool operator==(const Titles&) const = default;
};

}  // namespace viewing
