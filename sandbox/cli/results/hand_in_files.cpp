#include "cli/results/hand_in_files.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <system_error>

#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

std::optional<WhySkipped> why_skipped(const fs::directory_entry& entry) {
    const std::string name = entry.path().filename().string();
    std::error_code error;
    const fs::file_type type = entry.symlink_status(error).type();
    if (name.starts_with('.')) return WhySkipped::hidden;
    if (type == fs::file_type::symlink) return WhySkipped::link;
    if (type == fs::file_type::directory) return std::nullopt;
    if (type != fs::file_type::regular) return WhySkipped::no_file;
    if (in_lower_case(entry.path().extension().string()) != ".json") return WhySkipped::not_json;
    return std::nullopt;
}

/// Adds the files in a folder. Keeps pending folders in a list, so that deep nesting needs no recursion.
void add_folder(const fs::path& root, HandInFiles& found) {
    const auto first = static_cast<std::ptrdiff_t>(found.files.size());
    const std::size_t troubles = found.troubles.size();
    std::vector<fs::path> waiting{root};
    while (!waiting.empty()) {
        const fs::path folder = std::move(waiting.back());
        waiting.pop_back();
        std::error_code error;
        fs::directory_iterator entry(folder, error);
        for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) {
            std::error_code of_entry;
            if (const std::optional<WhySkipped> why = why_skipped(*entry))
                found.skipped.emplace_back(entry->path(), *why);
            else
                (entry->is_directory(of_entry) ? waiting : found.files).push_back(entry->path());
        }
        if (error) found.troubles.push_back(one_line(folder.string()) + ": cannot be read: " + error.message());
    }
    std::sort(found.files.begin() + first, found.files.end());
    if (std::ssize(found.files) == first && found.troubles.size() == troubles)
        found.troubles.push_back(one_line(root.string()) + ": the folder contains no .json file");
}

}  // namespace

const char* name_of(WhySkipped why) {
    switch (why) {
        case WhySkipped::not_json:
            return "not JSON";
        case WhySkipped::link:
            return "a link";
        case WhySkipped::hidden:
            return "hidden";
        case WhySkipped::no_file:
            return "neither a file nor a folder";
    }
    return "";
}

HandInFiles hand_in_files(const std::vector<std::string>& arguments) {
    HandInFiles found;
    for (const std::string& argument : arguments) {
        std::error_code error;
        if (fs::is_directory(argument, error)) {
            found.has_folders = true;
            add_folder(argument, found);
        } else {
            found.files.emplace_back(argument);
        }
    }
    std::sort(found.skipped.begin(), found.skipped.end());
    std::set<fs::path> known;
    std::erase_if(found.files, [&](const fs::path& file) {
        std::error_code error;
        const fs::path whole = fs::weakly_canonical(file, error);
        return !known.insert(error ? file : whole).second;
    });
    return found;
}

}  // namespace viewing
