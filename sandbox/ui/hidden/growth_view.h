// The methods' costs as scenes grow, measured beside the window, as a view of its own.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "platform/background.h"
#include "session/session.h"
#include "ui/parts/layout.h"
#include "visibility/growth.h"

namespace viewing {

/// A part of the window that shall be written as a picture.
struct ViewPicture {
    Rect rect;  ///< pixels of the window
    std::filesystem::path file;
};

struct GrowthViewState {
    BackgroundTask<std::vector<GrowthRow>> measuring;
    std::shared_ptr<BackgroundLog<GrowthRow>> log;  ///< filled while it is measured
    std::array<std::vector<GrowthRow>, 3> rows;     ///< of each GrowthScene
    int scene = 0;                                  ///< the GrowthScene that is shown, and measured
    int of_version = -1;                            ///< the session's scene that its rows are of
    bool shows_operations = false;
    bool wants_picture = false;                 ///< of the chart, as the next frame shows it
    std::optional<ViewPicture> wanted_picture;  ///< asked for in this frame
};

void draw_growth_view(GrowthViewState& state, Session& session, const Rect& rect);

/// The rows that have been measured so far become `rows`; once a frame, whichever view is shown. What went wrong
/// becomes the session's message.
void take_growth_rows(GrowthViewState& state, Session& session);

}  // namespace viewing
