#include "app/shown_answer.h"

#include "topics/hidden/measured/hidden_answers.h"

namespace viewing {

Status ShownAnswer::update(Renderer& renderer, const Params& params, const Derived& derived, const Session& session,
                           glm::ivec2 camera_px, bool is_interactive) {
    const std::optional<HiddenQuestion> question = hidden_question(params, derived, camera_px);
    if (!question) {
        worker_.forget();
        answer_.reset();
        is_behind_ = false;
        return std::monostate{};
    }
    // Wait briefly, so that fast methods keep up with the camera and slow ones do not block the window.
    constexpr double a_moment_s = 0.025;
    worker_.ask(*question, session.scene(), session.scene_version());
    worker_.wait(!is_interactive ? -1.0 : is_behind_ ? 0.0 : a_moment_s);
    const std::shared_ptr<const HiddenAnswer> answer = worker_.answer(session.scene_version());
    if (worker_.has_failed(*question, session.scene_version())) {
        answer_.reset();
        is_behind_ = false;
        if (const std::optional<std::string> why = worker_.take_failure()) return Error{*why};
        return std::monostate{};
    }
    is_behind_ = !answer || answer->question != *question;
    if (!answer) answer_.reset();  // it belonged to another scene
    // In a difference picture, GL's half also depends on the depth buffer, and both halves need the same camera.
    const bool is_shown =
        answer && answer_ && answer->camera == answer_->camera && answer->question == answer_->question;
    if (!answer || (is_shown && depth_ == session.params.depth)) return std::monostate{};
    auto completed = std::make_shared<HiddenAnswer>(*answer);
    Status done = std::monostate{};
    if (!is_behind_) done = complete_difference(renderer, params, derived, session.scene(), *completed);
    depth_ = session.params.depth;
    answer_ = std::move(completed);
    return done;
}

void ShownAnswer::restart() {
    worker_.forget();
    is_behind_ = true;
}

}  // namespace viewing
