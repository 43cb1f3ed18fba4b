// GL's tests of a fragment, in words and with the numbers being compared. Pure functions. See
// topics/depth/shown/pixel_view.cpp and cell_view.cpp for usage.
#pragma once

#include <optional>
#include <string>

#include "frame/pixel_report.h"
#include "topics/depth/numbers/fragments.h"

namespace viewing {

/// Returns a stored code in readable form: "15,955,400"; for a float, its value with nine decimals: "0.951018989".
std::string code_text(std::uint32_t stored, const DepthPrecision& precision);

/// Returns the bits of a float: "0x3f737602".
std::string bits_text(std::uint32_t stored);

/// Returns the comparison that the depth function makes, whether or not it is true: "12 < 15". Floats get enough
/// decimals to differ, at least 3; if 12 do not suffice, returns their bits. For GL_NEVER and GL_ALWAYS, which compare
/// nothing, returns the function's name.
std::string compare_text(CompareFunc func, std::uint32_t incoming, std::uint32_t stored,
                         const DepthPrecision& precision);

/// The outcome of a fragment's tests, in two columns.
struct TestText {
    Message compare;        ///< "812 < 812", "rounding decides", "depth test off"; empty if no depth test was reached
    Message result;         ///< "passes", "tie: fails", "culled", "stencil fails", "not sent"
    bool is_close = false;  ///< a tie, or decided by rounding

    /// Returns both columns as one text: "812 < 812  tie: fails".
    Message whole(std::string_view between = "  ") const {
        return compare.empty() ? result : listed({compare, result}, between);
    }
};
TestText test_text(const Fragment& fragment, const DepthPrecision& precision);

/// Returns "box, triangle 3"; triangles are counted from 1.
Message fragment_name(const Fragment& fragment);

/// Says what a fragment does to its pixel: "box, triangle 3: 9 < 15, so color and depth are replaced."
Message decision_sentence(const Fragment& fragment, const DepthPrecision& precision);

/// Says what a step does to a cell, which was read back before and after the step. If the readback contradicts the
/// fragment, the readback takes precedence. If the fragment cannot have caused the change, describes only the change.
Message cell_sentence(const std::optional<Fragment>& incoming, const BufferCell& before, const BufferCell& after,
                      const DepthPrecision& precision);

/// Returns the index of the last fragment that writes its color, which is the visible one; −1 if there is none.
int seen_fragment(const std::vector<Fragment>& fragments);

}  // namespace viewing
