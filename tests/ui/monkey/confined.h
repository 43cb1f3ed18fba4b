// The monkey may press Save in any folder, so this code blocks writing outside one folder.
#pragma once

#include <filesystem>

namespace viewing::test {

/// Restricts this process and its children to writing below `folder` and to devices. Returns false if the system does
/// not support that (it needs Landlock, available since Linux 5.13).
bool confine_to(const std::filesystem::path& folder);

}  // namespace viewing::test
