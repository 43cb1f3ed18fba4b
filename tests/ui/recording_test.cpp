// Records frames as figures, without GL: random tables, and the windows of presets.
#include <cstdlib>
#include <random>

#include "desk.h"
#include "recorded_letters.h"
#include "state/presets.h"
#include "trials.h"

namespace viewing::test {
namespace {

Drawing recorded_frame() {
    ImGui::GetStyle().AntiAliasedLinesUseTex = false;
    return recorded(*ImGui::GetDrawData(), [](ImTextureID) { return nullptr; });
}

class RecordingTest : public UiTest {
protected:
    static void expect_whole(const std::string& what) { expect_all_letters(recorded_frame(), what); }

    /// Draws a frame with one window.
    template <typename Draw>
    void frame(const Draw& draw) {
        ImGui::GetIO().DeltaTime = 1.0F / 60.0F;
        ImGui::NewFrame();
        widgets::NewFrame(desk.workbench.widgets);
        ImGui::SetNextWindowPos({0.0F, 0.0F});
        ImGui::SetNextWindowSize({900.0F, 700.0F});
        ImGui::Begin("recorded", nullptr, ImGuiWindowFlags_NoDecoration);
        draw();
        ImGui::End();
        ImGui::Render();
    }
};

/// ImGui draws a table column by column, although it makes the table's vertices row by row.
TEST_F(RecordingTest, TablesKeepEveryRowAndDigit) {
    constexpr unsigned seed = 20261126;
    std::mt19937 random(seed);
    const auto below = [&random](unsigned count) { return static_cast<int>(random() % count); };
    for (int round = 0; round < 40; ++round) {
        const int columns = 1 + below(6), rows = 1 + below(30);
        const bool scrolls = below(2) == 0, tints = below(2) == 0, fills = below(3) == 0;
        const auto number = [&] { return std::to_string(static_cast<double>(below(20'000)) / 1000.0 - 10.0); };
        const auto table = [&] {
            const ImVec2 size(200.0F + 100.0F * static_cast<float>(columns), scrolls ? 150.0F : 0.0F);
            if (!ImGui::BeginTable("table", columns, scrolls ? ImGuiTableFlags_ScrollY : 0, size)) return;
            ImGui::TableSetupScrollFreeze(0, 1);
            for (int c = 0; c < columns; ++c) ImGui::TableSetupColumn(("head " + std::to_string(c)).c_str());
            ImGui::TableHeadersRow();
            for (int r = 0; r < rows; ++r) {
                ImGui::TableNextRow();
                if (tints && r % 2 == 0) ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, IM_COL32(90, 80, 20, 90));
                for (int c = 0; c < columns; ++c) {
                    ImGui::TableNextColumn();
                    const ImVec2 at = ImGui::GetCursorScreenPos();
                    if (c == 0)
                        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + 8.0F, at.y + 8.0F}, IM_COL32_WHITE, 2.0F);
                    if (c == 1) widgets::PlateText(ImGui::GetWindowDrawList(), at, IM_COL32_WHITE, number().c_str());
                    if (c == 2)
                        ImGui::TextUnformatted("0.000");  // the same number in every row
                    else
                        ImGui::TextUnformatted(number().c_str());
                }
            }
            ImGui::EndTable();
        };
        frame([&] {
            if (fills) ImGui::TextUnformatted("before");
            ImGui::PushFont(desk.workbench.widgets.fonts.small_number);
            ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {4.0F, 0.0F});
            table();
            ImGui::PopStyleVar();
            ImGui::PopFont();
        });
        expect_whole("seed " + std::to_string(seed) + ", round " + std::to_string(round));
    }
}

/// Covers every fifth preset, or all presets with VIEWING_LONG_TESTS.
TEST_F(RecordingTest, TheWindowsOfPresetsAreComplete) {
    const std::size_t step = testing::is_long() ? 1 : 5;
    const std::vector<NamedFile> all = presets();
    for (std::size_t i = 0; i < all.size(); i += step) {
        const NamedFile& preset = all[i];
        const UiParams looks = params.ui;
        params = load_state(preset.name)->params;
        params.ui = looks;
        desk.settle();
        expect_whole(preset.name);
    }
}

class RecordedLooksTest : public RecordingTest, public ::testing::WithParamInterface<std::pair<Theme, Language>> {};

TEST_P(RecordedLooksTest, EveryTopicIsComplete) {
    for (const char* preset : {"newell-cycle", "shadow-derivation"}) {
        params = load_state(preset)->params;
        params.ui.theme = GetParam().first;
        params.ui.language = GetParam().second;
        desk.apply_looks();
        for (std::size_t topic = 0; topic < names_of<Topic>().size(); ++topic) {
            choose_topic(params, Slot::left, static_cast<Topic>(topic));
            ui.frames(3);
            expect_whole(std::string(preset) + ", " + names_of<Topic>()[topic]);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Looks, RecordedLooksTest,
                         ::testing::Values(std::pair{Theme::light, Language::en},
                                           std::pair{Theme::projector, Language::ko}));

}  // namespace
}  // namespace viewing::test
