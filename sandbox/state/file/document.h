// Parses JSON text into a tree and prints a tree as text, with the format's limits and with messages for the user.
// Read reader.h next.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "platform/text_file.h"
#include "text/json.h"
#include "text/result.h"

namespace viewing {

/// Keeps the order of the keys, so that the first mistake in the file is reported first.
using Json = nlohmann::ordered_json;

inline constexpr std::size_t max_document_depth = 64;
inline constexpr std::size_t max_document_values = 1'000'000;
inline constexpr std::size_t max_object_keys = 1'000;

/// Thrown if a text is not JSON at all.
struct SyntaxRefusal : Refusal {
    using Refusal::Refusal;
};

/// Runs a reader and converts its refusal to the result's error.
template <typename Read>
auto guarded(Read read) -> Result<decltype(read())> {
    try {
        return read();
    } catch (const Refusal& refusal) {
        return Error{refusal.what()};
    }
}

/// A place in a document: the prefix of every message, the path so far, and the mistakes if they are collected.
struct Where {
    std::string prefix;  ///< "state.json: " or "--set "
    std::string path;    ///< "projection.near", with each key cut at 20 characters; empty at the root
    std::vector<std::string>* mistakes = nullptr;  ///< nullptr: the first mistake ends the reading

    Where key(std::string_view name) const;
    Where at(std::size_t index) const;
    [[noreturn]] void refuse(const std::string& what) const;
    /// Reads a part that others do not depend on, so that one run can report all mistakes of a file. Returns false if
    /// the part had mistakes, which were collected.
    template <typename Read>
    bool part(const Read& read) const {
        const std::size_t before = mistakes ? mistakes->size() : 0;
        try {
            read();
        } catch (const Refusal& refusal) {
            if (!mistakes) throw;
            if (*refusal.what() != '\0') mistakes->emplace_back(refusal.what());
        }
        return !mistakes || mistakes->size() == before;
    }
    /// Returns the value that `read` returns. If `read` collected mistakes, throws an empty Refusal to end the part().
    template <typename Read>
    auto whole(const Read& read) const {
        const std::size_t before = mistakes ? mistakes->size() : 0;
        auto value = read();
        if (mistakes && mistakes->size() > before) throw Refusal("");
        return value;
    }
};

/// Limits of a document. A report written by this program may be larger than a file written by a user.
struct DocumentLimits {
    std::size_t bytes = max_document_bytes, values = max_document_values;
};

/// Parses a JSON text; `prefix` starts every message. Throws a Refusal if the text is not JSON (naming the line and
/// column), is not UTF-8, repeats a key in one object, is too long or too deep, or has too many values. Skips a byte
/// order mark.
Json parse_document(std::string_view text, const std::string& prefix, const DocumentLimits& limits = {});

/// Prints with two spaces of indentation per level, arrays of plain values on one line, doubles in their shortest exact
/// form, and no newline at the end.
std::string print_document(const Json& document);

/// Describes a value in a few words for "got …": `the string "abc"`, `the number 3`, `an array of length 2`.
std::string describe(const Json& value);

}  // namespace viewing
