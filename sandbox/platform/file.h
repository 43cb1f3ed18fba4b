// Writing a whole file so that nobody ever finds half of it. Every file a command writes goes through here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "text/result.h"

namespace viewing {

/// Puts `bytes` into `path`: first into a new file beside it, which then takes its name, so that a failure leaves what
/// was there before. A link is followed; a device or pipe (/dev/null) is written into, never replaced. The sentence
/// of a failure names the path and the system's reason.
Status write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

}  // namespace viewing
