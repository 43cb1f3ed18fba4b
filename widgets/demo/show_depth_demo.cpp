// The diagrams of depth.h: precision of the formats for one near and far, the codes of a small format, the depths of an
// invented picture, sixteen of its pixels as on the lecture's slide, and two pictures with a divider.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "widgets/demo/show_demo.h"
#include "widgets/depth.h"

namespace widgets {

namespace {

ImVec2 Tall(float height) {
    const Context& context = CurrentContext();
    return ImVec2(0.0F, height * context.scale * context.palette.type_scale);
}

/// Returns the step of an integer format at several eye distances, under the standard perspective projection.
std::vector<glm::dvec2> IntegerSteps(int bits, double near, double far) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= 60; ++i) {
        const double z = near * std::pow(far / near, i / 60.0);
        points.emplace_back(z, z * z * (far - near) / (far * near * (std::pow(2.0, bits) - 1.0)));
    }
    return points;
}

/// Returns the step of a stored float with reversed depth or, if `is_arithmetic`, the error of the depth arithmetic,
/// estimated as 10⁻⁷ near/z. Both are converted to eye distance.
std::vector<glm::dvec2> ReversedFloatSteps(double near, double far, bool is_arithmetic) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= 400; ++i) {
        const double z = near * std::pow(far / near, i / 400.5);
        const double depth = near * (far - z) / ((far - near) * z), slope = near * far / ((far - near) * z * z);
        const double step = std::pow(2.0, std::floor(std::log2(depth)) - 23.0);
        points.emplace_back(z, (is_arithmetic ? 1e-7 * near / z : step) / slope);
    }
    return points;
}

void ShowPrecision(const Palette& palette, double& near, double& far) {
    if (!Section("Precision", true, "drag near and far")) return;
    const std::vector<glm::dvec2> bits16 = IntegerSteps(16, near, far), bits24 = IntegerSteps(24, near, far),
                                  step = ReversedFloatSteps(near, far, false),
                                  arithmetic = ReversedFloatSteps(near, far, true);
    const ChartCurve curves[] = {
        {.name = "16 bit", .color = palette.mirror, .points = bits16},
        {.name = "24 bit", .color = palette.plane, .points = bits24},
        {.name = "reversed float", .color = palette.light, .points = step, .emphasized = true},
    };
    const ChartCurve terms[] = {{.name = "arithmetic", .color = palette.trouble, .points = arithmetic}};
    const DepthMark marks[] = {{"teapot", 3.2}, {"wall", 12.0}, {"tower", 14.0}, {"mountain", 70.0}};
    PrecisionChart("precision", curves, near, far,
                   {.x = {.title = "eye distance z in m", .min = 0.01, .max = 1000},
                    .y = {.title = "step Δz in m"},
                    .terms = terms,
                    .marks = marks,
                    .cursor_z = 5.5,
                    .size = Tall(280)});
}

void ShowCodes(double near, double far) {
    if (!Section("Codes", true, "hover a line")) return;
    std::vector<double> eye_distances;
    std::vector<std::uint32_t> codes;
    for (std::uint32_t code = 0; code < 64; ++code) {
        const double depth = code / 63.0;
        codes.push_back(code);
        eye_distances.push_back(near * far / (far - depth * (far - near)));
    }
    CodeTicks("codes", eye_distances, near, far, {.codes = codes, .size = Tall(150)});
}

void ShowCounts() {
    if (!Section("Counts", true, "drag the range, double-click fits")) return;
    static glm::dvec2 range(0.2, 1.0);
    static bool logarithmic = false;
    std::vector<std::uint32_t> counts(128);
    for (std::size_t i = 30; i < 120; ++i) {
        const double x = static_cast<double>(i);
        counts[i] = static_cast<std::uint32_t>(9000.0 * std::exp(-0.01 * (x - 55) * (x - 55)) +
                                               800.0 * std::exp(-0.002 * (x - 95) * (x - 95)));
    }
    Histogram("counts", counts, 0.0, 1.0, range,
              {.title = "window depth", .logarithmic = logarithmic, .unwritten = 41250, .size = Tall(150)});
    Toggle("logarithmic heights", logarithmic, false);
}

/// Shows a triangle in front of a wall, in 8 × 8 pixels: first the colors, then the depths.
void ShowCells(const Palette& palette) {
    if (!Section("Pixels one by one", true, "click pins")) return;
    constexpr int columns = 8, rows = 8;
    static int selected = 27, hovered = -1;
    std::array<std::array<char, 8>, columns * rows> texts{};
    std::array<Cell, columns * rows> colors{}, depths{};
    for (int cell = 0; cell < columns * rows; ++cell) {
        const auto i = static_cast<std::size_t>(cell);
        const int x = cell % columns, y = cell / columns;
        const bool on_wall = y < 6 && x > 0, on_triangle = y >= 2 && x >= 1 && x <= y;
        const double depth = on_triangle ? 0.3 + 0.05 * x : on_wall ? 0.82 : 1.0;
        std::snprintf(texts[i].data(), texts[i].size(), "%.2f", depth);
        const auto gray = static_cast<ImU32>(255.0 * depth);
        const bool is_new = on_triangle && y == 6;
        colors[i] = {.color = on_triangle ? palette.light
                              : on_wall   ? palette.camera
                                          : palette.ground,
                     .accent = is_new,
                     .unwritten = !on_triangle && !on_wall};
        depths[i] = {.color = IM_COL32(gray, gray, gray, 255),
                     .text = texts[i].data(),
                     .accent = is_new,
                     .unwritten = !on_triangle && !on_wall};
    }
    const float width = std::floor(0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x));
    int in_colors = -1, in_depths = -1;
    CellGrid("colours", colors, columns, rows, selected,
             {.lit = hovered, .hovered = &in_colors, .size = ImVec2(width, width)});
    ImGui::SameLine();
    CellGrid("depths", depths, columns, rows, selected,
             {.lit = hovered, .hovered = &in_depths, .size = ImVec2(width, width)});
    hovered = std::max(in_colors, in_depths);
}

void ShowDivider(const Palette& palette) {
    if (!Section("Two pictures in one area", true, "drag the line")) return;
    static float share = 0.6F;
    const ImVec2 min = ImGui::GetCursorScreenPos(), size(ImGui::GetContentRegionAvail().x, Tall(140).y);
    const ImVec2 max(min.x + size.x, min.y + size.y), top(min.x + share * size.x, min.y);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilledMultiColor(min, ImVec2(top.x, max.y), palette.camera, palette.ground, palette.ground,
                                  palette.camera);
    draw->AddRectFilledMultiColor(top, max, palette.plane, palette.ground, palette.ground, palette.plane);
    Divider("pictures", min, max, share, {.left = "standard", .right = "reversed"});
    ImGui::InvisibleButton("picture", size);
}

}  // namespace

void ShowDepthDemo() {
    static double near = 0.1, far = 100.0;
    const Palette& palette = CurrentContext().palette;
    ShowPrecision(palette, near, far);
    ShowCodes(near, far);
    ShowCounts();
    ShowCells(palette);
    ShowDivider(palette);
}

}  // namespace widgets
