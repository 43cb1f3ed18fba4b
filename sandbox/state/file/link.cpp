#include "state/file/link.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <vector>

#include "image/deflate.h"
#include "platform/text_file.h"
#include "state/file/reader.h"
#include "text/html.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr const char* broken = "link: it is cut off or damaged";

/// Encodes without the three base64 characters that have a special meaning in URLs: +, / and =.
std::string base64url(const std::vector<std::uint8_t>& bytes) {
    std::string text = base64(bytes);
    text.erase(text.find_last_not_of('=') + 1);
    std::replace(text.begin(), text.end(), '+', '-');
    std::replace(text.begin(), text.end(), '/', '_');
    return text;
}

/// Decodes the output of base64url(); returns none for any other text.
std::optional<std::vector<std::uint8_t>> bytes_of(std::string_view text) {
    std::vector<std::uint8_t> bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char sign : text) {
        const std::size_t digit = digits.find(sign);
        if (digit == std::string_view::npos) return std::nullopt;
        bits = bits << 6U | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<std::uint8_t>(bits >> static_cast<unsigned>(count)));
    }
    const bool has_rest = (bits & ((1U << static_cast<unsigned>(count)) - 1U)) != 0;
    if (count >= 6 || has_rest) return std::nullopt;
    return bytes;
}

Result<std::string> unpacked(const std::vector<std::uint8_t>& bytes) {
    Inflated found = inflated(bytes, max_document_bytes);
    switch (found.end) {
        case InflateEnd::whole:
            return std::move(found.text);
        case InflateEnd::followed:
            return Error{"link: unexpected data after the end of its state"};
        case InflateEnd::too_long:
            return Error{"link: its state is " + longer_than(max_document_bytes)};
        case InflateEnd::damaged:
            break;
    }
    return Error{broken};
}

/// The parts of a link after its #.
struct Parts {
    std::string_view state;  ///< with its version; empty if the link has no state
    std::map<std::string_view, std::string_view> values;
    bool has(std::string_view key) const { return values.contains(key); }
};

constexpr std::array<std::string_view, 3> keys{"preset", "lesson", "step"};
constexpr const char* known_parts = "a state, preset=NAME, or lesson=ID and step=N";

Result<Parts> parts_of(std::string_view fragment) {
    Parts parts;
    for (std::string_view rest = fragment; !rest.empty();) {
        const std::string_view part = rest.substr(0, rest.find('&'));
        rest.remove_prefix(std::min(rest.size(), part.size() + 1));
        const std::size_t sign = part.find('=');
        const std::string_view key = part.substr(0, sign);
        bool is_first = true;
        if (sign == std::string_view::npos && !part.empty() && is_digit(part.front())) {
            is_first = parts.state.empty();
            parts.state = part;
        } else if (sign == std::string_view::npos) {
            return Error{"link: " + one_line(part) + " after the # is neither a state nor KEY=VALUE; use " +
                         known_parts};
        } else if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
            return Error{"link: " + one_line(key) + "=… is unknown; use " + known_parts};
        } else {
            is_first = parts.values.emplace(key, part.substr(sign + 1)).second;
        }
        if (!is_first)
            return Error{"link: a part appears twice after the #; use " + std::string(known_parts) + ", each once"};
    }
    if (!parts.state.empty() + parts.has("preset") + parts.has("lesson") != 1)
        return Error{"link: the # must be followed by one of these: " + std::string(known_parts)};
    if (parts.has("step") && !parts.has("lesson")) return Error{"link: step=N needs lesson=ID"};
    return parts;
}

Result<std::string> state_in(std::string_view text) {
    if (text.front() != '1')
        return Error{"link: its format has version " + std::string(1, text.front()) +
                     ", but this program reads version 1"};
    if (text.size() > max_document_bytes) return Error{"link: " + longer_than(max_document_bytes)};
    const std::optional<std::vector<std::uint8_t>> bytes = bytes_of(text.substr(1));
    if (!bytes) return Error{broken};
    return unpacked(*bytes);
}

bool is_name(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char sign) {
        return std::isalnum(static_cast<unsigned char>(sign)) != 0 || sign == '-' || sign == '_';
    });
}

}  // namespace

std::string link_base() {
    const char* const chosen = std::getenv("VIEWING_SANDBOX_LINK_BASE");
    return chosen && *chosen ? chosen : "viewing-sandbox.html";
}

std::string link_fragment(const Params& params) {
    Params defaults, own = params;
    Json document = Json::object();
    for (const Field& field : fields()) {
        Json value = field_as_json(field, own);
        if (value == field_as_json(field, defaults)) continue;
        std::string pointer = "/" + std::string(field.path);
        std::replace(pointer.begin(), pointer.end(), '.', '/');
        document[Json::json_pointer(pointer)] = std::move(value);
    }
    return "#1" + base64url(deflated(document.dump(-1, ' ', false, Json::error_handler_t::replace)));
}

std::string lesson_fragment(std::string_view id, std::size_t step) {
    return "#lesson=" + std::string(id) + "&step=" + std::to_string(step);
}

bool is_link(std::string_view text) {
    for (const std::string_view start : {"#", "http://", "https://", "file://"})
        if (text.starts_with(start)) return true;
    const std::string_view page = text.substr(0, text.find('#'));
    return page.size() < text.size() && page.ends_with(".html") && page.find_first_of("{\"\r\n") == std::string::npos;
}

Result<Link> read_link(std::string_view text) {
    text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
    const std::size_t sign = text.find('#');
    if (sign == std::string_view::npos) return Error{"link: there is no # followed by a state"};
    const Result<Parts> parts = parts_of(text.substr(sign + 1));
    if (!parts) return Error{parts.error()};
    if (parts->has("preset")) {
        const std::string_view preset = parts->values.at("preset");
        if (!is_name(preset)) return Error{"link: " + one_line(preset) + " is not a preset name"};
        return Link{Link::Kind::preset, std::string(preset)};
    }
    if (parts->has("lesson")) {
        const std::string_view lesson = parts->values.at("lesson");
        const std::string_view step = parts->has("step") ? parts->values.at("step") : "1";
        std::size_t number = 0;
        const bool counts = step.size() < 4 && std::all_of(step.begin(), step.end(), is_digit);
        if (counts) std::from_chars(step.data(), step.data() + step.size(), number);
        if (!is_name(lesson) || number == 0) return Error{"link: it does not name a lesson and a step"};
        return Link{Link::Kind::lesson, std::string(lesson), number};
    }
    Result<std::string> json = state_in(parts->state);
    if (!json) return Error{json.error()};
    return Link{Link::Kind::state, *std::move(json)};
}

}  // namespace viewing
