// Four pictures of the mirror image, each made in a different way, with differences marked in red.
#pragma once

#include <array>
#include <memory>

#include "session/session.h"
#include "topics/planes/numbers/mirror_ways.h"
#include "ui/parts/layout.h"

namespace viewing {

/// The pictures, and how they compare with the first one; each is null until it exists.
struct MirrorWaysShown {
    std::array<ImTextureID, mirror_way_count> pictures{};
    std::shared_ptr<const MirrorWays> ways;
};

/// Draws the four pictures. A click on a picture switches the state to the way in which that picture is made.
void draw_mirror_ways_view(Session& session, const Rect& rect, const MirrorWaysShown& shown);

}  // namespace viewing
