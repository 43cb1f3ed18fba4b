#include "topics/depth/shown/cell_view.h"

#include <algorithm>
#include <cmath>

#include "text/catalogue.h"
#include "topics/depth/numbers/fragment_text.h"
#include "topics/depth/shown/cell_bar.h"
#include "topics/depth/shown/cell_layout.h"
#include "topics/depth/shown/cell_text.h"
#include "topics/depth/shown/draw_steps.h"
#include "ui/parts/look.h"
#include "ui/parts/table_parts.h"
#include "ui/parts/view_window.h"
#include "widgets/depth.h"

namespace viewing {
namespace {

ImU32 opaque(const Color& color) {
    return IM_COL32(color.r, color.g, color.b, 255);
}

/// Maps the depth range of the block to grays: dark is near, light is far. It uses neither black nor white.
class Grays {
public:
    Grays(const CellBlock& block, const FramePlan& plan) : is_reversed_(plan.depth_mapping == DepthMapping::reversed) {
        for (const BufferCell& cell : block.cells) {
            if (cell.window_depth == plan.clear_depth_value) continue;
            least_ = std::min(least_, cell.window_depth);
            greatest_ = std::max(greatest_, cell.window_depth);
        }
    }
    ImU32 of(double window_depth) const {
        const double share = greatest_ > least_ ? (window_depth - least_) / (greatest_ - least_) : 0.5;
        const double far_share = std::clamp(is_reversed_ ? 1.0 - share : share, 0.0, 1.0);
        const auto gray = static_cast<ImU32>(std::lround(45.0 + 175.0 * far_share));
        return IM_COL32(gray, gray, gray, 255);
    }

private:
    bool is_reversed_;
    double least_ = 2.0, greatest_ = -1.0;
};

/// The contents of the two grids.
struct CellPicture {
    CellTexts texts;
    std::vector<widgets::Cell> colors, depths;
};

/// Returns how many digits of the small font fit in a cell of the grid; at least 4.
int room_of(const CellBlock& block, const Rect& grid) {
    const float columns = static_cast<float>(block.size.x), rows = static_cast<float>(block.size.y);
    const float side = std::floor(std::min((grid.width() - px(8.0F)) / columns, (grid.height() - px(8.0F)) / rows));
    const ImFont* font = widgets::CurrentContext().fonts.small_number;
    if (!font) font = ImGui::GetFont();
    const float digit = font->CalcTextSizeA(font->FontSize, 1e9F, 0.0F, "0").x;
    return std::max(4, static_cast<int>(std::floor((side - px(5.0F)) / std::max(digit, 1.0F))));
}

CellPicture picture_of(const DepthData& data, const FramePlan& plan, bool is_step, const Rect& grid) {
    const CellBlock& now = data.now;
    const DepthPrecision precision = precision_of(plan.depth_format);
    CellPicture picture{cell_texts(now, precision, plan.clear_depth_value, room_of(now, grid)), {}, {}};
    const Grays grays(now, plan);
    const bool compares = is_step && data.before.size == now.size && data.before.cells.size() == now.cells.size();
    for (std::size_t i = 0; i < now.cells.size(); ++i) {
        const BufferCell& cell = now.cells[i];
        const BufferCell& before = compares ? data.before.cells[i] : cell;
        const bool is_cleared = cell.window_depth == plan.clear_depth_value;
        picture.colors.push_back({.color = opaque(cell.color),
                                  .accent = cell.color != before.color,
                                  .unwritten = is_cleared && cell.color == plan.background});
        picture.depths.push_back({.color = is_cleared ? opaque(plan.unwritten) : grays.of(cell.window_depth),
                                  .text = picture.texts.texts[i],
                                  .accent = cell.stored != before.stored,
                                  .unwritten = is_cleared});
    }
    return picture;
}

/// Draws the caption above a grid. If space is short, the note about the numbers replaces the title.
void caption(const Rect& grid, float height, const std::string& title, const std::string& note) {
    if (height < 1.0F) return;
    const bool is_large = height > px(18.0F);
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    ImGui::PushFont(is_large ? fonts.text : fonts.note);
    ImGui::SetCursorScreenPos({grid.min.x + px(4.0F), grid.min.y - height});
    const float room = grid.width() - px(8.0F);
    const std::string full = note.empty() ? title : say("{title}: {note}", "title"_a = title, "note"_a = note);
    const bool fits = note.empty() || ImGui::CalcTextSize(full.c_str()).x <= room;
    ImGui::TextUnformatted(widgets::Shortened(fits ? full : note, room).c_str());
    widgets::Record(full.c_str());
    ImGui::PopFont();
}

/// The tooltip must stay small, so as not to hide the neighboring cells.
void cell_tooltip(const BufferCell& cell, glm::ivec2 pixel, const DepthPrecision& precision) {
    const std::string title = say("pixel ({x}, {y})", "x"_a = pixel.x, "y"_a = pixel.y);
    const std::string stored = precision.is_float
                                   ? say("stored {code}", "code"_a = bits_text(cell.stored))
                                   : say("stored {code} of 2{power} − 1", "code"_a = code_text(cell.stored, precision),
                                         "power"_a = raised_text(precision.bits));
    const std::string body = stored + "\nz_window " + number_text(cell.window_depth, 9);
    widgets::Tooltip(title.c_str(), body.c_str());
}

/// Returns the index of a pixel's cell; −1 if the pixel is outside the block.
int cell_of(const CellBlock& block, glm::ivec2 pixel) {
    const glm::ivec2 at = pixel - block.first_pixel;
    if (at.x < 0 || at.y < 0 || at.x >= block.size.x || at.y >= block.size.y) return -1;
    return at.y * block.size.x + at.x;
}

glm::ivec2 pixel_of(const CellBlock& block, int cell) {
    return block.first_pixel + glm::ivec2(cell % block.size.x, cell / block.size.x);
}

/// Whether the view shows the whole frame: the call index is negative or past the last call.
bool shows_whole_frame(const ViewParams& view, const std::vector<DrawCall>& calls) {
    return view.call < 0 || view.call >= std::ssize(calls);
}

/// Draws the two linked grids; returns the cell under the pointer, or −1.
int draw_grids(ViewParams& view, const DepthData& data, const FramePlan& plan, const CellLayout& layout) {
    const CellBlock& block = data.now;
    const DepthPrecision precision = precision_of(plan.depth_format);
    const CellPicture picture = picture_of(data, plan, !shows_whole_frame(view, data.calls), layout.depths);
    caption(layout.colors, layout.caption_height, tr("Color buffer"), "");
    caption(layout.depths, layout.caption_height, tr("Depth buffer"),
            widgets::IsCovered("note:codes") ? "" : picture.texts.note);
    widgets::MarkTarget("note:codes");

    // Each grid highlights the cell that is under the pointer in the other grid, one frame later.
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID lit_id = ImGui::GetID("lit");
    const int lit = storage.GetInt(lit_id, -1);
    const bool is_pinned = (view.pixel || view.pin) && data.pixel;
    int selected = is_pinned ? cell_of(block, data.pixel->pixel) : -1, hovered = -1;
    bool changed = false;
    const auto grid = [&](const char* id, const std::vector<widgets::Cell>& cells, const Rect& rect) {
        int under = -1;
        ImGui::SetCursorScreenPos(rect.min);
        changed |= widgets::CellGrid(id, cells, block.size.x, block.size.y, selected,
                                     {.lit = lit, .hovered = &under, .size = {rect.width(), rect.height()}});
        if (under < 0) return;
        hovered = under;
        if (under < std::ssize(block.cells)) cell_tooltip(block.cells[under], pixel_of(block, under), precision);
    };
    grid("colours", picture.colors, layout.colors);
    grid("depths", picture.depths, layout.depths);
    storage.SetInt(lit_id, hovered);
    if (!changed) return hovered;
    view.pin.reset();
    view.pixel = selected >= 0 ? std::optional(pixel_of(block, selected)) : std::nullopt;
    return hovered;
}

/// Whether the fragments of the call can be described. Those of mirror images and shadows cannot.
bool tells_fragments(const FramePlan& plan, const std::vector<DrawCall>& calls, int call) {
    const std::size_t pass = calls[call].pass;
    return pass < plan.passes.size() && !plan.passes[pass].is_mirror_image &&
           plan.passes[pass].shading != Shading::flat;
}

/// Describes the step's effect on a cell. A `cell` of −1 means no cell.
std::string told(const ViewParams& view, const DepthData& data, const FramePlan& plan, int cell) {
    const auto index = static_cast<std::size_t>(cell);
    if (shows_whole_frame(view, data.calls))
        return widgets::HasPlainTitles() || widgets::CurrentContext().printed
                   ? tr("All draw calls are done.")
                   : tr("All draw calls are done. Go back a step to see the comparison that decides a pixel.");
    if (step_of({view.call, view.triangle}, data.calls) <= 0)
        return tr("Nothing is drawn yet: both buffers hold their clear values.");
    if (cell < 0) return tr("Point at a cell to see the comparison that decides it.");
    if (index >= data.now.cells.size() || index >= data.before.cells.size()) return "";
    const BufferCell &before = data.before.cells[index], &after = data.now.cells[index];
    const std::optional<Fragment> incoming = index < data.incoming.size() ? data.incoming[index] : std::nullopt;
    if (!incoming && before == after && !tells_fragments(plan, data.calls, view.call))
        return tr("This triangle leaves the pixel unchanged.");
    return say(cell_sentence(incoming, before, after, precision_of(plan.depth_format)));
}

void draw_sentence(const std::string& sentence, const Rect& rect) {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    const bool is_large = rect.height() > px(18.0F) && rect.height() < px(25.0F);
    ImGui::PushFont(is_large ? fonts.text : fonts.note);
    ImGui::SetCursorScreenPos({rect.min.x + px(4.0F), rect.min.y});
    const float width = rect.width() - px(8.0F), line = ImGui::GetTextLineHeight();
    const std::string broken = widgets::BrokenAtBlanks(sentence, width);
    const bool fits = ImGui::CalcTextSize(broken.c_str(), nullptr, false, width).y <= rect.height() + 1.0F;
    const bool is_one_line = rect.height() < 1.9F * line;
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    ImGui::TextUnformatted(fits ? broken.c_str()
                                : widgets::Shortened(sentence, is_one_line ? width : 1.8F * width).c_str());
    ImGui::PopTextWrapPos();
    widgets::Record(sentence.c_str());
    ImGui::PopFont();
    if (!fits) widgets::Tooltip("", sentence.c_str());
}

}  // namespace

void draw_cell_view(Session& session, const DepthData& data, const FramePlan& plan, const Rect& rect,
                    widgets::StepPlayer& player) {
    const ViewWindow window("cell view", rect, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    Params& params = session.params;
    if (!is_drawn_by_gl_alone(params.visibility.method)) {
        if (offer("GL's depth buffer fills one draw call at a time; other methods have their own steps.",
                  "Use the GL depth buffer"))
            params.visibility.method = VisibilityMethod::depth_buffer;
        return;
    }
    if (data.calls.empty()) {
        offer("Nothing to draw.");
        return;
    }
    const widgets::Group group("cells");
    const CellLayout layout = lay_out_cells(rect);
    if (!widgets::CurrentContext().printed) draw_cell_bar(session, data, plan, layout, player);
    if (data.now.cells.empty() || data.now.size.x <= 0) {
        ImGui::SetCursorScreenPos({layout.colors.min.x, layout.colors.min.y - layout.caption_height});
        offer("Point at the camera view, or click a pixel to pin it.");
        return;
    }
    int cell = draw_grids(params.view, data, plan, layout);
    if (cell < 0 && data.pixel) cell = cell_of(data.now, data.pixel->pixel);
    draw_sentence(told(params.view, data, plan, cell), layout.sentence);
}

glm::ivec2 cell_block_size(const Rect& rect, const std::optional<glm::ivec2>& asked) {
    return asked.value_or(lay_out_cells(rect).block);
}

}  // namespace viewing
