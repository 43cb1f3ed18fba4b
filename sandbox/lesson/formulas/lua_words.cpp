#include "lesson/formulas/lua_words.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "text/words.h"

namespace viewing {
namespace {

struct WordOfLua {
    std::string_view word;
    bool is_of_values;
};

constexpr WordOfLua words_of_lua[] = {
    {"and", true},       {"break", false}, {"do", false},    {"else", false}, {"elseif", false}, {"end", false},
    {"false", true},     {"for", false},   {"goto", false},  {"if", false},   {"in", false},     {"local", false},
    {"function", false}, {"nil", true},    {"not", true},    {"or", true},    {"repeat", false}, {"return", false},
    {"then", false},     {"true", true},   {"until", false}, {"while", false}};

const WordOfLua* word_of_lua(std::string_view word) {
    const auto* const at = std::find_if(std::begin(words_of_lua), std::end(words_of_lua),
                                        [&](const auto& one) { return one.word == word; });
    return at == std::end(words_of_lua) ? nullptr : at;
}

constexpr bool starts_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

constexpr bool continues_word(char c) {
    return starts_word(c) || is_digit(c);
}

/// Iterates over the tokens of a source, skipping comments.
class Tokens {
public:
    explicit Tokens(std::string_view source) : source_(source) {}

    /// Returns the next token, "" at the end. For a string, that is only its opening quote or bracket; for a number,
    /// only its first digits and letters.
    std::string_view next() {
        skip_blanks_and_comments();
        const std::size_t begin = at_;
        if (begin == source_.size()) return {};
        const char c = source_[at_];
        if (continues_word(c)) return run([](char one) { return continues_word(one); });
        if (c == '.') return run([](char one) { return one == '.'; });
        if (c == '"' || c == '\'')
            skip_quoted(c);
        else if (!skip_long_bracket())
            ++at_;
        return source_.substr(begin, 1);
    }

private:
    template <typename Belongs>
    std::string_view run(const Belongs& belongs) {
        const std::size_t begin = at_;
        while (at_ < source_.size() && belongs(source_[at_])) ++at_;
        return source_.substr(begin, at_ - begin);
    }

    void skip_quoted(char quote) {
        for (++at_; at_ < source_.size() && source_[at_] != quote; ++at_)
            if (source_[at_] == '\\') ++at_;
        at_ = std::min(at_ + 1, source_.size());
    }

    /// Skips [[…]], [=[…]=] and so on; returns false and skips nothing if none begins here.
    bool skip_long_bracket() {
        if (source_[at_] != '[') return false;
        std::size_t second = at_ + 1;
        while (second < source_.size() && source_[second] == '=') ++second;
        if (second >= source_.size() || source_[second] != '[') return false;
        std::string closing(source_.substr(at_, second + 1 - at_));
        std::replace(closing.begin(), closing.end(), '[', ']');
        const std::size_t end = source_.find(closing, second + 1);
        at_ = end == std::string_view::npos ? source_.size() : end + closing.size();
        return true;
    }

    void skip_blanks_and_comments() {
        constexpr std::string_view blanks = " \t\v\f\r\n", line_ends = "\r\n";
        for (;;) {
            at_ = std::min(source_.find_first_not_of(blanks, at_), source_.size());
            if (source_.substr(at_, 2) != "--") return;
            at_ += 2;
            if (at_ == source_.size() || !skip_long_bracket())
                at_ = std::min(source_.find_first_of(line_ends, at_), source_.size());
        }
    }

    std::string_view source_;
    std::size_t at_ = 0;
};

}  // namespace

std::vector<std::string> words_of_source(std::string_view source) {
    std::vector<std::string> words;
    Tokens tokens(source);
    std::string_view before;
    for (std::string_view token = tokens.next(); !token.empty(); before = token, token = tokens.next())
        if (starts_word(token.front()) && before != ".") words.emplace_back(token);
    return words;
}

bool is_word_of_lua(std::string_view word) {
    return word_of_lua(word) != nullptr;
}

bool is_word_of_values(std::string_view word) {
    const WordOfLua* const found = word_of_lua(word);
    return found && found->is_of_values;
}

bool has_form_of_name(std::string_view word) {
    return !word.empty() && starts_word(word.front()) && std::all_of(word.begin(), word.end(), continues_word);
}

}  // namespace viewing
