// Checks for any drawn diagram: its vertices are finite and not too many, and its boxes do not overlap. Also runs
// checks in every theme and at two scales.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "widget_test.h"

namespace widgets::test {

inline ImVec2 center(const Harness& ui, const std::string& label) {
    const RecordedItem& item = ui.find(label);
    return ImVec2(0.5F * (item.min.x + item.max.x), 0.5F * (item.min.y + item.max.y));
}

/// Expects that all vertices are finite and few enough for 16-bit indices.
inline void expect_finite_picture() {
    const ImDrawData& picture = *ImGui::GetDrawData();
    EXPECT_LT(picture.TotalVtxCount, 65'000);
    for (int list = 0; list < picture.CmdListsCount; ++list) {
        for (const ImDrawVert& corner : picture.CmdLists[list]->VtxBuffer) {
            ASSERT_TRUE(std::isfinite(corner.pos.x) && std::isfinite(corner.pos.y));
        }
    }
}

inline void expect_apart(const std::vector<RecordedItem>& items) {
    for (std::size_t i = 0; i < items.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const bool apart = items[i].max.x <= items[j].min.x || items[j].max.x <= items[i].min.x ||
                               items[i].max.y <= items[j].min.y || items[j].max.y <= items[i].min.y;
            EXPECT_TRUE(apart) << items[i].label << " covers " << items[j].label;
        }
    }
}

/// Runs a check in all themes at scales 1 and 2.
inline void for_every_look(Context& context, Harness& ui, const std::function<void(float scale)>& check) {
    for (const ThemeKind theme : {ThemeKind::dark, ThemeKind::light, ThemeKind::projector}) {
        for (const float scale : {1.0F, 2.0F}) {
            context.palette = palette_of(theme);
            context.scale = scale;
            ApplyStyle(context);
            ui.frames(2);
            check(scale);
        }
    }
}

}  // namespace widgets::test
