// The hidden-surface methods' answer that the camera's view shows, kept up to date while the window stays live. Read
// measure/hidden_worker.h next.
#pragma once

#include "measure/hidden_worker.h"
#include "render/renderer.h"
#include "session/session.h"

namespace viewing {

class ShownAnswer {
public:
    /// Asks the worker for what the camera's view needs; what is not there in a moment is taken when it comes.
    Status update(Renderer& renderer, const Params& params, const Derived& derived, const Session& session,
                  glm::ivec2 camera_px, bool is_interactive);

    void cancel() { worker_.cancel(); }
    /// Begins again on a question that was cancelled.
    void restart();

    const std::shared_ptr<const HiddenAnswer>& get() const { return answer_; }
    bool is_behind() const { return is_behind_; }  ///< a newer answer is awaited
    std::optional<float> fraction() { return worker_.fraction(); }

private:
    HiddenWorker worker_;
    std::shared_ptr<const HiddenAnswer> answer_;
    DepthParams depth_;  ///< that its difference was made with
    bool is_behind_ = false;
};

}  // namespace viewing
