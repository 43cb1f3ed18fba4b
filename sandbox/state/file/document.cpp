#include "state/file/document.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "text/numbers.h"
#include "text/words.h"

namespace viewing {

namespace {

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// Returns the word or character at which the parser failed, in printable form.
std::string word_at(std::string_view text, std::size_t offset) {
    const auto in_word = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+' || c == '.';
    };
    std::size_t begin = offset;
    while (begin > 0 && in_word(text[begin]) && in_word(text[begin - 1])) {
        --begin;
    }
    std::size_t end = offset + 1;
    while (end < text.size() && continues_character(text[end])) {
        ++end;
    }
    while (end < text.size() && in_word(text[end]) && in_word(text[end - 1])) {
        ++end;
    }
    return excerpt(text.substr(begin, end - begin));
}

/// Explains in our own words why a text is not JSON; `reason` is the library's message.
std::string syntax_complaint(std::string_view text, std::size_t offset, std::string_view reason) {
    if (contains(reason, "UTF-8")) {
        return "the text is not valid UTF-8";
    }
    if (contains(reason, "missing closing quote")) {
        return "a string has no closing quote";
    }
    if (contains(reason, "control character")) {
        return "a string contains a control character; write it as \\n, \\t or \\u0000";
    }
    if (offset >= text.size()) {
        return "the document ends too early";
    }
    const std::string word = word_at(text, offset);
    if (word == "/") {
        return "comments are not allowed in JSON";
    }
    if (contains(reason, "expected end of input")) {
        return "unexpected text after the end of the document: " + word;
    }
    std::string letters;
    for (const char c : word) {
        if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
            letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
    }
    if (letters == "nan" || letters == "inf" || letters == "infinity") {
        return "NaN and infinity are not allowed";
    }
    return "unexpected " + word;
}

/// Builds the tree from the parser's events and refuses everything that the format forbids.
class Builder : public nlohmann::json_sax<Json> {
public:
    Builder(std::string_view text, const std::string& prefix, std::size_t most_values)
        : text_(text), here_{prefix, ""}, most_values_(most_values) {}

    Json take() { return std::move(root_); }

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(std::int64_t value) override { return add(value); }
    bool number_unsigned(std::uint64_t value) override { return add(value); }
    bool number_float(double value, const std::string&) override { return add(value); }
    bool string(std::string& value) override { return add(std::move(value)); }
    bool binary(Json::binary_t&) override { return false; }

    bool start_object(std::size_t) override { return open(Json::object()); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_array() override { return close(); }

    bool key(std::string& name) override {
        const Json& object = *open_.back();
        if (object.contains(name)) {
            place().key(name).refuse("appears twice");
        }
        if (object.size() == max_object_keys) {
            place().refuse("more than " + std::to_string(max_object_keys) + " fields in one object");
        }
        key_ = name;
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::detail::exception& error) override {
        constexpr int number_overflow = 406;
        if (error.id == number_overflow) {
            next_place().refuse("the number " + excerpt(token) + " is too large");
        }
        const std::size_t offset = std::min(position == 0 ? 0 : position - 1, text_.size());
        const std::string_view before = text_.substr(0, offset);
        const auto line = 1 + std::count(before.begin(), before.end(), '\n');
        const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
        throw SyntaxRefusal(here_.prefix + "line " + std::to_string(line) + ", column " +
                            std::to_string(offset - line_start + 1) +
                            ": not JSON: " + syntax_complaint(text_, offset, error.what()));
    }

private:
    /// Returns the path of the innermost open container.
    Where place() const {
        Where where = here_;
        for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
            const Json& container = *open_[i];
            where = container.is_array() ? where.at(container.size() - 1) : where.key(last_key(container));
        }
        return where;
    }

    static const std::string& last_key(const Json& object) { return std::prev(object.end()).key(); }

    /// Returns the path of the next value.
    Where next_place() const {
        if (open_.empty()) {
            return here_;
        }
        return open_.back()->is_array() ? place().at(open_.back()->size()) : place().key(key_);
    }

    Json* put(Json value) {
        if (++values_ > most_values_) {
            constexpr std::size_t million = 1'000'000;
            here_.refuse("more than " +
                         (most_values_ == million ? "a million" : std::to_string(most_values_ / million) + " million") +
                         " values");
        }
        if (open_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        Json& container = *open_.back();
        if (container.is_array()) {
            container.push_back(std::move(value));
            return &container.back();
        }
        return &(container[key_] = std::move(value));
    }

    bool add(Json value) {
        put(std::move(value));
        return true;
    }

    bool open(Json container) {
        if (open_.size() == max_document_depth) {
            here_.refuse("nested deeper than " + std::to_string(max_document_depth) + " levels");
        }
        open_.push_back(put(std::move(container)));
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    std::string_view text_;
    Where here_;
    Json root_;
    std::vector<Json*> open_;  ///< the containers that are still open, outermost first
    std::string key_;
    std::size_t values_ = 0;
    const std::size_t most_values_;
};

bool is_plain(const Json& value) {
    return value.is_primitive();
}

void print(const Json& value, std::size_t level, std::string& out) {
    const auto indent = [&out](std::size_t levels) { out.append("\n").append(2 * levels, ' '); };
    if (value.is_number_float()) {
        out += format_number(value.get<double>());
    } else if (value.is_string()) {
        out += value.dump(-1, ' ', false, Json::error_handler_t::replace);
    } else if (value.is_primitive() || value.empty()) {
        out += value.dump();
    } else if (value.is_array()) {
        const bool one_line = std::all_of(value.begin(), value.end(), is_plain);
        out += '[';
        for (std::size_t i = 0; i < value.size(); ++i) {
            out += i == 0 ? "" : one_line ? ", " : ",";
            if (!one_line) {
                indent(level + 1);
            }
            print(value[i], level + 1, out);
        }
        if (!one_line) {
            indent(level);
        }
        out += ']';
    } else {
        const char* separator = "{";
        for (const auto& [key, member] : value.items()) {
            out += separator;
            separator = ",";
            indent(level + 1);
            out += Json(key).dump() + ": ";
            print(member, level + 1, out);
        }
        indent(level);
        out += '}';
    }
}

}  // namespace

Where Where::key(std::string_view name) const {
    return {prefix, path.empty() ? excerpt(name) : path + "." + excerpt(name), mistakes};
}

Where Where::at(std::size_t index) const {
    return {prefix, path + "[" + std::to_string(index) + "]", mistakes};
}

void Where::refuse(const std::string& what) const {
    throw Refusal(prefix + (path.empty() ? "" : one_line(path) + ": ") + what);
}

Json parse_document(std::string_view text, const std::string& prefix, const DocumentLimits& limits) {
    if (text.size() > limits.bytes) {
        throw Refusal(prefix + longer_than(limits.bytes));
    }
    Builder builder(text, prefix, limits.values);
    Json::sax_parse(text.begin(), text.end(), &builder);
    // The parser stops at a NUL and ignores the rest. It has already refused a NUL inside a string.
    if (text.find('\0') != std::string_view::npos)
        throw SyntaxRefusal(prefix + "not JSON: unexpected text after the end of the document: a NUL");
    return builder.take();
}

std::string print_document(const Json& document) {
    std::string out;
    print(document, 0, out);
    return out;
}

std::string describe(const Json& value) {
    switch (value.type()) {
        case Json::value_t::string:
            return "the string \"" + excerpt(value.get_ref<const std::string&>()) + "\"";
        case Json::value_t::array:
            return "an array of length " + std::to_string(value.size());
        case Json::value_t::object:
            return "an object";
        case Json::value_t::number_float:
            return "the number " + format_number(value.get<double>());
        case Json::value_t::number_integer:
        case Json::value_t::number_unsigned:
            return "the number " + value.dump();
        default:
            return value.dump();
    }
}

}  // namespace viewing
