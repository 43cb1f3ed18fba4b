#include "grading/lesson_check.h"

#include <algorithm>

#include "grading/lesson_numbers.h"
#include "lesson/allowed.h"
#include "lesson/append.h"
#include "lesson/filled_text.h"
#include "lesson/questions/question_kind.h"
#include "lesson/questions/typed_matrix.h"
#include "state/file/state_json.h"
#include "text/words.h"

namespace viewing {
namespace {

/// Returns a value in a form that is short enough for a sentence.
std::string shortly(const Json& value) {
    constexpr std::size_t longest = 120;
    std::string text = value.dump();
    return text.size() > longest ? text.substr(0, longest) + "…" : text;
}

class StepCheck {
public:
    StepCheck(const Lesson& lesson, const LessonStep& step, const Measurer& measurer)
        : lesson_(lesson), step_(step), measurer_(measurer) {}

    LessonFindings all() {
        check_texts();
        check_tags();
        check_marks();
        if (!load_scenes()) return findings_;
        {
            LessonNumbers before(step_.start.params, step_.start.params, *scene_, measurer_);
            check_claims(step_.claims_before, "claims_before", before);
            if (!kind_of(step_.ask).is_on_screen) check_answers(before);
        }
        // A reveal's text is filled in immediately, without measurements.
        LessonNumbers at_once(step_.start.params, step_.start.params, *scene_, nullptr);
        const Result<LessonText> told = filled(step_.reveal.say, with_constants(step_.ask, at_once.surroundings()));
        if (!told) find("reveal.say: " + told.error());
        if (kind_of(step_.ask).is_on_screen) check_goal();
        LessonNumbers after(step_.revealed, step_.start.params, *revealed_scene_, measurer_);
        check_claims(step_.claims, "claims", after);
        return findings_;
    }

private:
    void find(const std::string& what) { findings_.push_back(lesson_.id + ", step " + step_.id + ": " + what); }

    std::optional<Scene> scene_of(const Params& params) {
        Result<Scene> scene = load_scene(params.scene, step_.start.base, params.coplanar,
                                         {.origin = step_.start.scene_origin, .reach = step_.start.reach});
        if (!scene) {
            find(scene.error());
            return std::nullopt;
        }
        return *std::move(scene);
    }

    bool load_scenes() {
        scene_ = scene_of(step_.start.params);
        revealed_scene_ = scene_of(step_.revealed);
        return scene_ && revealed_scene_;
    }

    /// Finds template texts that the author of a saved step has not replaced.
    void check_texts() {
        const auto check = [&](const LessonText& text, const char* placeholder, const std::string& where) {
            if (text.by_language[0] == placeholder)
                find(where + " is still the template's text \"" + std::string(placeholder) + "\"");
        };
        check(step_.say, template_texts.say, "say");
        check(step_.ask.question, template_texts.question, "ask.question");
        for (std::size_t i = 0; i < step_.ask.choices.size(); ++i) {
            const LessonChoice& choice = step_.ask.choices[i];
            const std::string where = "ask.choices[" + std::to_string(i) + "].";
            check(choice.say, choice.right ? template_texts.right : template_texts.wrong, where + "say");
            check(choice.why, template_texts.why, where + "why");
        }
        check(step_.reveal.say, template_texts.reveal, "reveal.say");
    }

    /// Finds a mark whose name is the same as that of the followed point in the picture.
    void check_marks() {
        if (!step_.target || !step_.start.params.follow) return;
        const std::string label = step_.target->label.in_english();
        if (label == "p" || label == "q") find("layout.target is a second " + label + " beside the followed point");
    }

    void check_tags() {
        const auto check = [&](const std::string& tag) {
            const auto same = [&](const auto& known) { return known.first == tag; };
            if (!tag.empty() && std::none_of(lesson_.tags.begin(), lesson_.tags.end(), same))
                find("the tag " + excerpt(tag) + " is not among the lesson's tags");
        };
        for (const LessonChoice& choice : step_.ask.choices) check(choice.tag);
        for (const WrongAnswer& wrong : step_.ask.wrong) check(wrong.tag);
    }

    void check_claims(const std::vector<std::string>& claims, const char* field, LessonNumbers& numbers) {
        for (std::size_t i = 0; i < claims.size(); ++i) {
            const std::string where = std::string(field) + "[" + std::to_string(i) + "]: " + claims[i];
            const Result<bool> fine = holds(claims[i], with_constants(step_.ask, numbers.surroundings()));
            if (!fine)
                find(where + ": " + fine.error());
            else if (!*fine)
                find(where + " does not hold" + sides(claims[i], numbers));
        }
    }

    /// Returns the values on both sides of a claim's comparison; "" if the claim is not a comparison.
    std::string sides(const std::string& claim, LessonNumbers& numbers) const {
        for (const char* const sign : {"==", "~=", "<=", ">=", "<", ">"}) {
            const std::size_t at = claim.find(sign);
            if (at == std::string::npos) continue;
            const Surroundings surroundings = with_constants(step_.ask, numbers.surroundings());
            const std::string side[] = {claim.substr(0, at), claim.substr(at + std::string_view(sign).size())};
            const Result<Json> left = evaluate(side[0], surroundings);
            const Result<Json> right = evaluate(side[1], surroundings);
            if (!left || !right) return "";
            return "; its sides are " + shortly(*left) + " and " + shortly(*right);
        }
        return "";
    }

    /// Adds a finding unless a wrong answer is recognized by its own entry in ask.wrong, and by no earlier entry.
    void expect_told(const Result<Verdict>& verdict, const WrongAnswer& wrong, const std::string& where) {
        if (!verdict)
            find(where + ": " + verdict.error());
        else if (verdict->right)
            find(where + " is accepted as right");
        else if (verdict->say.empty())
            find(where + " is not recognized");
        else if (!(verdict->say == wrong.say))
            find(where + " gets the feedback of another answer: " + verdict->say.in_english());
    }

    void check_answers(LessonNumbers& numbers) {
        const Ask& ask = step_.ask;
        const Result<Answer> model = model_answer(ask, numbers.surroundings());
        if (!model) return find("ask.expect: " + model.error());
        const Result<Verdict> verdict = judge(ask, *model, numbers.surroundings());
        if (!verdict)
            find("ask: " + verdict.error());
        else if (!verdict->right)
            find("ask: the model answer is not accepted");
        if (!ask.factors.empty())
            if (const auto products = products_of(ask, model->items, with_constants(ask, numbers.surroundings()));
                !products)
                find("ask.factors: " + products.error());
        for (std::size_t i = 0; i < ask.wrong.size(); ++i) {
            const std::string where = "ask.wrong[" + std::to_string(i) + "]";
            if (ask.wrong[i].sample.empty())
                find(where + ".try is missing: an answer that it recognizes");
            else
                expect_told(judge(ask, ask.wrong[i].sample, numbers.surroundings()), ask.wrong[i], where);
        }
    }

    Result<Verdict> judge_goal(const Params& params) {
        const std::optional<Scene> scene = scene_of(params);
        if (!scene) return Error{"its scene cannot be loaded"};
        LessonNumbers numbers(params, step_.start.params, *scene, measurer_);
        return judge(step_.ask, {}, numbers.surroundings());
    }

    void check_goal() {
        const Ask& ask = step_.ask;
        const Params& start = step_.start.params;
        const auto with = [&](const std::vector<std::string>& settings) {
            return *apply_settings(start, settings);  // the reader has already checked them
        };
        if (const Result<Verdict> begun = judge_goal(start); !begun)
            return find("ask.until: " + begun.error());
        else if (begun->right)
            find("ask.until already holds at the beginning");
        const Params model = with(ask.model);
        if (const Result<Verdict> reached = judge_goal(model); !reached || !reached->right)
            find("ask.model does not reach the goal" + (reached ? std::string() : ": " + reached.error()));
        check_allowed(start, model);
        for (std::size_t i = 0; i < ask.wrong.size(); ++i) {
            const std::string where = "ask.wrong[" + std::to_string(i) + "]";
            if (ask.wrong[i].settings.empty())
                find(where + ".try is missing: settings that it recognizes");
            else
                expect_told(judge_goal(with(ask.wrong[i].settings)), ask.wrong[i], where);
        }
    }

    void check_allowed(const Params& start, const Params& model) {
        for (const std::string& path : changed_without_leave(start, model, step_.ask.allow))
            find("ask.model changes " + path + ", which ask.allow does not list");
    }

    const Lesson& lesson_;
    const LessonStep& step_;
    const Measurer& measurer_;
    std::optional<Scene> scene_, revealed_scene_;
    LessonFindings findings_;
};

}  // namespace

LessonFindings check_step(const Lesson& lesson, const LessonStep& step, const Measurer& measurer) {
    return StepCheck(lesson, step, measurer).all();
}

}  // namespace viewing
