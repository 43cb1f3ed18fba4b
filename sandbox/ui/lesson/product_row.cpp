#include "ui/lesson/product_row.h"

#include <algorithm>
#include <cmath>

#include "text/numbers.h"
#include "ui/lesson/lesson_text.h"
#include "ui/parts/drawn_subscripts.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

/// Sizes in pixels. They do not depend on the numbers, so that nothing else moves when the tiles do.
struct ProductSizes {
    static constexpr float column_gap = 6.0F, bracket = 5.0F, matrix_gap = 14.0F, line_gap = 4.0F;  ///< design pixels
    static constexpr int characters = 5, decimals = 2;                                              ///< for −0.56

    explicit ProductSizes(const widgets::Context& context)
        : font(context.fonts.small_number),
          name_font(context.fonts.text),
          scale(context.scale),
          entry(font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0F, "0").x * static_cast<float>(characters)),
          width(4.0F * entry + 3.0F * column_gap * scale + 2.0F * bracket * scale),
          height(name_font->FontSize + 4.0F * font->FontSize + 3.0F * line_gap * scale) {}

    std::size_t columns(float room) const {
        const float gap = matrix_gap * scale;
        return std::max<std::size_t>(1, static_cast<std::size_t>((room + gap) / (width + gap)));
    }

    ImFont *font, *name_font;
    float scale, entry, width, height;
};

void draw_product(const glm::dmat4& matrix, ImVec2 corner, const ProductSizes& sizes) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float line = sizes.font->FontSize, right = corner.x + sizes.width, bottom = corner.y + 4.0F * line;
    for (const float x : {corner.x, right}) {
        const float inward = x == corner.x ? px(4.0F) : -px(4.0F);
        const ImVec2 ends[] = {{x + inward, corner.y}, {x, corner.y}, {x, bottom}, {x + inward, bottom}};
        draw->AddPolyline(ends, 4, palette().quiet, 0, px(1.0F) * palette().stroke);
    }
    for (int i = 0; i < 16; ++i) {
        const NumberChars number =
            fitted_number(matrix[i % 4][i / 4], ProductSizes::decimals, Tiny::zero, {}, ProductSizes::characters);
        const auto row = static_cast<float>(i / 4), column = static_cast<float>(i % 4);
        const char* const end = number.data + number.bytes;
        const float end_x = corner.x + px(ProductSizes::bracket) + (column + 1.0F) * sizes.entry +
                            column * px(ProductSizes::column_gap);
        const float start_x = end_x - sizes.font->CalcTextSizeA(line, FLT_MAX, 0.0F, number.data, end).x;
        const bool is_zero = std::abs(matrix[i % 4][i / 4]) < 0.5e-2;
        draw->AddText(sizes.font, line, {std::floor(start_x), corner.y + row * line},
                      is_zero ? palette().quiet : palette().text, number.data, end);
    }
}

/// Returns "R_y" for "R_y(yaw)".
std::string short_name(const LessonText& item) {
    const std::string& name = item.shown();
    return name.substr(0, name.find('('));
}

}  // namespace

float product_row_height(const Ask& ask, float width, const widgets::Context& context) {
    if (ask.factors.empty()) return 0.0F;
    const ProductSizes sizes(context);
    const std::size_t columns = sizes.columns(width);
    return static_cast<float>((ask.expected_items.front().size() + columns - 1) / columns) * sizes.height;
}

void draw_product_row(const LessonRun& run, float width) {
    const Ask& ask = run.step().ask;
    const widgets::Context& context = widgets::CurrentContext();
    const float height = product_row_height(ask, width, context);
    if (height == 0.0F) return;
    const ProductSizes sizes(context);
    const std::size_t columns = sizes.columns(width), most = ask.expected_items.front().size();
    const std::vector<int>& items = run.shown_items();
    const std::size_t count = std::min(items.size(), run.products().matrices.size());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    std::string name;
    for (std::size_t i = 0; i < count; ++i) {
        name += (i == 0 ? "" : " ") + short_name(ask.items[items[i]]);
        if (i + most < count) continue;
        const std::size_t place = i + most - std::max(count, most);
        const auto column = static_cast<float>(place % columns), row = static_cast<float>(place / columns);
        const ImVec2 at(std::floor(corner.x + column * (sizes.width + px(ProductSizes::matrix_gap))),
                        corner.y + row * sizes.height);
        draw_with_subscripts(ImGui::GetWindowDrawList(), sizes.name_font, at, palette().quiet, name);
        const float top = at.y + sizes.name_font->FontSize + px(ProductSizes::line_gap);
        ImGui::SetCursorScreenPos({at.x, top});
        ImGui::Dummy({sizes.width, 4.0F * sizes.font->FontSize});
        widgets::Record(("product " + std::to_string(i + 1)).c_str());
        draw_product(run.products().matrices[i], {at.x, top}, sizes);
    }
    ImGui::SetCursorScreenPos({corner.x, corner.y + height});
    ImGui::Dummy({0.0F, 0.0F});
}

}  // namespace viewing
