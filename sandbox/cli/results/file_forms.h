// The forms of the files that people write, and their parts of the manual: tables of members, made from the same
// declarations that read the files and give their JSON Schemas.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/manual.h"

namespace viewing {

struct FileForm {
    const char* name;    ///< "lesson"
    const char* format;  ///< "lesson-schema", of `params --format`
    const char* topic;   ///< the topic of the manual that describes such files
    std::string (*schema)();
};

std::span<const FileForm> file_forms();

/// Returns a topic of the manual with the tables of the files that it describes; empty for an unknown name.
std::vector<ManualBlock> manual_page(std::string_view topic);

}  // namespace viewing
