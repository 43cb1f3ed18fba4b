// QR codes, for a link on the screen that a room full of phones can scan. Only the desktop program can draw them.
#pragma once

#include <string_view>
#include <vector>

#include "text/result.h"

namespace viewing {

struct QrCode {
    /// The light margin that a reader needs on each side, in modules.
    static constexpr int quiet_modules = 4;

    int modules = 0;         ///< on each side, without the margin
    std::vector<bool> dark;  ///< row by row from the top

    bool is_dark(int row, int column) const { return dark[row * modules + column]; }
};

/// The most bytes that the largest QR code (version 40, lowest error correction) holds.
inline constexpr std::size_t most_qr_bytes = 2953;

/// Returns the smallest code that holds the text, with the best error correction that fits into its modules. The error
/// says in one sentence why there is no code: the text is too long, or this build cannot draw any.
Result<QrCode> qr_code(std::string_view text);

}  // namespace viewing
