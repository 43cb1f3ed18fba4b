// Pictures that a person asks the window for, written beside it: F12's snapshot and a view's Save PNG.
#pragma once

#include <filesystem>

#include "app/studio.h"

namespace viewing {

/// The camera's view with its state, named by the time, in that folder.
void write_snapshot(const Renderer& renderer, Studio& studio, const std::filesystem::path& folder);

/// The chart of costs as they grow.
void write_view_picture(Renderer& renderer, Studio& studio, const std::filesystem::path& file);

}  // namespace viewing
