// The result of the hidden-surface method in the camera's view, kept up to date without blocking the window. Read
// topics/hidden/measured/hidden_worker.h next.
#pragma once

#include "render/renderer.h"
#include "session/session.h"
#include "topics/hidden/measured/hidden_worker.h"

namespace viewing {

class ShownAnswer {
public:
    /// Asks the worker for the result that the camera's view needs, and waits for it briefly. If the result takes
    /// longer, a later call picks it up. If `is_interactive` is false, waits without a limit.
    Status update(Renderer& renderer, const Params& params, const Derived& derived, const Session& session,
                  glm::ivec2 camera_px, bool is_interactive);

    void cancel() { worker_.cancel(); }
    /// Restarts a request that was canceled.
    void restart();

    const std::shared_ptr<const HiddenAnswer>& get() const { return answer_; }
    bool is_behind() const { return is_behind_; }  ///< a newer result is pending
    std::optional<float> fraction() { return worker_.fraction(); }

private:
    HiddenWorker worker_;
    std::shared_ptr<const HiddenAnswer> answer_;
    DepthParams depth_;  ///< the settings for which the difference was computed
    bool is_behind_ = false;
};

}  // namespace viewing
