#include "lesson/edit_steps.h"

#include <algorithm>

#include "lesson/append.h"
#include "state/file/reader.h"
#include "state/file/state_json.h"

namespace viewing {
namespace {

using Pointer = Json::json_pointer;

/// Checks that the lesson's document has this step, calls `edit` with the document, and reads the result as a lesson.
template <typename Edit>
Result<std::string> edited(const LessonSource& source, std::size_t step, const Edit& edit) {
    return guarded([&] {
        Json lesson = lesson_document(source.text, source.name);
        if (step >= lesson["steps"].size() || !lesson["steps"][step].is_object())
            throw Refusal(source.name + ": has no step " + std::to_string(step + 1));
        edit(lesson);
        std::string text = print_document(lesson) + "\n";
        if (const Result<Lesson> read = parse_lesson(text, source.name, source.folder); !read)
            throw Refusal(read.error());
        return text;
    });
}

/// Like edited(), but calls `edit` with only this step of the document.
template <typename Edit>
Result<std::string> edited_step(const LessonSource& source, std::size_t step, const Edit& edit) {
    return edited(source, step, [&](Json& lesson) { edit(lesson["steps"][step]); });
}

/// Returns a sentence in a language; in English if it has no text in that language.
std::string sentence_in(const Json& value, Language language) {
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_object()) return "";
    for (const Language one : {language, Language::en}) {
        const std::string code(name_of(one));
        if (value.contains(code) && value[code].is_string()) return value[code].get<std::string>();
    }
    return "";
}

void set_sentence(Json& value, const std::string& text, Language language) {
    const bool is_plain = value.is_null() || value.is_string();
    if (is_plain && language == Language::en) {
        value = text;
        return;
    }
    if (is_plain) value = Json{{std::string(name_of(Language::en)), value.is_string() ? value : Json(text)}};
    value[std::string(name_of(language))] = text;
}

/// Collects the parts of a step.
class Parts {
public:
    Parts(const Json& step, Language language) : step_(step), language_(language) {}

    /// Adds a sentence; an absent one is empty.
    void add_sentence(StepPart::Kind kind, const std::string& place, std::size_t number = 0) {
        const Pointer at(place);
        parts_.push_back({kind, number, place, step_.contains(at) ? sentence_in(step_[at], language_) : ""});
    }
    /// Adds a part that says whether a choice is right, and returns whether it is.
    bool mark(const std::string& choice, std::size_t number) {
        const bool is_right = step_[Pointer(choice)].is_object() && step_[Pointer(choice)].contains("right");
        parts_.push_back({StepPart::Kind::right, number, choice + "/right", is_right ? "true" : "false"});
        return is_right;
    }
    /// Adds a value as it appears in the file; does nothing if the file lacks it.
    void value(StepPart::Kind kind, const std::string& place, std::size_t number = 0) {
        const Pointer at(place);
        if (!step_.contains(at)) return;
        const Json& value = step_[at];
        parts_.push_back({kind, number, place, value.is_string() ? value.get<std::string>() : value.dump()});
    }
    std::size_t count(const char* place) const {
        const Pointer at(place);
        return step_.contains(at) && step_[at].is_array() ? step_[at].size() : 0;
    }
    std::vector<StepPart> take() { return std::move(parts_); }

private:
    const Json& step_;
    Language language_;
    std::vector<StepPart> parts_;
};

}  // namespace

std::vector<StepPart> step_parts(const LessonSource& source, std::size_t step, Language language) {
    using Kind = StepPart::Kind;
    const Result<Json> lesson = guarded([&] { return lesson_document(source.text, source.name); });
    if (!lesson || step >= (*lesson)["steps"].size()) return {};
    Parts parts((*lesson)["steps"][step], language);
    parts.add_sentence(Kind::say, "/say");
    parts.add_sentence(Kind::question, "/ask/question");
    for (std::size_t i = 0; i < parts.count("/ask/choices"); ++i) {
        const std::string choice = "/ask/choices/" + std::to_string(i);
        const bool is_right = parts.mark(choice, i);
        parts.add_sentence(Kind::choice, choice + "/say", i);
        if (!is_right) parts.add_sentence(Kind::why, choice + "/why", i);
    }
    for (std::size_t i = 0; i < parts.count("/ask/items"); ++i)
        parts.add_sentence(Kind::item, "/ask/items/" + std::to_string(i), i);
    for (const char* place : {"/ask/expect", "/ask/until", "/ask/tolerance"}) parts.value(Kind::answer, place);
    for (std::size_t i = 0; i < parts.count("/ask/hints"); ++i)
        parts.add_sentence(Kind::hint, "/ask/hints/" + std::to_string(i), i);
    for (std::size_t i = 0; i < parts.count("/ask/wrong"); ++i) {
        const std::string wrong = "/ask/wrong/" + std::to_string(i);
        parts.value(Kind::wrong_when, wrong + "/when", i);
        parts.add_sentence(Kind::wrong_say, wrong + "/say", i);
    }
    parts.add_sentence(Kind::reveal, "/reveal/say");
    parts.add_sentence(Kind::note, "/note");
    return parts.take();
}

Result<std::string> with_part(const LessonSource& source, std::size_t step, const StepPart& part, Language language) {
    return edited_step(source, step, [&](Json& whole) {
        const Pointer at(part.place);
        switch (part.kind) {
            case StepPart::Kind::right: {
                Json& chosen = whole[at.parent_pointer()];
                const Json why = chosen.value("why", Json(template_texts.why));
                chosen.erase("why");
                for (Json& choice : whole["ask"]["choices"])
                    if (choice.erase("right") > 0 && &choice != &chosen) choice["why"] = why;
                whole[at] = true;
                break;
            }
            case StepPart::Kind::answer:
            case StepPart::Kind::wrong_when: {
                const Json value = Json::parse(part.text, nullptr, false);
                const bool is_value = value.is_number() || value.is_array();
                whole[at] = is_value ? value : Json(part.text);
                break;
            }
            default:
                if (part.kind == StepPart::Kind::note && part.text.empty())
                    whole.erase("note");
                else
                    set_sentence(whole[at], part.text, language);
        }
    });
}

Result<std::string> with_moved_step(const LessonSource& source, std::size_t from, std::ptrdiff_t to) {
    return edited(source, from, [&](Json& lesson) {
        Json& steps = lesson["steps"];
        const Json step = steps[from];
        const std::ptrdiff_t last = static_cast<std::ptrdiff_t>(steps.size()) - 1;
        steps.erase(from);
        steps.insert(steps.begin() + std::clamp<std::ptrdiff_t>(to, 0, last), step);
    });
}

Result<std::string> with_doubled_step(const LessonSource& source, std::size_t step) {
    return edited(source, step, [&](Json& lesson) {
        Json& steps = lesson["steps"];
        Json copy = steps[step];
        const auto is_taken = [&](const std::string& id) {
            return std::any_of(steps.begin(), steps.end(),
                               [&](const Json& one) { return one.is_object() && one.value("id", "") == id; });
        };
        const std::string id = copy.value("id", "step");
        int number = 2;
        while (is_taken(id + "-" + std::to_string(number))) ++number;
        copy["id"] = id + "-" + std::to_string(number);
        steps.insert(steps.begin() + static_cast<std::ptrdiff_t>(step) + 1, copy);
    });
}

Result<std::string> with_removed_step(const LessonSource& source, std::size_t step) {
    return edited(source, step, [&](Json& lesson) {
        if (lesson["steps"].size() < 2) throw Refusal(source.name + ": a lesson needs at least one step");
        lesson["steps"].erase(step);
    });
}

Result<std::string> with_choice(const LessonSource& source, std::size_t step) {
    return edited_step(source, step, [&](Json& whole) {
        Json& choices = whole["ask"]["choices"];
        const std::string number = " (" + std::to_string(choices.size() + 1) + ")";  // no two choices may be equal
        choices.push_back({{"say", template_texts.wrong + number}, {"why", template_texts.why}});
    });
}

Result<std::string> with_start(const LessonSource& source, std::size_t step, const Params& params,
                               const std::string& preset) {
    return edited_step(source, step, [&](Json& whole) {
        whole["state"] = state_of_step(params, preset, source.name);
        whole.erase("layout");  // the state contains it now
    });
}

Result<std::string> with_revealed(const LessonSource& source, std::size_t step, const Params& start,
                                  const Params& revealed) {
    return edited_step(source, step, [&](Json& whole) {
        Params now = revealed;
        now.ui = start.ui;
        whole["reveal"]["set"] = settings_as_json(settings_to(start, now));
    });
}

}  // namespace viewing
