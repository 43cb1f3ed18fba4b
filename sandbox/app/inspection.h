// What the views and the status bar tell of the buffers: read back when something of it is shown.
#pragma once

#include "app/shown_frame.h"
#include "measure/depth_inspector.h"
#include "measure/fighting_counter.h"
#include "session/session.h"
#include "ui/views/views.h"

namespace viewing {

class Inspection {
public:
    explicit Inspection(Renderer& renderer) : renderer_(renderer) {}

    /// The pictures have changed: everything is read again when it is wanted.
    void forget() { inspector_.forget(); }

    /// Reads what the views want of this frame. `at_once`: waits for all of it.
    Status read(const ShownFrame& shown, const Session& session, const ViewState& views, bool at_once);

    /// What was read, and of a state at rest, also while something moves by itself, how surfaces fight where that is
    /// shown. `at_once`: waits for the counts; `is_held`: something is being dragged.
    DepthData data(const ShownFrame& shown, const Session& session, bool at_once, bool is_held);

    /// One more pixel of the camera's picture, for the status bar. `at_once`: waits for it; else it may be told some
    /// frames later, and until then the one before.
    std::optional<PixelReport> at(const ShownFrame& shown, const Session& session, glm::ivec2 size_px, glm::ivec2 pixel,
                                  bool at_once);
    /// In a frame that tells none.
    void leave_pixel() { follows_ = false; }

    /// Whether a pixel is on its way, for the views or the status bar.
    bool reads_back() const { return reads_ || follows_; }
    /// Whether counting or reading goes on in further frames.
    bool wants_frames() const { return (tells_fighting_ && fighting_.wants_frames()) || reads_back(); }

private:
    Renderer& renderer_;
    DepthInspector inspector_;
    FightingCounter fighting_;
    bool tells_fighting_ = false;
    bool reads_ = false, follows_ = false;
};

}  // namespace viewing
