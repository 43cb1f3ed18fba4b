// The open preset's sentence below the camera's picture: in type that is read from the back row, and marked as soon as
// the state is no longer the preset's.
#pragma once

#include <optional>

#include "session/session.h"
#include "ui/parts/layout.h"
#include "widgets/widgets.h"

namespace viewing {

/// How a person wants the caption; none: folded where its sentence would take too much of the picture.
using CaptionFold = std::optional<bool>;

struct Caption {
    float height_px = 0.0F;  ///< 0: there is none
    bool is_folded = false;  ///< the preset's title alone
};

/// What a preset's caption needs below a picture of this size. Needs the context's fonts, no frame.
Caption caption_of(const NamedFile& preset, const widgets::Context& context, ImVec2 picture_px, CaptionFold wanted);

/// Draws it into its place. A click on it folds it; "as it was" brings the preset's state back.
void draw_caption(const NamedFile& preset, Session& session, const Rect& rect, bool is_folded, CaptionFold& wanted);

}  // namespace viewing
