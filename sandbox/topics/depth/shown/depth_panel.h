// The panel's section on the depth buffer: the buffer's format, depth fighting, and how depths are displayed.
#pragma once

#include "frame/derive.h"
#include "session/session.h"
#include "text/catalogue.h"

namespace viewing {

/// The names of the formats and mappings in controls.
inline constexpr const char* depth_format_names[] = {
    marked("4 bit"),  marked("5 bit"),  marked("6 bit"),  marked("7 bit"),  marked("8 bit"),  marked("9 bit"),
    marked("10 bit"), marked("11 bit"), marked("12 bit"), marked("16 bit"), marked("24 bit"), marked("32 bit float")};
inline constexpr const char* depth_mapping_names[] = {marked("standard"), marked("reversed"), marked("logarithmic")};

void draw_depth_section(Session& session, const Derived& derived);

}  // namespace viewing
