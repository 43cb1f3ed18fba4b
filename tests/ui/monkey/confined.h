// A monkey may press Save anywhere: from here on nothing outside a folder can be written.
#pragma once

#include <filesystem>

namespace viewing::test {

/// This process, and what it starts, may write below `folder` and to devices alone. False where the system cannot see
/// to that (Linux's Landlock, since 5.13).
bool confine_to(const std::filesystem::path& folder);

}  // namespace viewing::test
