#include "app/side_renderer.h"

#include <optional>
#include <utility>

#include "gl/debug.h"
#include "gl/egl_context.h"
#include "platform/background.h"
#include "platform/threads.h"

namespace viewing {

struct SideRenderer::Parts {
    gl::EglContext context;
    gl::DebugLog log;
    std::optional<Renderer> renderer;

    static std::unique_ptr<Parts> make() {
        if (!can_start_threads(threads_of_a_driver())) return nullptr;
        std::optional<gl::EglContext> context = gl::EglContext::make_software();
        if (!context) return nullptr;
        auto parts = std::make_unique<Parts>(*std::move(context));
        Result<Renderer> renderer = Renderer::make();
        if (!renderer) return nullptr;
        parts->renderer.emplace(*std::move(renderer));
        parts->context.let_go();
        return parts;
    }
    explicit Parts(gl::EglContext made) : context(std::move(made)) {}
};

SideRenderer::SideRenderer() = default;

SideRenderer::~SideRenderer() {
    if (!parts_) return;
    // Destroy the context in another thread, where it can be current: here, the window's context may be current.
    const BackgroundCall end([this] {
        if (parts_->context.is_made_current()) parts_.reset();
    });
}

Result<bool> SideRenderer::lend(const std::function<void(Renderer&)>& work) {
    const std::lock_guard turn(mutex_);
    if (!parts_ && !is_impossible_) {
        parts_ = Parts::make();
        is_impossible_ = !parts_;
    }
    if (is_impossible_ || !parts_->context.is_made_current()) return false;
    work(*parts_->renderer);
    const std::vector<std::string> errors = parts_->log.errors();
    parts_->context.let_go();
    if (!errors.empty()) return Error{"GL error: " + errors.front()};
    return true;
}

}  // namespace viewing
