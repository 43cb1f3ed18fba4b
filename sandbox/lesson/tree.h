// Internal to lesson/: reads the common parts of lesson and exercise files from JSON trees. On an error, every function
// here that reads throws a Refusal with the whole message.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lesson/lesson.h"
#include "state/file/reader.h"

namespace viewing {

/// Collects the mistakes of a file, so that one run can report them all.
class Mistakes {
public:
    /// Reads one part of the file. If the part is refused, keeps the message and returns false.
    template <typename Read>
    bool part(const Read& read) {
        try {
            read();
            return true;
        } catch (const Refusal& refusal) {
            all_.emplace_back(refusal.what());
            return false;
        }
    }
    const std::vector<std::string>& all() const { return all_; }
    /// Throws the first mistake, if there is any.
    void refuse() const {
        if (!all_.empty()) throw Refusal(all_.front());
    }

private:
    std::vector<std::string> all_;
};

bool has(const Json& object, const char* key);

std::vector<std::string> keys_of(const Json& object);

/// Reads a string, or {"en": …, "ko": …}.
LessonText read_text_of(const Json& value, const Where& where);
LessonText text_at(const Json& object, const char* key, const Where& where, bool is_needed);

/// Read a name, which must exist, or a list of names, which is empty if the key is missing.
std::string name_at(const Json& object, const char* key, const Where& where);
std::vector<std::string> names_at(const Json& object, const char* key, const Where& where);

std::vector<std::pair<std::string, LessonText>> read_tags(const Json& object, const Where& where);

inline constexpr std::size_t most_entries = 64;  ///< the maximum number of entries in a list

}  // namespace viewing
