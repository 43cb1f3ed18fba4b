// The mirror image in four ways side by side, with what differs marked in red.
#pragma once

#include <array>
#include <memory>

#include "frame/planes/mirror_ways.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Pictures and counts; nothing while they have not been made yet.
struct MirrorWaysShown {
    std::array<ImTextureID, mirror_way_count> pictures{};
    std::shared_ptr<const MirrorWays> ways;
};

/// A click on a picture takes its way over into the state.
void draw_mirror_ways_view(Session& session, const Rect& rect, const MirrorWaysShown& shown);

}  // namespace viewing
