#include "lesson/hand_in.h"

#include <algorithm>
#include <cmath>

#include "lesson/tree.h"
#include "platform/shared_file.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::size_t longest_answer = 16384;  // bytes
constexpr double largest_number = 1e300;
constexpr std::size_t most_items = 200, most_numbers = 64, most_settings = 64;

std::string text_in(const Json& object, const char* key, const Where& where) {
    if (!has(object, key)) return "";
    if (!object[key].is_string()) refuse_value(object[key], where.key(key), "a string");
    std::string text = object[key].get<std::string>();
    if (text.size() > longest_answer) where.key(key).refuse("longer than " + std::to_string(longest_answer) + " bytes");
    return text;
}

void append_numbers(const Json& value, std::vector<double>& numbers, const Where& where) {
    if (value.is_number()) {
        numbers.push_back(read_number(value, where, {-largest_number, largest_number}));
        return;
    }
    require_array(value, where, most_numbers, "a number or a list of numbers");
    for (std::size_t i = 0; i < value.size(); ++i) append_numbers(value[i], numbers, where.at(i));
    if (numbers.size() > most_numbers) where.refuse("has more than " + std::to_string(most_numbers) + " numbers");
}

std::vector<std::string> settings_in(const Json& object, const Where& where) {
    if (object.size() > most_settings) where.refuse("has more than " + std::to_string(most_settings) + " paths");
    return read_settings(object, where);
}

Attempt read_attempt(const Json& object, const Where& where) {
    require_keys(object, where, {"at", "answer", "set", "hint", "told"});
    Attempt attempt;
    attempt.at = text_in(object, "at", where);
    attempt.told = text_in(object, "told", where);
    if (has(object, "hint")) attempt.hint = read_whole(object["hint"], where.key("hint"), 1, 99);
    if (has(object, "answer")) append_numbers(object["answer"], attempt.answer.emplace(), where.key("answer"));
    if (has(object, "set")) {
        attempt.is_goal = true;
        attempt.settings = settings_in(object["set"], where.key("set"));
    }
    if ((attempt.hint > 0) + attempt.answer.has_value() + attempt.is_goal != 1)
        where.refuse("must have exactly one of \"answer\", \"set\" and \"hint\"");
    return attempt;
}

HandInItem read_item(const Json& object, const Where& where) {
    require_keys(object, where, {"exercise", "variant", "attempts", "replay", "draft", "draft_set"});
    HandInItem item;
    item.exercise = name_at(object, "exercise", where);
    if (has(object, "variant"))
        item.variant = static_cast<std::size_t>(read_whole(object["variant"], where.key("variant"), 0, 9999));
    if (has(object, "attempts")) {
        const Where inside = where.key("attempts");
        require_array(object["attempts"], inside, most_attempts, "a list of attempts");
        for (std::size_t i = 0; i < object["attempts"].size(); ++i)
            item.attempts.push_back(read_attempt(object["attempts"][i], inside.at(i)));
    }
    if (has(object, "draft")) append_numbers(object["draft"], item.draft.emplace(), where.key("draft"));
    if (has(object, "draft_set")) item.draft_settings = settings_in(object["draft_set"], where.key("draft_set"));
    if (has(object, "replay")) {
        const Where inside = where.key("replay");
        require_array(object["replay"], inside, most_replay_steps, "a list of changes");
        for (std::size_t i = 0; i < object["replay"].size(); ++i) {
            const Json& step = object["replay"][i];
            const Where at = inside.at(i);
            require_keys(step, at, {"after_s", "set"});
            ReplayStep read;
            if (has(step, "after_s")) read.after_s = read_number(step["after_s"], at.key("after_s"), {0.0, 1e9});
            if (has(step, "set")) read.settings = settings_in(step["set"], at.key("set"));
            item.replay.push_back(std::move(read));
        }
    }
    return item;
}

HandIn read_hand_in(const Json& document, const Where& where) {
    require_keys(document, where, {"answers", "program", "course", "student", "name", "items"});
    if (!has(document, "answers") || document["answers"] != 1)
        where.key("answers").refuse("must be 1, the version of the format that this program reads");
    HandIn hand_in;
    hand_in.program = text_in(document, "program", where);
    hand_in.course = text_in(document, "course", where);
    if (!has(document, "student")) where.key("student").refuse("is missing: a string");
    hand_in.student = text_in(document, "student", where);
    hand_in.name = text_in(document, "name", where);
    if (!has(document, "items")) return hand_in;
    const Where inside = where.key("items");
    require_array(document["items"], inside, most_items, "a list of exercises");
    for (std::size_t i = 0; i < document["items"].size(); ++i) {
        HandInItem item = read_item(document["items"][i], inside.at(i));
        if (hand_in.find(item.exercise))
            inside.at(i).key("exercise").refuse("\"" + excerpt(item.exercise) + "\" appears twice");
        hand_in.items.push_back(std::move(item));
    }
    return hand_in;
}

/// Writes sixteen numbers as a matrix, a single number as a number, and any other count as a list.
Json numbers_as_json(const std::vector<double>& numbers) {
    if (numbers.size() == 1) return numbers.front();
    if (numbers.size() != 16) return Json(numbers);
    Json rows = Json::array();
    for (std::ptrdiff_t row = 0; row < 4; ++row)
        rows.push_back(std::vector<double>(numbers.begin() + 4 * row, numbers.begin() + 4 * (row + 1)));
    return rows;
}

Json attempt_as_json(const Attempt& attempt) {
    Json object = Json::object();
    if (!attempt.at.empty()) object["at"] = attempt.at;
    if (attempt.hint > 0) object["hint"] = attempt.hint;
    if (attempt.answer) object["answer"] = attempt.answer->empty() ? Json::array() : numbers_as_json(*attempt.answer);
    if (attempt.is_goal) object["set"] = settings_as_json(attempt.settings);
    if (attempt.hint == 0) object["told"] = attempt.told;
    return object;
}

template <typename T>
const T& changed_or_kept(const T& kept, const T& known, const T& now) {
    return now == known ? kept : now;
}

/// Merges a draft. A checked answer is no longer a draft in this window, but an answer entered meanwhile in another
/// window is still one.
template <typename T>
const T& typed_last(const T& kept, const T& known, const T& now) {
    return now == T{} && kept != known ? kept : changed_or_kept(kept, known, now);
}

/// Merges two lists of attempts in chronological order, without duplicates. A window may write before it has seen
/// another window's latest attempts, so an attempt in only one list is never treated as deleted.
std::vector<Attempt> united(std::vector<Attempt> kept, const std::vector<Attempt>& now) {
    const auto count = [](const std::vector<Attempt>& attempts, const Attempt& attempt) {
        return std::count(attempts.begin(), attempts.end(), attempt);
    };
    for (const Attempt& attempt : now)
        if (count(kept, attempt) < count(now, attempt)) kept.push_back(attempt);
    std::stable_sort(kept.begin(), kept.end(), [](const Attempt& a, const Attempt& b) { return a.at < b.at; });
    for (std::size_t i = 1; i < kept.size(); ++i)
        if (replaces(kept[i], kept[i - 1])) kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(--i));
    if (kept.size() > most_attempts) kept.erase(kept.begin(), kept.end() - most_attempts);
    return kept;
}

/// Merges the answers to one exercise from two windows. If the variants differ, this window's answers replace the
/// file's only if it changed them.
HandInItem merged_item(HandInItem kept, const HandInItem& known, const HandInItem& now) {
    if (kept.variant != now.variant) return changed_or_kept(kept, known, now);
    kept.attempts = united(std::move(kept.attempts), now.attempts);
    // If the replay changed in both windows, keep the longer one.
    if (kept.replay == known.replay || (now.replay != known.replay && now.replay.size() >= kept.replay.size()))
        kept.replay = now.replay;
    kept.draft = typed_last(kept.draft, known.draft, now.draft);
    kept.draft_settings = typed_last(kept.draft_settings, known.draft_settings, now.draft_settings);
    return kept;
}

}  // namespace

HandInItem* HandIn::find(const std::string& exercise) {
    const auto at =
        std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.exercise == exercise; });
    return at == items.end() ? nullptr : &*at;
}

const HandInItem* HandIn::find(const std::string& exercise) const {
    return const_cast<HandIn*>(this)->find(exercise);
}

bool replaces(const Attempt& attempt, const Attempt& before) {
    return attempt.is_goal && before.is_goal && attempt.told != "right" && attempt.told == before.told;
}

Result<HandIn> parse_hand_in(std::string_view json, const std::string& source) {
    return guarded([&] {
        const Where root{source + ": ", ""};
        return read_hand_in(parse_document(json, root.prefix), root);
    });
}

Result<HandIn> load_hand_in(const std::filesystem::path& file) {
    const Result<std::string> text = read_text_file(file);
    if (!text) return Error{text.error()};
    return parse_hand_in(*text, one_line(file.string()));
}

std::string hand_in_as_text(const HandIn& hand_in) {
    Json document = {
        {"answers", 1},         {"program", hand_in.program}, {"course", hand_in.course}, {"student", hand_in.student},
        {"name", hand_in.name}, {"items", Json::array()}};
    for (const HandInItem& item : hand_in.items) {
        Json object = {{"exercise", item.exercise}, {"variant", item.variant}, {"attempts", Json::array()}};
        for (const Attempt& attempt : item.attempts) object["attempts"].push_back(attempt_as_json(attempt));
        for (const ReplayStep& step : item.replay)
            object["replay"].push_back({{"after_s", step.after_s}, {"set", settings_as_json(step.settings)}});
        if (item.draft && !item.draft->empty()) object["draft"] = numbers_as_json(*item.draft);
        if (!item.draft_settings.empty()) object["draft_set"] = settings_as_json(item.draft_settings);
        document["items"].push_back(std::move(object));
    }
    return print_document(document) + "\n";
}

std::optional<Answer> answer_in(const Attempt& attempt, const Ask& ask) {
    if (!attempt.answer || attempt.answer->empty()) return std::nullopt;
    Answer answer;
    if (is_typed(ask.kind)) {
        if (std::ssize(*attempt.answer) != ask.rows * ask.columns) return std::nullopt;
        answer.numbers = *attempt.answer;
        return answer;
    }
    const auto count = static_cast<double>(ask.kind == AskKind::choice ? ask.choices.size() : ask.items.size());
    for (const double number : *attempt.answer) {
        if (number != std::floor(number) || number < 0.0 || number >= count) return std::nullopt;
        answer.items.push_back(static_cast<int>(number));
    }
    if (ask.kind == AskKind::choice && answer.items.size() != 1) return std::nullopt;
    return answer;
}

std::vector<double> answer_numbers(const Answer& answer) {
    if (!answer.items.empty()) return {answer.items.begin(), answer.items.end()};
    std::vector<double> numbers = answer.numbers;
    for (double& number : numbers)
        number = std::isnan(number) ? 0.0 : std::clamp(number, -largest_number, largest_number);
    return numbers;
}

bool are_same_settings(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    return settings_as_json(a) == settings_as_json(b);
}

HandIn merged(const HandIn& kept, const HandIn& known, const HandIn& now) {
    HandIn merged = kept;
    for (const auto text : {&HandIn::program, &HandIn::course, &HandIn::student, &HandIn::name})
        merged.*text = changed_or_kept(kept.*text, known.*text, now.*text);
    for (const HandInItem& item : now.items) {
        const HandInItem* const before = known.find(item.exercise);
        if (HandInItem* const there = merged.find(item.exercise))
            *there = merged_item(std::move(*there), before ? *before : HandInItem{}, item);
        else
            merged.items.push_back(item);
    }
    return merged;
}

Result<HandIn> merge_hand_in(const std::filesystem::path& file, const HandIn& known, const HandIn& now) {
    if (now.items.empty() && !is_there(file)) return now;
    return merge_into_file<HandIn>(
        file, load_hand_in, [&](const HandIn& kept) { return kept == HandIn{} ? now : merged(kept, known, now); },
        [&](const HandIn& merged) { return write_file(file, hand_in_as_text(merged)); });
}

void thin(std::vector<ReplayStep>& replay) {
    while (replay.size() > most_replay_steps) {
        std::vector<ReplayStep> kept;
        for (std::size_t i = 0; i < replay.size(); ++i)
            if (i % 2 == 1 || i + 1 == replay.size()) kept.push_back(std::move(replay[i]));
        replay = std::move(kept);
    }
}

}  // namespace viewing
