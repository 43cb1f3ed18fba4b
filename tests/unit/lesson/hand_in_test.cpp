// Hand-ins: a written file reads back, and a foreign file does no harm. Also tests the settings that turn one state
// into another; they store the answer to a goal.
#include "lesson/hand_in.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <utility>

#include "lesson/allowed.h"
#include "state/file/state_json.h"
#include "state/presets.h"
#include "unit/lesson/has.h"

namespace viewing {
namespace {

using testing::has;

const char* const whole = R"({
  "answers": 1, "program": "viewing-sandbox 0.9", "course": "viewing-2026", "student": "32201234", "name": "김학생",
  "items": [
    {
      "exercise": "E16-shadow-matrix", "variant": 8,
      "attempts": [
        {"at": "2026-11-21T10:03:12", "answer": [[5, 0, -3, 0], [0, 5, -5, 0], [0, 0, 4, 0], [0, 0, -1, 5]], "told": "M33"},
        {"at": "2026-11-21T10:04:00", "hint": 2},
        {"at": "2026-11-21T10:05:12", "answer": [[1, 2, 3, 4], [5, 6, 7, 8], [9, 10, 11, 12], [13, 14, 15, 0.1]],
         "told": "right"}
      ]
    },
    {
      "exercise": "E18-place-the-light", "variant": 3,
      "attempts": [{"set": {"light.position": [1, 2, 3, 1], "plane.equation": [0, 1, 0, 0]}, "told": ""},
                   {"set": {}, "told": "M26"}],
      "replay": [{"after_s": 0.5, "set": {"light.position": [1, 2, 3, 1]}}, {"after_s": 12.25, "set": {}}],
      "draft_set": {"light.position": [2, 2, 2, 1], "fog": "x=y"}
    },
    {"exercise": "E06-radians", "variant": 0, "attempts": [{"answer": -1.5e-9, "told": ""}], "draft": 0.1},
    {"exercise": "E07", "attempts": [{"answer": [0, 2, 1], "told": ""}], "draft": [1, 2]}
  ]
})";

HandIn parsed(const std::string& text) {
    const Result<HandIn> hand_in = parse_hand_in(text, "a.json");
    EXPECT_TRUE(hand_in) << (hand_in ? "" : hand_in.error());
    return hand_in ? *hand_in : HandIn{};
}

/// Returns a hand-in that uses every field.
HandIn full() {
    HandIn hand_in{"viewing-sandbox 1.0", "a \"course\"", "../학생", "Name\twith\nlines", {}};
    HandInItem typed{"E16", 9999, {}, {}, {}, {}};
    std::vector<double> matrix(16);
    for (std::size_t i = 0; i < 16; ++i) matrix[i] = (static_cast<double>(i) - 7.5) / 3.0;
    for (const std::vector<double>& answer :
         {matrix, std::vector{0.1}, std::vector{-1e-300, 1e300}, std::vector{1.0, 2.0, 3.0}, std::vector<double>()}) {
        Attempt attempt;
        attempt.at = "2026-11-21T10:03:12";
        attempt.answer = answer;
        attempt.told = "M33";
        typed.attempts.push_back(attempt);
    }
    Attempt hint;
    hint.at = "2026-11-21T10:03:13";
    hint.hint = 3;
    typed.attempts.push_back(hint);
    typed.draft = matrix;
    HandInItem goal{"E18", 0, {}, {}, {}, {}};
    for (const std::vector<std::string>& settings :
         {std::vector<std::string>(),
          std::vector<std::string>{"light.position=[1,2,3,1]", "scene=\"a=b\"", "x=null"}}) {
        Attempt attempt;
        attempt.is_goal = true;
        attempt.settings = settings;
        goal.attempts.push_back(attempt);
        goal.replay.push_back({0.1 * static_cast<double>(goal.replay.size()), settings});
    }
    goal.draft_settings = goal.attempts.back().settings;
    hand_in.items = {typed, goal, {"empty", 1, {}, {}, {}, {}}};
    return hand_in;
}

TEST(HandIn, ReadsEveryField) {
    const HandIn read = parsed(whole);
    EXPECT_EQ(read.program, "viewing-sandbox 0.9");
    EXPECT_EQ(read.course, "viewing-2026");
    EXPECT_EQ(read.student, "32201234");
    EXPECT_EQ(read.name, "김학생");
    ASSERT_EQ(read.items.size(), 4U);
    const HandInItem& matrix = read.items[0];
    EXPECT_EQ(matrix.exercise, "E16-shadow-matrix");
    EXPECT_EQ(matrix.variant, 8U);
    ASSERT_EQ(matrix.attempts.size(), 3U);
    EXPECT_EQ(matrix.attempts[0].at, "2026-11-21T10:03:12");
    EXPECT_EQ(*matrix.attempts[0].answer, (std::vector<double>{5, 0, -3, 0, 0, 5, -5, 0, 0, 0, 4, 0, 0, 0, -1, 5}));
    EXPECT_EQ(matrix.attempts[0].told, "M33");
    EXPECT_EQ(matrix.attempts[0].hint, 0);
    EXPECT_FALSE(matrix.attempts[0].is_goal);
    EXPECT_EQ(matrix.attempts[1].hint, 2);
    EXPECT_FALSE(matrix.attempts[1].answer);
    EXPECT_FALSE(matrix.draft);
    const HandInItem& goal = read.items[1];
    EXPECT_TRUE(goal.attempts[0].is_goal);
    EXPECT_EQ(goal.attempts[0].settings,
              (std::vector<std::string>{"light.position=[1,2,3,1]", "plane.equation=[0,1,0,0]"}));
    EXPECT_TRUE(goal.attempts[1].is_goal);
    EXPECT_TRUE(goal.attempts[1].settings.empty());
    ASSERT_EQ(goal.replay.size(), 2U);
    EXPECT_EQ(goal.replay[1].after_s, 12.25);
    EXPECT_EQ(goal.draft_settings, (std::vector<std::string>{"light.position=[2,2,2,1]", "fog=\"x=y\""}));
    EXPECT_EQ(*read.items[2].draft, std::vector{0.1});
    EXPECT_EQ(*read.items[2].attempts[0].answer, std::vector{-1.5e-9});
    EXPECT_EQ(read.items[3].variant, 0U);
    EXPECT_EQ(read.find("E07"), &read.items[3]);
    EXPECT_EQ(read.find("E08"), nullptr);
}

TEST(HandIn, WrittenFileReadsBack) {
    for (const HandIn& hand_in : {full(), parsed(whole), HandIn{"", "", "1", "", {}}}) {
        const std::string text = hand_in_as_text(hand_in);
        EXPECT_EQ(parsed(text), hand_in) << text;
        EXPECT_EQ(hand_in_as_text(parsed(text)), text);
    }
}

TEST(HandIn, MatrixIsWrittenInFourRows) {
    const std::string text = hand_in_as_text(parsed(whole));
    EXPECT_TRUE(has(text, "[13, 14, 15, 0.1]")) << text;
    EXPECT_TRUE(has(text, "김학생"));
    EXPECT_EQ(text.back(), '\n');
}

/// Replaces one part of the file and returns the error, which is one sentence.
std::string hand_in_trouble(const std::string& part, const std::string& other) {
    std::string text = whole;
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    if (at != std::string::npos) text.replace(at, part.size(), other);
    const Result<HandIn> read = parse_hand_in(text, "a.json");
    EXPECT_FALSE(read) << "the file is accepted: " << other.substr(0, 200);
    if (read) return "";
    EXPECT_EQ(read.error().find("a.json: "), 0U) << read.error();
    EXPECT_LT(read.error().size(), 500U);
    return read.error();
}

// ---- one file, several windows --------------------------------------------------------------------------------------

/// A window that writes, with the hand-in it last knew and its current one.
struct WritingWindow {
    HandIn known, now;
    void write(HandIn& file) {
        file = merged(file, known, now);
        known = now = file;
    }
};

Attempt attempt_of(const std::string& at, double number) {
    Attempt attempt;
    attempt.at = at;
    attempt.answer = {number};
    return attempt;
}

/// Two windows may write in any order: each attempt appears exactly once, sorted by time.
/// The draft is that of the window that last wrote a changed draft.
TEST(MergedHandIn, KeepsTheWorkOfBothWindows) {
    constexpr unsigned seed = 11;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto up_to = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
    for (int round = 0; round < 200; ++round) {
        HandIn file;
        std::array<WritingWindow, 2> windows;
        std::array<std::optional<double>, 2> typed;  // not yet written
        std::optional<double> draft;
        std::vector<Attempt> made;
        for (int act = 0; act < 40; ++act) {
            const auto at = static_cast<std::size_t>(up_to(2));
            WritingWindow& window = windows[at];
            if (window.now.items.empty()) window.now.items.push_back({"E01", 2, {}, {}, {}, {}});
            HandInItem& item = window.now.items.front();
            const int kind = up_to(3);
            if (kind == 0) {
                made.push_back(attempt_of(std::to_string(act / 5 + 10), act));
                item.attempts.push_back(made.back());
            } else if (kind == 1) {
                item.draft = std::vector{*(typed[at] = 100.0 + act)};
            } else {
                if (typed[at]) draft = *std::exchange(typed[at], std::nullopt);
                window.write(file);
            }
        }
        for (const std::size_t at : {0U, 1U, 0U}) {
            if (typed[at]) draft = *std::exchange(typed[at], std::nullopt);
            windows[at].write(file);
        }
        EXPECT_EQ(windows[0].now, windows[1].now);
        EXPECT_EQ(merged(file, {}, file), file) << "merging again changes nothing";
        ASSERT_TRUE(file.items.empty() || file.items.size() == 1) << round;
        if (file.items.empty()) continue;
        const std::vector<Attempt>& attempts = file.items.front().attempts;
        EXPECT_EQ(attempts.size(), made.size()) << round;
        for (const Attempt& attempt : made) EXPECT_EQ(std::count(attempts.begin(), attempts.end(), attempt), 1);
        EXPECT_TRUE(std::is_sorted(attempts.begin(), attempts.end(),
                                   [](const Attempt& a, const Attempt& b) { return a.at < b.at; }));
        EXPECT_EQ(file.items.front().draft, draft ? std::optional(std::vector{*draft}) : std::nullopt) << round;
    }
}

TEST(MergedHandIn, SameMistakeSeenByTwoWindowsIsOneAttempt) {
    const auto mistake = [](const std::string& at, const std::string& tag) {
        Attempt attempt;
        attempt.at = at;
        attempt.is_goal = true;
        attempt.told = tag;
        return attempt;
    };
    HandIn known;
    known.items = {{"E18", 0, {mistake("1", "too-near"), mistake("2", "")}, {}, {}, {}}};
    HandIn now = known, kept = known;
    now.items.front().attempts.back() = mistake("3", "");
    kept.items.front().attempts.push_back(mistake("4", "right"));
    kept.items.front().attempts.push_back(mistake("5", "right"));
    const std::vector<Attempt> wanted{mistake("1", "too-near"), mistake("3", ""), mistake("4", "right"),
                                      mistake("5", "right")};
    EXPECT_EQ(merged(kept, known, now).items.front().attempts, wanted);
    EXPECT_EQ(merged(now, kept, kept).items.front().attempts, wanted);
}

/// When the writes of two tabs cross, the other tab's file overwrites this tab's latest attempt.
TEST(MergedHandIn, OverwrittenAttemptComesBack) {
    HandIn own, other;
    own.items = {{"E01", 0, {attempt_of("1", 1), attempt_of("2", 2)}, {}, {}, {}}};
    other.items = {{"E01", 0, {attempt_of("1", 1), attempt_of("2", 5)}, {}, {}, {}}};
    const std::vector<Attempt> both{attempt_of("1", 1), attempt_of("2", 5), attempt_of("2", 2)};
    EXPECT_EQ(merged(other, own, own).items.front().attempts, both);
}

TEST(MergedHandIn, DraftElsewhereOutlivesACheckHere) {
    HandIn known;
    known.items = {{"E01", 0, {}, {}, std::vector{1.0}, {"a=1"}}};
    HandIn checked = known, kept = known;
    checked.items.front().draft.reset();
    checked.items.front().draft_settings.clear();
    EXPECT_FALSE(merged(kept, known, checked).items.front().draft) << "checking removes the draft";
    kept.items.front().draft = {2.0};
    kept.items.front().draft_settings = {"a=2"};
    EXPECT_EQ(merged(kept, known, checked).items.front().draft, std::optional(std::vector{2.0}));
    EXPECT_EQ(merged(kept, known, checked).items.front().draft_settings, std::vector<std::string>{"a=2"});
}

TEST(MergedHandIn, KeepsTheLongerReplayUnlessItWasThinned) {
    const auto with_replay = [](int steps, double first_s) {
        HandIn hand_in;
        hand_in.items = {{"E18", 0, {}, {}, {}, {}}};
        for (int i = 0; i < steps; ++i) hand_in.items.front().replay.push_back({first_s + i, {}});
        return hand_in;
    };
    const HandIn before = with_replay(200, 0.0), thinned = with_replay(101, 1.0), longer = with_replay(150, 2.0);
    EXPECT_EQ(merged(before, before, thinned), thinned) << "the other window did not continue";
    EXPECT_EQ(merged(longer, before, thinned), longer);
    EXPECT_EQ(merged(thinned, before, longer), longer);
}

TEST(MergedHandIn, AnswersToDifferentNumbersAreNotMixed) {
    HandIn kept, now;
    kept.items = {{"E01", 1, {attempt_of("1", 1)}, {}, {}, {}}};
    now.items = {{"E01", 2, {attempt_of("2", 2)}, {}, {}, {}}};
    EXPECT_EQ(merged(kept, {}, now).items, now.items) << "the window continues with its own answers";
    EXPECT_EQ(merged(kept, now, now).items, kept.items) << "the window has not changed them";
}

TEST(MergedHandIn, KeepsNoMoreAttemptsThanTheReaderAccepts) {
    HandIn kept, now;
    kept.items = now.items = {{"E01", 0, {}, {}, {}, {}}};
    for (std::size_t i = 0; i < most_attempts; ++i) {
        kept.items.front().attempts.push_back(attempt_of("1", static_cast<double>(i)));
        now.items.front().attempts.push_back(attempt_of("2", static_cast<double>(i)));
    }
    const HandIn both = merged(kept, {}, now);
    EXPECT_EQ(both.items.front().attempts, now.items.front().attempts) << "the latest attempts";
}

TEST(HandIn, RefusesUnknownFields) {
    EXPECT_EQ(hand_in_trouble("\"name\"", "\"nmae\""), "a.json: nmae: no such field; did you mean name?");
    EXPECT_TRUE(has(hand_in_trouble("\"variant\"", "\"varaint\""), "a.json: items[0].varaint: no such field"));
    EXPECT_TRUE(has(hand_in_trouble("\"hint\": 2", "\"hints\": 2"), "items[0].attempts[1].hints: no such field"));
    EXPECT_TRUE(has(hand_in_trouble("\"after_s\"", "\"after\""), "items[1].replay[0].after: no such field"));
}

TEST(HandIn, AttemptHasOneKind) {
    const std::string one_of = "must have exactly one of \"answer\", \"set\" and \"hint\"";
    EXPECT_TRUE(has(hand_in_trouble("\"hint\": 2", "\"hint\": 2, \"answer\": 1"), "items[0].attempts[1]: " + one_of));
    EXPECT_TRUE(has(hand_in_trouble("\"hint\": 2", "\"hint\": 2, \"set\": {}"), "items[0].attempts[1]: " + one_of));
    EXPECT_TRUE(has(hand_in_trouble("\"hint\": 2", "\"answer\": 2, \"set\": {}"), "items[0].attempts[1]: " + one_of));
    EXPECT_TRUE(has(hand_in_trouble(", \"hint\": 2", ""), "items[0].attempts[1]: " + one_of));
    EXPECT_TRUE(has(hand_in_trouble("\"hint\": 2", "\"hint\": 0"), "items[0].attempts[1].hint: must be"));
    EXPECT_TRUE(has(hand_in_trouble("\"hint\": 2", "\"hint\": 1.5"), "items[0].attempts[1].hint: must be"));
}

TEST(HandIn, NumbersMustBeNumbers) {
    hand_in_trouble("-1.5e-9", "NaN");
    hand_in_trouble("-1.5e-9", "Infinity");
    hand_in_trouble("-1.5e-9", "1e999");
    for (const char* const value : {"null", "\"1\"", "true", "{}", "1e301", "[[1, null]]"})
        EXPECT_TRUE(has(hand_in_trouble("-1.5e-9", value), "items[2].attempts[0].answer")) << value;
    EXPECT_TRUE(has(hand_in_trouble("\"draft\": 0.1", "\"draft\": null"), "items[2].draft"));
    EXPECT_TRUE(has(hand_in_trouble("12.25", "-1"), "items[1].replay[1].after_s: must be"));
    EXPECT_TRUE(has(hand_in_trouble("\"variant\": 8", "\"variant\": -1"), "items[0].variant: must be"));
    EXPECT_TRUE(has(hand_in_trouble("\"variant\": 8", "\"variant\": 1e20"), "items[0].variant: must be"));
}

std::string many(int count, const std::string& entry) {
    std::string list = "[";
    for (int i = 0; i < count; ++i) list += (i == 0 ? "" : ", ") + entry;
    return list + "]";
}

TEST(HandIn, LimitsEverySize) {
    const std::string attempts = R"([{"answer": -1.5e-9, "told": ""}])";
    EXPECT_TRUE(has(hand_in_trouble(attempts, many(1001, R"({"hint": 1})")), "items[2].attempts: "));
    EXPECT_TRUE(has(hand_in_trouble("-1.5e-9", many(65, "1")), "items[2].attempts[0].answer"));
    EXPECT_TRUE(has(hand_in_trouble("-1.5e-9", many(17, "[1, 2, 3, 4]")), "items[2].attempts[0].answer"));
    EXPECT_TRUE(has(hand_in_trouble("\"set\": {}}]", "\"set\": {}}], \"attempts_\": 1"), "attempts_"));
    EXPECT_TRUE(has(
        hand_in_trouble(R"([{"after_s": 0.5, "set": {"light.position": [1, 2, 3, 1]}}, {"after_s": 12.25, "set": {}}])",
                        many(201, "{}")),
        "items[1].replay: "));
    std::string paths;
    for (int i = 0; i < 65; ++i) paths += (i == 0 ? "" : ", ") + ("\"p" + std::to_string(i)) + "\": 1";
    EXPECT_TRUE(has(hand_in_trouble("\"set\": {}, \"told\": \"M26\"", "\"set\": {" + paths + "}"),
                    "items[1].attempts[1].set: has more than 64"));
    EXPECT_TRUE(has(hand_in_trouble("\"김학생\"", "\"" + std::string(20000, 'x') + "\""), "name: longer than 16384"));
    std::string items;
    for (int i = 0; i < 200; ++i) items += R"(, {"exercise": "x)" + std::to_string(i) + "\"}";
    EXPECT_TRUE(has(hand_in_trouble("\"draft\": [1, 2]}", "\"draft\": [1, 2]}" + items), "a.json: items: "));
    hand_in_trouble("-1.5e-9", std::string(100'000, '[') + std::string(100'000, ']'));
}

TEST(HandIn, EachExerciseAppearsOnce) {
    const std::string told = hand_in_trouble("\"E07\"", "\"E06-radians\"");
    EXPECT_TRUE(has(told, "items[3].exercise: \"E06-radians\" appears twice")) << told;
    EXPECT_TRUE(has(hand_in_trouble("\"exercise\": \"E07\"", "\"variant\": 1"), "items[3].exercise: is missing"));
}

TEST(HandIn, ChecksTheHeader) {
    EXPECT_TRUE(has(hand_in_trouble("\"answers\": 1", "\"answers\": 2"), "a.json: answers: must be 1"));
    EXPECT_TRUE(has(hand_in_trouble("\"answers\": 1,", ""), "a.json: answers: must be 1"));
    EXPECT_TRUE(has(hand_in_trouble("\"32201234\"", "32201234"), "a.json: student: must be"));
    EXPECT_TRUE(has(hand_in_trouble("\"student\": \"32201234\",", ""), "a.json: student: is missing"));
    EXPECT_FALSE(parse_hand_in("[]", "a.json"));
    EXPECT_FALSE(parse_hand_in("", "a.json"));
    EXPECT_FALSE(load_hand_in("/nowhere/a.json"));
}

TEST(HandIn, ChangedByteNeitherCrashesNorReachesATerminal) {
    const std::string text = hand_in_as_text(parsed(whole));
    std::mt19937 random(20261121);
    const auto below = [&](std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random); };
    int refused = 0;
    for (int i = 0; i < 2000; ++i) {
        std::string changed = text;
        for (std::size_t edits = 1 + below(4); edits > 0; --edits) {
            const std::size_t at = below(changed.size());
            const std::size_t way = below(4);
            if (way == 0) changed[at] = static_cast<char>(below(256));
            if (way == 1) changed.erase(at, 1 + below(20));
            if (way == 2) changed.insert(at, 1, static_cast<char>(below(256)));
            if (way == 3) changed.insert(at, changed.substr(below(changed.size()), 1 + below(40)));
        }
        const Result<HandIn> read = parse_hand_in(changed, "a.json");
        if (read) {
            EXPECT_TRUE(parse_hand_in(hand_in_as_text(*read), "b.json")) << changed;
            continue;
        }
        ++refused;
        EXPECT_EQ(read.error().find("a.json: "), 0U) << read.error();
        for (const char c : read.error())
            ASSERT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) << "edit " << i << ": " << read.error();
    }
    EXPECT_GT(refused, 500);
    EXPECT_LT(refused, 2000);
}

// ---- reading an answer ----------------------------------------------------------------------------------------------

Ask ask_of(AskKind kind, int rows = 1, int columns = 1) {
    Ask ask;
    ask.kind = kind;
    ask.rows = rows;
    ask.columns = columns;
    ask.choices.resize(kind == AskKind::choice ? 3 : 0);
    const bool has_items =
        kind == AskKind::sequence || kind == AskKind::order || kind == AskKind::product || kind == AskKind::subset;
    ask.items.resize(has_items ? 4 : 0);
    return ask;
}

std::optional<Answer> answered(const Ask& ask, std::vector<double> numbers) {
    Attempt attempt;
    attempt.answer = std::move(numbers);
    return answer_in(attempt, ask);
}

TEST(AnswerIn, NumbersMatchTheShapeOfTheQuestion) {
    const struct {
        AskKind kind;
        int rows, columns;
    } typed[] = {{AskKind::number, 1, 1}, {AskKind::vector, 3, 1}, {AskKind::matrix, 2, 2}, {AskKind::matrix, 4, 4}};
    for (const auto& [kind, rows, columns] : typed) {
        const auto size = static_cast<std::size_t>(rows * columns);
        const Ask ask = ask_of(kind, rows, columns);
        std::vector<double> numbers(size, -0.25);
        const std::optional<Answer> answer = answered(ask, numbers);
        ASSERT_TRUE(answer);
        EXPECT_EQ(answer->numbers, numbers);
        EXPECT_TRUE(answer->items.empty());
        EXPECT_EQ(answer_numbers(*answer), numbers);
        numbers.push_back(1.0);
        EXPECT_FALSE(answered(ask, numbers));
        numbers.resize(size - 1);
        EXPECT_FALSE(answered(ask, numbers));
        EXPECT_FALSE(answer_in(Attempt{}, ask));
    }
}

TEST(AnswerIn, PlaceIsAWholeNumberWithinTheList) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const AskKind kind : {AskKind::choice, AskKind::sequence, AskKind::order, AskKind::product, AskKind::subset}) {
        const Ask ask = ask_of(kind);
        const double last = kind == AskKind::choice ? 2.0 : 3.0;
        ASSERT_TRUE(answered(ask, {last}));
        EXPECT_EQ(answered(ask, {last})->items, std::vector{static_cast<int>(last)});
        EXPECT_EQ(answered(ask, {0.0})->items, std::vector{0});
        for (const double other : {last + 1, -1.0, 0.5, 1e300, -1e300, 4294967296.0, infinity, std::nan("")})
            EXPECT_FALSE(answered(ask, {other})) << static_cast<int>(kind) << ": " << other;
        if (kind == AskKind::choice) {
            EXPECT_FALSE(answered(ask, {0.0, 1.0})) << "two choices are refused";
            continue;
        }
        EXPECT_EQ(answered(ask, {3.0, 0.0})->items, (std::vector{3, 0}));
        EXPECT_FALSE(answered(ask, {3.0, 4.0}));
        EXPECT_EQ(answer_numbers(*answered(ask, {3.0, 0.0})), (std::vector{3.0, 0.0}));
    }
}

TEST(AnswerIn, GoalIsNotAnsweredWithNumbers) {
    EXPECT_FALSE(answered(ask_of(AskKind::goal), {0.0}));
    EXPECT_FALSE(answered(ask_of(AskKind::goal), {1.0}));
}

TEST(Replay, ThinningKeepsOrderAndEnd) {
    for (const int count : {0, 1, 2, 199, 200, 201, 202, 399, 400, 401, 1000, 12'345}) {
        std::vector<ReplayStep> replay;
        for (int i = 0; i < count; ++i) replay.push_back({static_cast<double>(i), {"x=" + std::to_string(i)}});
        thin(replay);
        ASSERT_LE(replay.size(), 200U) << count;
        EXPECT_GE(replay.size(), std::min<std::size_t>(static_cast<std::size_t>(count), 90)) << count;
        EXPECT_TRUE(count > 200 || replay.size() == static_cast<std::size_t>(count)) << count;
        for (std::size_t i = 0; i < replay.size(); ++i) {
            EXPECT_TRUE(i == 0 || replay[i - 1].after_s < replay[i].after_s) << i;
            EXPECT_EQ(replay[i].settings,
                      std::vector<std::string>{"x=" + std::to_string(static_cast<int>(replay[i].after_s))});
        }
        EXPECT_TRUE(count == 0 || replay.back().after_s == count - 1) << count;
    }
}

TEST(Replay, GrowsForeverWithinItsLimit) {
    std::vector<ReplayStep> replay;
    for (int i = 0; i < 5000; ++i) {
        replay.push_back({static_cast<double>(i), {}});
        thin(replay);
        ASSERT_LE(replay.size(), 200U);
        ASSERT_EQ(replay.back().after_s, i);
    }
    EXPECT_GE(replay.size(), 100U);
}

// ---- from one state to another --------------------------------------------------------------------------------------

/// Returns `params` with the view, observer, appearance and animation of `other`.
Params looked_at_as(Params params, const Params& other) {
    params.view = other.view;
    params.observer = other.observer;
    params.ui = other.ui;
    params.animation = other.animation;
    return params;
}

TEST(SettingsBetween, LeadFromOneStateToTheOther) {
    std::vector<Params> states{Params{}};
    for (const NamedFile& preset : presets()) {
        const Result<LoadedState> state = load_state(preset.name);
        ASSERT_TRUE(state) << state.error();
        states.push_back(state->params);
    }
    ASSERT_GT(states.size(), 30U);
    int different = 0;
    for (std::size_t a = 0; a < states.size(); a += 3)
        for (std::size_t b = 0; b < states.size(); b += 5) {
            const std::vector<std::string> settings = settings_between(states[a], states[b]);
            different += settings.empty() ? 0 : 1;
            const Result<Params> reached = apply_settings(states[a], settings);
            ASSERT_TRUE(reached) << reached.error();
            EXPECT_EQ(*reached, looked_at_as(states[b], states[a])) << a << " to " << b;
            for (const std::string& setting : settings)
                for (const char* const group : {"view.", "observer.", "ui.", "animation."})
                    EXPECT_NE(setting.find(group), 0U) << setting;
        }
    EXPECT_GT(different, 30);
}

TEST(SettingsBetween, AreEmptyWhenOnlyTheLookDiffers) {
    const Params before;
    EXPECT_TRUE(settings_between(before, before).empty());
    Params looked_at = before;
    looked_at.view.samples = before.view.samples == 0 ? 4 : 0;
    ASSERT_FALSE(changed_fields(before, looked_at).empty());
    EXPECT_TRUE(settings_between(before, looked_at).empty());
    Params moved = before;
    moved.camera.yaw = 12.0;
    const std::vector<std::string> settings = settings_between(before, moved);
    ASSERT_EQ(settings.size(), 1U);
    EXPECT_EQ(settings[0].find("camera.yaw=12"), 0U) << settings[0];
}

TEST(SettingsBetween, SurviveAHandIn) {
    const Result<LoadedState> other = load_state("depth-fighting");
    ASSERT_TRUE(other) << other.error();
    HandIn hand_in{"", "", "1", "", {{"x", 0, {}, {}, {}, settings_between(Params{}, other->params)}}};
    const HandIn read = parsed(hand_in_as_text(hand_in));
    ASSERT_EQ(read.items.size(), 1U);
    const Result<Params> reached = apply_settings(Params{}, read.items[0].draft_settings);
    ASSERT_TRUE(reached) << reached.error();
    EXPECT_EQ(*reached, looked_at_as(other->params, Params{}));
}

TEST(ChangedWithoutPermission, ReportsEveryFieldThatIsNotAllowed) {
    const Params before;
    Params after = before;
    after.camera.yaw += 1.0;
    after.projection.fovy += 1.0;
    EXPECT_EQ(changed_without_leave(before, after, {"camera"}), std::vector<std::string>{"projection.fovy"});
    EXPECT_EQ(changed_without_leave(before, after, {"camera.pitch", "projection"}),
              std::vector<std::string>{"camera.yaw"});
    EXPECT_TRUE(changed_without_leave(before, after, {"camera.yaw", "projection.fovy"}).empty());
    EXPECT_EQ(changed_without_leave(before, after, {"camera.y"}).size(), 2U) << "no group has this name";
    EXPECT_TRUE(changed_without_leave(before, after, {}).empty());
}

}  // namespace
}  // namespace viewing
