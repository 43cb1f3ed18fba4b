// Internal to state/: JSON text as a tree and back, with the limits and the messages of the contract.
// Only .cpp files include this: the JSON library's header is slow. Read reader.h next.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "platform/text_file.h"
#include "text/result.h"

namespace viewing {

/// Keeps the order of the keys, so that what is wrong first is told first.
using Json = nlohmann::ordered_json;

inline constexpr std::size_t max_document_depth = 64;
inline constexpr std::size_t max_document_values = 1'000'000;
inline constexpr std::size_t max_object_keys = 1'000;

/// Bad input, with the whole sentence for a person. Thrown inside the readers and caught at their edge, by guarded().
struct Refusal : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The text is not JSON at all.
struct SyntaxRefusal : Refusal {
    using Refusal::Refusal;
};

/// Runs a reader; what it refuses becomes the result's error.
template <typename Read>
auto guarded(Read read) -> Result<decltype(read())> {
    try {
        return read();
    } catch (const Refusal& refusal) {
        return Error{refusal.what()};
    }
}

/// A place in a document: what every message opens with, and the path so far.
struct Where {
    std::string prefix;  ///< "state.json: " or "--set "
    std::string path;    ///< "projection.near", keys cut at 20 characters; empty at the root

    Where key(std::string_view name) const;
    Where at(std::size_t index) const;
    [[noreturn]] void refuse(const std::string& what) const;
};

/// What a document may hold. A report that this program wrote itself may be larger than what people write.
struct DocumentLimits {
    std::size_t bytes = max_document_bytes, values = max_document_values;
};

/// Parses a JSON text whose messages open with `prefix`. Throws Refusal: not JSON (with line and column), not UTF-8, a
/// key twice in one object, too long, too deep, too many values. A byte order mark at the beginning is skipped.
Json parse_document(std::string_view text, const std::string& prefix, const DocumentLimits& limits = {});

/// Two spaces a level, arrays of plain values on one line, doubles in their shortest exact form; ends without a
/// newline.
std::string print_document(const Json& document);

/// What a value is, in a few words for "got …": `the text "abc"`, `the number 3`, `an array of 2`.
std::string describe(const Json& value);

}  // namespace viewing
