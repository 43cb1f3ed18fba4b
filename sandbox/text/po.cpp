#include "text/po.h"

#include <algorithm>
#include <set>

namespace viewing {

namespace {

Error wrong(int line, const std::string& what) {
    return {"line " + std::to_string(line) + ": " + what};
}

/// Appends the text between two quotes, with its escapes resolved.
Status unquote(std::string_view quoted, int line, std::string& out) {
    if (quoted.size() < 2 || quoted.front() != '"' || quoted.back() != '"') {
        return wrong(line, "a string must be in double quotes on one line");
    }
    quoted = quoted.substr(1, quoted.size() - 2);
    for (std::size_t i = 0; i < quoted.size(); ++i) {
        if (quoted[i] == '"') return wrong(line, "a double quote inside a string must be written \\\"");
        if (quoted[i] != '\\') {
            out += quoted[i];
            continue;
        }
        constexpr std::string_view letters = "n\"\\t", meanings = "\n\"\\\t";
        const std::size_t which = ++i < quoted.size() ? letters.find(quoted[i]) : std::string_view::npos;
        if (which == std::string_view::npos) return wrong(line, "a backslash must be followed by n, t, \\ or \"");
        out += meanings[which];
    }
    return std::monostate{};
}

/// Reads line by line; an entry is complete when the next one begins or the file ends.
class PoReader {
public:
    Status take(std::string_view text, int line) {
        if (text.empty()) return finish(line);
        if (text.front() == '#') {
            if (part_ == Part::translation) {
                if (Status done = finish(line); !done) return done;
            }
            if (text.starts_with("#: ")) next_where_ += (next_where_.empty() ? "" : " ") + std::string(text.substr(3));
            next_is_fuzzy_ |= text.starts_with("#,") && text.find("fuzzy") != std::string_view::npos;
            return std::monostate{};
        }
        if (text.front() == '"') return more(text, line);
        const std::string_view keyword = text.substr(0, text.find(' '));
        const std::string_view rest = keyword.size() < text.size() ? text.substr(keyword.size() + 1) : "";
        if (keyword == "msgid") {
            if (Status done = finish(line); !done) return done;
            entry_ = {"", "", std::exchange(next_is_fuzzy_, false), line, std::exchange(next_where_, {})};
            part_ = Part::id;
            return unquote(rest, line, entry_.english);
        }
        if (keyword == "msgstr") {
            if (part_ != Part::id) return wrong(line, "a msgstr must follow a msgid");
            part_ = Part::translation;
            return unquote(rest, line, entry_.translation);
        }
        return wrong(line, "a line must begin with msgid, msgstr, # or a double quote, not with \"" +
                               std::string(keyword) + "\"");
    }

    Status finish(int line) {
        if (part_ == Part::id) return wrong(line, "a msgstr is missing before this line");
        if (std::exchange(part_, Part::none) == Part::none) return std::monostate{};
        if (!ids_.insert(entry_.english).second) {
            return wrong(entry_.line, "\"" + entry_.english + "\" appears twice");
        }
        if (!entry_.english.empty()) entries_.push_back(entry_);
        return std::monostate{};
    }

    std::vector<PoEntry> entries() && { return std::move(entries_); }

private:
    enum class Part { none, id, translation };

    Status more(std::string_view text, int line) {
        if (part_ == Part::none) return wrong(line, "a string must follow a msgid or a msgstr");
        return unquote(text, line, part_ == Part::id ? entry_.english : entry_.translation);
    }

    Part part_ = Part::none;
    bool next_is_fuzzy_ = false;
    std::string next_where_;
    PoEntry entry_;
    std::set<std::string> ids_;
    std::vector<PoEntry> entries_;
};

}  // namespace

Result<std::vector<PoEntry>> read_po(std::string_view content) {
    PoReader reader;
    int line = 0;
    while (!content.empty()) {
        ++line;
        std::string_view text = content.substr(0, content.find('\n'));
        content.remove_prefix(std::min(content.size(), text.size() + 1));
        while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
        if (const Status done = reader.take(text, line); !done) return Error{done.error()};
    }
    if (const Status done = reader.finish(line); !done) return Error{done.error()};
    return std::move(reader).entries();
}

Result<std::vector<std::string>> places_in(std::string_view text) {
    std::set<std::string> places;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_doubled = i + 1 < text.size() && text[i + 1] == text[i];
        if (text[i] == '}' && !is_doubled) return Error{"a } without a {"};
        if (text[i] == '}' || (text[i] == '{' && is_doubled)) {
            ++i;
        } else if (text[i] == '{') {
            const std::size_t end = text.find('}', i);
            if (end == std::string_view::npos) return Error{"a { without a }"};
            places.emplace(text.substr(i + 1, end - i - 1));
            i = end;
        }
    }
    return std::vector<std::string>(places.begin(), places.end());
}

}  // namespace viewing
