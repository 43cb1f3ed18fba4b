// What the tests of GL do with a fragment, in words and with the numbers of the compare. Pure. Read pixel_view.cpp and
// cell_view.cpp for their use.
#pragma once

#include <optional>
#include <string>

#include "frame/depth/fragments.h"
#include "frame/pixel_report.h"

namespace viewing {

/// A stored code to be read aloud: "15,955,400"; of a float its value with nine decimals: "0.951018989".
std::string code_text(std::uint32_t stored, const DepthPrecision& precision);

/// The bits of a float: "0x3f737602".
std::string bits_text(std::uint32_t stored);

/// "12 < 15" as the depth function asks it, whether it is true or not. Floats get as many decimals as tell them apart,
/// at least 3; where 12 do not, their bits. GL_NEVER and GL_ALWAYS ask nothing: their names.
std::string compare_text(CompareFunc func, std::uint32_t incoming, std::uint32_t stored,
                         const DepthPrecision& precision);

/// The decision about a fragment in two columns.
struct TestText {
    std::string compare;    ///< "812 < 812", "rounding decides", "depth test off"; empty: depth was not compared
    std::string result;     ///< "passes", "tie: fails", "culled", "stencil fails", "not sent"
    bool is_close = false;  ///< a tie, or decided by rounding

    /// "812 < 812  tie: fails".
    std::string whole() const { return compare.empty() ? result : compare + "  " + result; }
};
TestText test_text(const Fragment& fragment, const DepthPrecision& precision);

/// "box, triangle 3": triangles count from 1 on.
std::string fragment_name(const Fragment& fragment);

/// What a fragment does to the pixel that it is sent to: "box, triangle 3: 9 < 15, so colour and depth are replaced."
std::string decision_sentence(const Fragment& fragment, const DepthPrecision& precision);

/// The same of a cell of a block as it was read back before a step and after it: what has changed decides. Without a
/// fragment that can have done that: whether the step leaves the cell as it was.
std::string cell_sentence(const std::optional<Fragment>& incoming, const BufferCell& before, const BufferCell& after,
                          const DepthPrecision& precision);

/// The last fragment whose colour is written: the one that is seen. −1: none.
int seen_fragment(const std::vector<Fragment>& fragments);

}  // namespace viewing
