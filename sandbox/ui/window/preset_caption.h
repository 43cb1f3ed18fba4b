// The open preset's sentence below the camera's picture: readable from the back row, and marked once the state differs
// from the preset's.
#pragma once

#include <optional>

#include "session/session.h"
#include "ui/parts/layout.h"
#include "widgets/widgets.h"

namespace viewing {

/// Whether the user has folded the caption. If nullopt, the caption is folded whenever its sentence would take up too
/// much of the picture.
using CaptionFold = std::optional<bool>;

struct Caption {
    float height_px = 0.0F;  ///< 0: no caption
    bool is_folded = false;  ///< shows only the preset's title
};

/// Returns the caption's height below a picture of this size, and whether it is folded. Needs the context's fonts, but
/// no frame.
Caption caption_of(const NamedFile& preset, const widgets::Context& context, ImVec2 picture_px, CaptionFold wanted);

/// Draws the caption. A click folds or unfolds it; "restore" returns to the preset's state.
void draw_caption(const NamedFile& preset, Session& session, const Rect& rect, bool is_folded, CaptionFold& wanted);

}  // namespace viewing
