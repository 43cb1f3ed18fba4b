// The monkey may press Save anywhere, so writing outside one folder is blocked.
#pragma once

#include <filesystem>

namespace viewing::test {

/// Restricts this process and its children to writing below `folder` and to devices. Returns false if the system lacks
/// support (Linux's Landlock, since 5.13).
bool confine_to(const std::filesystem::path& folder);

}  // namespace viewing::test
