#include "lesson/hand_in.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "lesson/questions/question_kind.h"
#include "lesson/tree.h"
#include "platform/shared_file.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::size_t longest_answer = 16384;  // bytes
constexpr double largest_number = 1e300;
constexpr std::size_t most_items = 200, most_numbers = 64, most_settings = 64;

using form::Object;
using Names = std::vector<std::string>;

/// A string of limited length, with no other requirement.
form::Form<std::string> answer_text() {
    return form::text("a string", longest_answer);
}

form::Form<std::vector<double>> answer_form() {
    return numbers_form("numbers", {-largest_number, largest_number}, most_numbers)
        .then([](const std::vector<double>& numbers, const Where& where) {
            if (numbers.size() > most_numbers)
                where.refuse("has more than " + std::to_string(most_numbers) + " numbers");
        });
}

form::Form<Names> changes_form() {
    const auto are_few = [](const Names& settings, const Where& where) {
        if (settings.size() > most_settings) where.refuse("has more than " + std::to_string(most_settings) + " paths");
    };
    return form::settings().then(are_few, {{"maxProperties", most_settings}});
}

Object<Attempt> attempt_form() {
    const auto answer_goal = [](Attempt& attempt, const Names& settings) {
        attempt.is_goal = true;
        attempt.settings = settings;
    };
    return Object<Attempt>()
        .optional("at", answer_text(), &Attempt::at)
        .optional("told", answer_text(), &Attempt::told)
        .exactly_one({"answer", "set", "hint"})
        .optional("hint", form::whole(1, 99), &Attempt::hint)
        .optional("answer", answer_form(), &Attempt::answer)
        .optional("set", changes_form(), answer_goal);
}

Object<ReplayStep> replay_form() {
    return Object<ReplayStep>()
        .optional("after_s", form::number({0.0, 1e9}), &ReplayStep::after_s)
        .optional("set", changes_form(), &ReplayStep::settings);
}

Object<HandInItem> item_form() {
    return Object<HandInItem>()
        .required("exercise", form::name(), &HandInItem::exercise)
        .optional("variant", form::whole(0, 9999), &HandInItem::variant)
        .optional("attempts", form::list(attempt_form().form(), "a list of attempts", {most_attempts}),
                  &HandInItem::attempts)
        .optional("draft", answer_form(), &HandInItem::draft)
        .optional("draft_set", changes_form(), &HandInItem::draft_settings)
        .optional("replay", form::list(replay_form().form(), "a list of changes", {most_replay_steps}),
                  &HandInItem::replay);
}

Object<HandIn> hand_in_form() {
    const auto each_once = [](const std::vector<HandInItem>& items, const Where& where) {
        std::set<std::string> known;
        for (std::size_t i = 0; i < items.size(); ++i)
            if (!known.insert(items[i].exercise).second)
                where.at(i).key("exercise").refuse("\"" + excerpt(items[i].exercise) + "\" appears twice");
    };
    return Object<HandIn>()
        .version("answers")
        .optional("program", answer_text(), &HandIn::program)
        .optional("course", answer_text(), &HandIn::course)
        .required("student", answer_text(), &HandIn::student)
        .optional("name", answer_text(), &HandIn::name)
        .optional("items", form::list(item_form().form(), "a list of exercises", {most_items}).then(each_once),
                  &HandIn::items);
}

/// Drops the entries of `list` for which `read` throws a Refusal, and calls `report(entry, why)` for each.
template <typename Read, typename Report>
void drop_unreadable(Json& list, const Where& where, const Read& read, const Report& report) {
    Json readable = Json::array();
    for (std::size_t i = 0; i < list.size(); ++i) {
        try {
            read(list[i], where.at(i));
            readable.push_back(list[i]);
        } catch (const Refusal& refusal) {
            report(list[i], refusal.what());
        }
    }
    list = std::move(readable);
}

/// Drops what hand_in_form() would refuse below the document's items.
std::vector<LeftOut> drop_unreadable_items(Json& document) {
    std::vector<LeftOut> left_out;
    if (!document.is_object() || !document.contains("items") || !document["items"].is_array()) return left_out;
    const form::Form<HandInItem> item_of_file = item_form().form();
    const form::Form<Attempt> attempt_of_file = attempt_form().form();
    const auto name_of = [](const Json& item) {
        return item.is_object() && item.contains("exercise") && item["exercise"].is_string()
                   ? item["exercise"].get<std::string>()
                   : "";
    };
    const Where items{"", "items"};
    for (std::size_t i = 0; i < document["items"].size(); ++i) {
        Json& item = document["items"][i];
        if (!item.is_object() || !item.contains("attempts") || !item["attempts"].is_array()) continue;
        drop_unreadable(item["attempts"], items.at(i).key("attempts"), attempt_of_file.read,
                        [&](const Json&, const std::string& why) {
                            left_out.push_back({name_of(item), why});
                        });
    }
    std::set<std::string> known;
    const auto read_once = [&](const Json& item, const Where& where) {
        if (!known.insert(item_of_file.read(item, where).exercise).second)
            where.key("exercise").refuse("\"" + excerpt(name_of(item)) + "\" appears twice");
    };
    drop_unreadable(document["items"], items, read_once, [&](const Json& item, const std::string& why) {
        left_out.push_back({name_of(item), why});
    });
    return left_out;
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

/// Merges a draft. Checking an answer clears this window's draft, but not a draft that another window has stored in the
/// meantime.
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
/// file's only if this window has changed them.
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
        return hand_in_form().read(parse_document(json, root.prefix), root);
    });
}

std::string hand_in_schema() {
    return form::document("A hand-in of Viewing Sandbox", hand_in_form());
}

Result<HandIn> load_hand_in(const std::filesystem::path& file) {
    const Result<std::string> text = read_text_file(file);
    if (!text) return Error{text.error()};
    return parse_hand_in(*text, one_line(file.string()));
}

Result<ReadableHandIn> load_readable_hand_in(const std::filesystem::path& file) {
    const Result<std::string> text = read_text_file(file);
    if (!text) return Error{text.error()};
    return guarded([&] {
        const Where root{one_line(file.string()) + ": ", ""};
        Json document = parse_document(*text, root.prefix);
        std::vector<LeftOut> left_out = drop_unreadable_items(document);
        return ReadableHandIn{hand_in_form().read(document, root), std::move(left_out)};
    });
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
    if (kind_of(ask).is_typed) {
        if (std::ssize(*attempt.answer) != ask.rows * ask.columns) return std::nullopt;
        answer.numbers = *attempt.answer;
        return answer;
    }
    const auto count = static_cast<double>(ask.choices.empty() ? ask.items.size() : ask.choices.size());
    for (const double number : *attempt.answer) {
        if (number != std::floor(number) || number < 0.0 || number >= count) return std::nullopt;
        answer.items.push_back(static_cast<int>(number));
    }
    if (!ask.choices.empty() && answer.items.size() != 1) return std::nullopt;
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
