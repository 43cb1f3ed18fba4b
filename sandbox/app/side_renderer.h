// A software renderer beside the window's own: what is measured in pictures is measured there while the window goes on,
// and comes out as every command has it, whatever draws the window. Read gl/egl_context.h for its context.
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

    /// Calls `work` with the renderer, which is made at the first call. The calling thread must have no context; of
    /// several one has its turn after the other. False: there can be no such renderer here, and nothing was called. The
    /// error is what GL complains of.
    Result<bool> lend(const std::function<void(Renderer&)>& work);

private:
    struct Parts;
    std::mutex mutex_;
    bool is_impossible_ = false;
    std::unique_ptr<Parts> parts_;
};

}  // namespace viewing
