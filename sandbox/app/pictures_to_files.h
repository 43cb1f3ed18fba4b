// Writes files with the pictures that the user requests in the window: F12's snapshot and a view's Save PNG.
#pragma once

#include <filesystem>

#include "app/studio.h"

namespace viewing {

/// Writes the camera's view with its state into `folder`, in a file named after the current time.
void write_snapshot(const Renderer& renderer, Studio& studio, const std::filesystem::path& folder);

/// Writes the chart of the methods' cost growth.
void write_view_picture(Renderer& renderer, Studio& studio, const std::filesystem::path& file);

}  // namespace viewing
