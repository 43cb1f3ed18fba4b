// A software renderer beside the window's own. It measures pictures while the window stays responsive, and gives the
// same results as the commands, whichever driver draws the window. See gl/egl_context.h for its context.
#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "render/renderer.h"

namespace viewing {

class SideRenderer {
public:
    SideRenderer();
    ~SideRenderer();
    SideRenderer(const SideRenderer&) = delete;
    SideRenderer& operator=(const SideRenderer&) = delete;

    /// Calls `work` with the renderer, which the first call creates. The calling thread must have no context; several
    /// threads take turns. Returns false without calling `work` if no such renderer is possible here. The error is GL's
    /// message.
    Result<bool> lend(const std::function<void(Renderer&)>& work);

private:
    struct Parts;
    std::mutex mutex_;
    bool is_impossible_ = false;
    std::unique_ptr<Parts> parts_;
};

}  // namespace viewing
