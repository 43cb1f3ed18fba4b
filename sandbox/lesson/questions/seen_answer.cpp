#include "lesson/questions/seen_answer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>

#include "lesson/questions/question_kind.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

/// A number or an item, as the window shows it.
struct Token {
    std::string text;
    std::string place;
    double value = 0.0;
    int decimals = 0, significant = 0;
    float left_px = 0.0F, right_px = 0.0F, baseline_px = 0.0F, em_px = 0.0F;
};

constexpr std::string_view minus = "−";

/// Returns the numbers in a text, except digits in names (d24, s₁) and numbers with a power of ten.
std::vector<Token> numbers_in(const SeenText& seen) {
    const std::string& text = seen.text;
    std::vector<Token> numbers;
    const float width_px = (seen.right_px - seen.left_px) / static_cast<float>(std::max(text.size(), std::size_t{1}));
    for (std::size_t at = 0; at < text.size();) {
        if (!is_digit(text[at])) {
            ++at;
            continue;
        }
        std::size_t begin = at;
        Token token{"", seen.place, 0.0, 0, 0, 0.0F, 0.0F, seen.baseline_px, seen.em_px};
        std::string plain;
        bool has_point = false;
        for (; at < text.size(); ++at) {
            const bool goes_on = at + 1 < text.size() && is_digit(text[at + 1]);
            if (text[at] == ',' && goes_on) {
                // A comma may group three digits; any other comma separates numbers.
                const std::size_t end = std::min(text.find_first_not_of("0123456789", at + 1), text.size());
                if (end - at != 4 || has_point) break;
                continue;
            }
            if (text[at] == '.' && goes_on && !has_point)
                has_point = true;
            else if (!is_digit(text[at]))
                break;
            else if (has_point)
                ++token.decimals;
            plain += text[at];
        }
        const std::string_view before = std::string_view(text).substr(0, begin),
                               after = std::string_view(text).substr(at);
        const auto is_name = [](char byte) {
            return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '_' || byte == '#';
        };
        if (!before.empty() && is_name(before.back())) continue;
        if (after.starts_with("·10")) {
            at += std::string_view("·10").size();
            continue;
        }
        if (before.ends_with(minus)) {
            plain.insert(0, "-");
            begin -= minus.size();
        } else if (before.ends_with('-')) {
            plain.insert(0, "-");
            --begin;
        }
        token.value = parse_double(plain).value_or(0.0);
        std::string digits;
        for (const char byte : plain)
            if (is_digit(byte) && !(digits.empty() && byte == '0')) digits += byte;
        while (has_point && digits.ends_with('0')) digits.pop_back();
        token.significant = static_cast<int>(digits.size());
        token.text = text.substr(begin, at - begin);
        token.left_px = seen.left_px + width_px * static_cast<float>(begin);
        token.right_px = seen.left_px + width_px * static_cast<float>(at);
        numbers.push_back(std::move(token));
    }
    return numbers;
}

/// Whether the digits shown are those of the value.
bool shows(const Token& token, double value) {
    return std::abs(token.value - value) <= 0.5 * std::pow(10.0, -token.decimals) * (1.0 + 1e-9);
}

bool is_trivial(double value) {
    return value == 0.0 || std::abs(value) == 1.0;
}

using Matches = std::function<bool(std::size_t, const Token&)>;

/// Finds `count` matching tokens side by side or one below another, and returns the first. `tokens` contains everything
/// that may lie between them.
const Token* find_run(const std::vector<Token>& tokens, std::size_t count, const Matches& matches) {
    const auto next = [&](const Token& token, bool in_column) {
        const Token* nearest = nullptr;
        for (const Token& other : tokens) {
            const bool is_beside = std::abs(other.baseline_px - token.baseline_px) < 0.5F * token.em_px;
            const bool overlaps = other.left_px < token.right_px && other.right_px > token.left_px;
            if (in_column ? !overlaps || is_beside || other.baseline_px < token.baseline_px
                          : !is_beside || other.left_px < token.right_px)
                continue;
            const auto distance = [&](const Token& to) { return in_column ? to.baseline_px : to.left_px; };
            if (!nearest || distance(other) < distance(*nearest)) nearest = &other;
        }
        return nearest;
    };
    for (const Token& first : tokens)
        for (const bool in_column : {false, true}) {
            const Token* at = &first;
            std::size_t done = 0;
            while (at && done < count && matches(done, *at)) {
                if (++done == count) return &first;
                at = next(*at, in_column);
            }
        }
    return nullptr;
}

/// Whether a text contains another as a whole word or number.
bool has_words_of(std::string_view text, std::string_view wanted) {
    const auto goes_on = [](char byte) {
        return is_digit(byte) || (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '.';
    };
    for (std::size_t at = text.find(wanted); at != std::string_view::npos; at = text.find(wanted, at + 1)) {
        const std::size_t end = at + wanted.size();
        if ((at == 0 || !goes_on(text[at - 1])) && (end == text.size() || !goes_on(text[end]))) return true;
    }
    return false;
}

/// Whether a text belongs to a control that the step lists, such as "light/position/x". The question takes such a text
/// as given.
bool is_given(const LessonStep& step, const SeenText& text) {
    const std::vector<std::string>& controls = step.start.params.view.layout.controls;
    return std::any_of(controls.begin(), controls.end(), [&](std::string path) {
        std::replace(path.begin(), path.end(), '.', '/');
        return text.place == path || text.place.starts_with(path + "/");
    });
}

class Search {
public:
    Search(const LessonStep& step, const Answer& right, const std::vector<SeenText>& texts)
        : ask_(step.ask), right_(right) {
        std::copy_if(texts.begin(), texts.end(), std::back_inserter(texts_),
                     [&](const SeenText& text) { return !is_given(step, text); });
        for (const SeenText& text : texts_) {
            const std::vector<Token> more = numbers_in(text);
            numbers_.insert(numbers_.end(), more.begin(), more.end());
        }
        said_ = step.say.in_english() + "\n" + ask_.question.in_english();
        for (const LessonText& hint : ask_.hints) said_ += "\n" + hint.in_english();
        said_numbers_ = numbers_in({said_, "", 0.0F, 0.0F, 0.0F, 0.0F});
    }

    std::vector<std::string> all() {
        if (!ask_.choices.empty()) choice();
        if (right_.numbers.size() == 1) number(right_.numbers.front(), "");
        if (right_.numbers.size() > 1) rows();
        if (kind_of(ask_).is_ordered) items();
        return std::move(found_);
    }

private:
    void find(const std::string& what, const std::string& text, const std::string& place) {
        std::string sentence = what + " can be read beforehand: " + one_line(text) + " in " + place;
        if (std::find(found_.begin(), found_.end(), sentence) == found_.end()) found_.push_back(std::move(sentence));
    }

    bool is_said(double value) const {
        return std::any_of(said_numbers_.begin(), said_numbers_.end(),
                           [&](const Token& said) { return said.value == value || shows(said, value); });
    }

    void number(double value, const std::string& choice) {
        constexpr int least_digits = 3;
        if (is_said(value)) return;
        for (const Token& token : numbers_)
            if (token.significant >= least_digits && shows(token, value))
                find(choice.empty() ? "the answer " + format_number(value) : "the answer " + excerpt(choice),
                     token.text, token.place);
    }

    void rows() {
        const bool is_vector = ask_.columns == 1;
        const auto columns = is_vector ? right_.numbers.size() : static_cast<std::size_t>(ask_.columns);
        for (std::size_t begin = 0; columns > 0 && begin + columns <= right_.numbers.size(); begin += columns) {
            const double* const row = right_.numbers.data() + begin;
            const double* const first =
                std::find_if(row, row + columns, [](double entry) { return !is_trivial(entry); });
            const bool is_telling = std::any_of(first, row + columns, [&](double entry) {
                return !is_trivial(entry) && entry != *first && !is_said(entry);
            });
            if (!is_telling) continue;
            const Token* const seen =
                find_run(numbers_, columns, [&](std::size_t i, const Token& token) { return shows(token, row[i]); });
            if (!seen) continue;
            std::string text;
            for (std::size_t i = 0; i < columns; ++i) text += (i ? ", " : "(") + figures(row[i], 4);
            find(is_vector ? "the answer" : "a row of the answer", text + ")", seen->place);
        }
    }

    void choice() {
        const LessonChoice* right = nullptr;
        const auto is_seen = [&](const std::string& words, bool whole) -> const SeenText* {
            for (const SeenText& text : texts_)
                if (whole ? text.text == words : has_words_of(text.text, words)) return &text;
            return nullptr;
        };
        std::vector<Token> wrong_numbers;
        for (const LessonChoice& choice : ask_.choices) {
            if (choice.right) {
                right = &choice;
                continue;
            }
            if (is_seen(choice.say.in_english(), false)) return;
            const std::vector<Token> more = numbers_in({choice.say.in_english(), "", 0.0F, 0.0F, 0.0F, 0.0F});
            wrong_numbers.insert(wrong_numbers.end(), more.begin(), more.end());
        }
        if (!right) return;
        const std::string& words = right->say.in_english();
        constexpr std::size_t shortest = 3;
        if (character_count(words) >= shortest && !has_words_of(said_, words))
            if (const SeenText* const seen = is_seen(words, true))
                return find("the answer " + excerpt(words), seen->text, seen->place);
        for (const Token& token : numbers_in({words, "", 0.0F, 0.0F, 0.0F, 0.0F}))
            if (std::none_of(wrong_numbers.begin(), wrong_numbers.end(),
                             [&](const Token& wrong) { return wrong.value == token.value; }))
                number(token.value, words);
    }

    void items() {
        constexpr std::size_t fewest = 3;
        if (right_.items.size() < fewest) return;
        const auto words = [&](int item) { return ask_.items[item].in_english(); };
        std::vector<Token> seen;
        for (const SeenText& text : texts_)
            if (std::any_of(ask_.items.begin(), ask_.items.end(),
                            [&](const LessonText& item) { return item.in_english() == text.text; }))
                seen.push_back(
                    {text.text, text.place, 0.0, 0, 0, text.left_px, text.right_px, text.baseline_px, text.em_px});
        const Token* const first = find_run(seen, right_.items.size(), [&](std::size_t i, const Token& token) {
            return token.text == words(right_.items[i]);
        });
        if (!first) return;
        std::string order;
        for (const int item : right_.items) order += (order.empty() ? "" : ", ") + words(item);
        find("the order", order, first->place);
    }

    const Ask& ask_;
    const Answer& right_;
    std::vector<SeenText> texts_;
    std::vector<Token> numbers_, said_numbers_;
    std::string said_;
    std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> seen_answers(const LessonStep& step, const Answer& right, const std::vector<SeenText>& texts) {
    return Search(step, right, texts).all();
}

}  // namespace viewing
