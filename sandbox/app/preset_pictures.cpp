#include "app/preset_pictures.h"

#include <utility>

#include "topics/hidden/measured/hidden_answers.h"

namespace viewing {
Result<PresetPictures::Prepared> PresetPictures::prepare(const std::string& name, const Load& load,
                                                         const Viewport& viewport) {
    const Result<LoadedState> state = load();
    if (!state) return Error{state.error()};
    Result<Scene> scene = load_scene(state->params.scene, state->base, state->params.coplanar);
    if (!scene) return Error{scene.error()};
    Prepared prepared{name, viewport.size_px, state->params, *std::move(scene), {}, nullptr};
    prepared.derived = derive(prepared.params, prepared.scene, viewport);
    if (const auto question = hidden_question(prepared.params, prepared.derived, viewport.size_px)) {
        HiddenSurfaceSolver solver(prepared.scene);
        prepared.answer = std::make_shared<HiddenAnswer>(answer_hidden_question(solver, *question));
    }
    return prepared;
}

Status PresetPictures::draw(Prepared& prepared) {
    const glm::ivec2 size_px = prepared.size_px;
    HiddenPictures found;
    if (prepared.answer) {
        if (Status done =
                complete_difference(renderer_, prepared.params, prepared.derived, prepared.scene, *prepared.answer);
            !done)
            return done;
        found = prepared.answer->pictures;
    }
    const FramePlan frame = plan(prepared.params, prepared.derived, found);
    if (Status drawn = renderer_.draw(frame, prepared.scene, size_px, view_); !drawn) return drawn;
    gl::ColorTarget& kept = pictures_[prepared.name] = gl::ColorTarget(size_px);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, view_.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, kept.framebuffer());
    glBlitFramebuffer(0, 0, size_px.x, size_px.y, 0, 0, size_px.x, size_px.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return std::monostate{};
}

PresetPicture PresetPictures::of(const std::string& name, bool waits) {
    return of(
        name, [name] { return load_state(name); }, {384, 216}, waits);
}

PresetPicture PresetPictures::of(const std::string& name, const Load& load, glm::ivec2 size_px, bool waits) {
    if (std::optional<Result<Prepared>> prepared = preparing_.take()) {
        // A preset that cannot be drawn gets no picture; opening it reports the reason.
        if (!*prepared || !draw(**prepared)) pictures_[wanted_] = {};
    }
    if (name.empty()) return {};
    const auto kept = pictures_.find(name);
    if (kept != pictures_.end())
        return {name, reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(kept->second.texture()))};
    if (!preparing_.is_running()) {
        wanted_ = name;
        preparing_.start([name, load, viewport = renderer_.viewport(size_px)](WorkProgress&) {
            return prepare(name, load, viewport);
        });
    }
    if (!waits) return {name, nullptr};
    preparing_.wait(-1.0);
    return of(name, load, size_px, waits);
}

}  // namespace viewing
