// The view of how the methods' costs grow with the scene, measured in the background.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "platform/background.h"
#include "session/session.h"
#include "topics/hidden/methods/growth.h"
#include "ui/parts/layout.h"

namespace viewing {

/// A part of the window to save as a picture.
struct ViewPicture {
    Rect rect;  ///< pixels of the window
    std::filesystem::path file;
};

struct GrowthViewState {
    BackgroundTask<std::vector<GrowthRow>> measuring;
    std::shared_ptr<BackgroundLog<GrowthRow>> log;  ///< filled during the measurement
    std::array<std::vector<GrowthRow>, 3> rows;     ///< one entry per GrowthScene
    int scene = 0;                                  ///< the GrowthScene shown and measured
    int of_version = -1;                            ///< the scene version to which the current scene's rows belong
    bool shows_operations = false;
    bool was_started = false;
    bool wants_picture = false;                 ///< save a picture of the chart in the next frame
    std::optional<ViewPicture> wanted_picture;  ///< requested in this frame
};

void draw_growth_view(GrowthViewState& state, Session& session, const Rect& rect);

/// Starts the measurement before an audience needs it: on stage, the view has no buttons, and the counts take a while.
/// Shows the operations, which are the same on every machine. Does nothing if a measurement was started before.
void measure_for_stage(GrowthViewState& state, const Session& session);

/// Call once a frame, whichever view is shown. Copies the rows measured so far into `rows`, and reports an error as the
/// session's message.
void take_growth_rows(GrowthViewState& state, Session& session);

}  // namespace viewing
