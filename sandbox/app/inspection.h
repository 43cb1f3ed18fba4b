// The buffer values that the views and the status bar show, read back only while one of them is visible.
#pragma once

#include "app/shown_frame.h"
#include "session/session.h"
#include "topics/depth/measured/depth_inspector.h"
#include "topics/depth/measured/fighting_counter.h"
#include "topics/why/numbers/why.h"
#include "ui/views/views.h"

namespace viewing {

class Inspection {
public:
    explicit Inspection(Renderer& renderer) : renderer_(renderer) {}

    /// Forgets the values. Call when the pictures have changed.
    void forget() {
        inspector_.forget();
        why_.reset();
    }

    /// Reads the values that the views need from this frame. If `at_once`, waits for all of them.
    Status read(const ShownFrame& shown, const Session& session, const ViewState& views, bool at_once);

    /// Returns the values and, if a view shows depth fighting, its counts, which belong to the state at rest even
    /// during an animation. If `at_once`, waits for the counts. `is_held` says whether something is being dragged.
    DepthData data(const ShownFrame& shown, const Session& session, bool at_once, bool is_held);

    /// Returns the explanation of the inspected pixel; null if no view explains it.
    const std::shared_ptr<const Why>& why() const { return why_; }

    /// Returns the report on one more pixel of the camera's picture, for the status bar. If `at_once`, waits for it.
    /// Otherwise the report may arrive a few frames later; until then, returns the previous one.
    std::optional<PixelReport> at(const ShownFrame& shown, const Session& session, glm::ivec2 size_px, glm::ivec2 pixel,
                                  bool at_once);
    /// Call in a frame whose status bar shows no pixel.
    void leave_pixel() { follows_ = false; }

    /// Whether a pixel for the views or the status bar is being read.
    bool reads_back() const { return reads_ || follows_; }
    /// Whether counting or reading needs more frames.
    bool wants_frames() const { return (tells_fighting_ && fighting_.wants_frames()) || reads_back(); }

private:
    void explain(const ShownFrame& shown, const Session& session);

    Renderer& renderer_;
    DepthInspector inspector_;
    std::shared_ptr<const Why> why_;  ///< of the inspector's pixel
    FightingCounter fighting_;
    bool tells_fighting_ = false;
    bool reads_ = false, follows_ = false;
};

}  // namespace viewing
