// The search for a view where a sort key of the painter's algorithm fails: its button, and its result.
#pragma once

#include "platform/background.h"
#include "session/session.h"
#include "topics/hidden/methods/failure_search.h"
#include "topics/hidden/shown/hidden_status.h"

namespace viewing {

struct FailureFinder {
    /// The input of a search; any change cancels the search.
    struct Asked {
        int scene_version = -1;
        VisibilityParams visibility;
        CameraParams camera;
        ProjectionParams projection;
        bool operator==(const Asked&) const = default;
    };
    BackgroundTask<FailureView> search;
    Asked asked;
};

/// Draws the button that starts the search or, while a search runs, its progress and a button that stops it.
void draw_failure_finder(FailureFinder& finder, const Session& session, const HiddenResult& result);

/// Call once a frame. Moves the camera to the view found, unless the input has changed or the user has stopped the
/// search.
void take_failure(FailureFinder& finder, Session& session);

}  // namespace viewing
