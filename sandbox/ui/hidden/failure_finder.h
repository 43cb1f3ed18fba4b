// The search for a view where a sort key of the painter's fails: its button, and its way into the session.
#pragma once

#include "platform/background.h"
#include "session/session.h"
#include "ui/hidden/hidden_status.h"
#include "visibility/failure_search.h"

namespace viewing {

struct FailureFinder {
    /// What a search was started for; when any of it changes the search is given up.
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

/// The button that starts the search, how far it is, and the button that ends it.
void draw_failure_finder(FailureFinder& finder, const Session& session, const HiddenResult& result);

/// Once a frame: what was found moves the camera, unless the person has gone on to something else or has stopped the
/// search.
void take_failure(FailureFinder& finder, Session& session);

}  // namespace viewing
