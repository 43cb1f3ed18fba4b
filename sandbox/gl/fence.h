// A fence after all earlier GL commands: reports whether GL has finished them, without waiting.
#pragma once

#include <utility>

#include "gl/gl.h"

namespace viewing::gl {

/// Move-only; an empty fence needs no context.
class Fence {
public:
    Fence() = default;
    static Fence after_all_so_far() {
        Fence fence;
        fence.sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        return fence;
    }
    Fence(Fence&& other) noexcept : sync_(std::exchange(other.sync_, nullptr)) {}
    Fence& operator=(Fence&& other) noexcept {
        std::swap(sync_, other.sync_);
        return *this;
    }
    ~Fence() {
        if (sync_ != nullptr) glDeleteSync(sync_);
    }

    explicit operator bool() const { return sync_ != nullptr; }
    /// Returns whether the earlier commands have finished; true for an empty fence. Flushes the commands, so that they
    /// will finish.
    bool has_passed() const {
        if (sync_ == nullptr) return true;
        return glClientWaitSync(sync_, GL_SYNC_FLUSH_COMMANDS_BIT, 0) != GL_TIMEOUT_EXPIRED;
    }

private:
    GLsync sync_ = nullptr;
};

}  // namespace viewing::gl
