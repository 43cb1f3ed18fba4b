#include "ui/lesson/answers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lesson/formulas/typed_number.h"
#include "lesson/questions/question_kind.h"
#include "lesson/questions/typed_matrix.h"
#include "text/catalogue.h"
#include "ui/lesson/answer_input.h"
#include "ui/lesson/lesson_text.h"
#include "ui/parts/drawn_subscripts.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

constexpr float padding_x = 10.0F, padding_y = 4.0F, entry_gap = 5.0F;  ///< design pixels
constexpr float letter_room = 24.0F;                                    ///< before a choice, for its letter
constexpr float number_width = 92.0F, widest_matrix = 460.0F;
constexpr float least_half = 330.0F;  ///< any choice fits into a column at least this wide

/// A question's choices in one or two columns: two if each column is at least `least_half` wide, or if each choice fits
/// on one line of its column.
struct Choices {
    Choices(const Ask& ask, float width, const widgets::Context& context, bool presents) {
        const float half = std::floor((width - entry_gap * context.scale) * 0.5F);
        std::vector<Paragraph> halves = texts_of(ask, half, context, presents);
        const bool are_short = std::all_of(halves.begin(), halves.end(), [](const Paragraph& text) {
            return text.lines.find('\n') == std::string::npos;
        });
        columns = width >= 2.0F * least_half * context.scale || are_short ? 2 : 1;
        one_px = columns == 2 ? half : width;
        texts = columns == 2 ? std::move(halves) : texts_of(ask, width, context, presents);
        rows_px.assign((texts.size() + columns - 1) / columns, 0.0F);
        for (std::size_t i = 0; i < texts.size(); ++i)
            rows_px[i / columns] =
                std::max(rows_px[i / columns], std::ceil(texts[i].height + 2.0F * padding_y * context.scale));
    }

    std::size_t columns;
    float one_px;  ///< the width of a choice
    std::vector<Paragraph> texts;
    std::vector<float> rows_px;  ///< the height of each row, that of its tallest choice

private:
    static std::vector<Paragraph> texts_of(const Ask& ask, float width, const widgets::Context& context,
                                           bool presents) {
        ImFont* const font = presents ? context.fonts.caption : context.fonts.text;
        std::vector<Paragraph> texts;
        for (const LessonChoice& choice : ask.choices)
            texts.push_back(
                paragraph(choice.say.shown(), font, width - (2.0F * padding_x + letter_room) * context.scale));
        return texts;
    }
};

/// Number of entry fields per row.
std::size_t numbers_in_a_row(const Ask& ask) {
    constexpr int most_in_a_row = 6;
    return static_cast<std::size_t>(ask.columns > 1 ? ask.columns : std::min(ask.rows, most_in_a_row));
}

/// The font and the sizes of tiles and fields, in pixels: larger for an audience.
struct AnswerSizes {
    AnswerSizes(const widgets::Context& context, bool presents)
        : font(presents ? context.fonts.caption : context.fonts.text),
          sign_font(presents ? context.fonts.caption : context.fonts.heading),
          scale(context.scale),
          enlarged(scale * font->FontSize / context.fonts.text->FontSize) {}

    ImFont* font;
    ImFont* sign_font;
    float scale;     ///< scale factor of gaps
    float enlarged;  ///< scale factor of everything that grows with the type

    float frame_height() const { return font->FontSize + 8.0F * scale; }
    float gap() const { return entry_gap * scale; }
    float arrow() const { return 20.0F * enlarged; }
    float letter() const { return letter_room * enlarged; }
    float padding() const { return padding_x * scale; }
    /// Extra width of a tile, for an arrow at each end or a number in front.
    float tile_extra(const Ask& ask) const { return kind_of(ask).sorts ? 2.0F * arrow() : letter(); }
    /// A tile's text, in several lines if the tile would be wider than `width`.
    Paragraph tile_text(const LessonText& item, const Ask& ask, float width) const {
        return paragraph(item.shown(), font, width - tile_extra(ask) - 2.0F * padding());
    }
    ImVec2 tile_size(const LessonText& item, const Ask& ask, float width) const {
        const Paragraph text = tile_text(item, ask, width);
        const float text_width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0F, text.lines.c_str()).x;
        return {std::min(text_width + tile_extra(ask) + 2.0F * padding(), width), text.height + 8.0F * scale};
    }
};

/// Lays out tiles in rows. Calls `place(item, x, y, size)` for each item, with x and y relative to the first tile's
/// corner. Returns the height of all rows.
template <typename Place>
float lay_out_tiles(const Ask& ask, const std::vector<int>& order, float width, const AnswerSizes& sizes,
                    const Place& place) {
    float x = 0.0F, y = 0.0F, height = 0.0F;
    for (const int item : order) {
        const ImVec2 tile = sizes.tile_size(ask.items[item], ask, width);
        if (x > 0.0F && x + tile.x > width) {
            x = 0.0F;
            y += std::exchange(height, 0.0F);
        }
        height = std::max(height, tile.y + sizes.gap());
        place(item, x, y, tile);
        x += tile.x + sizes.gap();
    }
    return y + height;
}

std::vector<int> as_written(const Ask& ask) {
    std::vector<int> order(ask.items.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    return order;
}

/// Returns the height of the rows of tiles in the question's order or in the right order, whichever is greater, so that
/// nothing moves when the answer is shown.
float tiles_height(const Ask& ask, float width, const AnswerSizes& sizes) {
    const auto height = [&](const std::vector<int>& order) {
        return lay_out_tiles(ask, order, width, sizes, [](int, float, float, ImVec2) {});
    };
    return std::max(height(as_written(ask)), kind_of(ask).sorts ? height(ask.expected_items.front()) : 0.0F);
}

struct TileLook {
    bool chosen = false, right = false, wrong = false;
};

ImU32 outline_of(const TileLook& look) {
    if (look.right) return palette().plane;
    if (look.wrong) return palette().trouble;
    return look.chosen ? palette().accent : palette().border;
}

void draw_ground(ImVec2 min, ImVec2 max, const TileLook& look, bool hovered) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float rounding = px(4.0F);
    draw->AddRectFilled(min, max, hovered ? palette().field_hovered : palette().field, rounding);
    const bool is_marked = look.chosen || look.right || look.wrong;
    draw->AddRect(min, max, outline_of(look), rounding, 0, px(is_marked ? 2.0F : 1.0F) * palette().stroke);
}

bool draw_choices(LessonRun& run, const AnswerStyle& style, float width) {
    const Ask& ask = run.step().ask;
    const widgets::Context& context = widgets::CurrentContext();
    const float scale = context.scale;
    const Choices choices(ask, width, context, style.presents);
    const float one = choices.one_px;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    Answer& answer = run.answer();
    bool given = false;
    float y = corner.y;
    for (std::size_t i = 0; i < ask.choices.size(); ++i) {
        const std::size_t column = i % choices.columns;
        const float height = choices.rows_px[i / choices.columns];
        const ImVec2 min(corner.x + static_cast<float>(column) * (one + entry_gap * scale), y);
        const ImVec2 max(min.x + one, min.y + height);
        ImGui::SetCursorScreenPos(min);
        const std::string name = "choice " + std::to_string(i + 1);
        const bool pressed = ImGui::InvisibleButton(name.c_str(), {one, height});
        widgets::Record(name.c_str());
        const bool is_chosen = answer.items == std::vector<int>{static_cast<int>(i)};
        const bool is_told = run.is_tried(i) && !style.presents;
        const TileLook look{is_chosen, style.shows_right && ask.choices[i].right, is_told};
        draw_ground(min, max, look, style.is_open && ImGui::IsItemHovered());
        const char letter[] = {static_cast<char>('A' + i), '\0'};
        const Paragraph& text = choices.texts[i];
        ImDrawList* draw = ImGui::GetWindowDrawList();
        const float text_y = std::floor((min.y + max.y - text.height) * 0.5F);
        const ImU32 ink = style.shows_right && !ask.choices[i].right ? palette().quiet : palette().text;
        draw->AddText(text.font, text.font->FontSize, {min.x + padding_x * scale, text_y}, palette().accent, letter);
        draw_with_subscripts(draw, text.font, {min.x + (padding_x + letter_room) * scale, text_y}, ink, text.lines);
        if (pressed && style.is_open) {
            answer.items = {static_cast<int>(i)};
            run.forget_verdict();
            given = true;
        }
        if (column + 1 == choices.columns || i + 1 == ask.choices.size()) y += height + entry_gap * scale;
    }
    ImGui::SetCursorScreenPos({corner.x, y});
    ImGui::Dummy({0.0F, 0.0F});
    return given;
}

/// Draws plates in place of a question's fields, which nobody fills in on stage: a zero in a field could be mistaken
/// for the answer.
void draw_unanswered(const Ask& ask, const AnswerSizes& sizes, float room) {
    if (ask.columns == 4) {
        const float width = std::min(room, widest_matrix * sizes.enlarged);
        return widgets::Plate("answer", {width, 4.0F * ImGui::GetFrameHeight()});
    }
    const std::size_t count = static_cast<std::size_t>(ask.rows * ask.columns), columns = numbers_in_a_row(ask);
    for (std::size_t place = 0; place < count; ++place) {
        if (place % columns != 0) ImGui::SameLine(0.0F, ImGui::GetStyle().ItemInnerSpacing.x);
        widgets::Plate(("answer " + std::to_string(place + 1)).c_str(),
                       {number_width * sizes.enlarged - ImGui::GetStyle().ItemInnerSpacing.x, ImGui::GetFrameHeight()});
    }
}

/// Frames the last item as the right answer, in the same way as choices.
void frame_right_answer() {
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), palette().plane, px(4.0F), 0,
                                        px(2.0F));
}

/// Draws the fields. Returns true if Enter has just ended typing in the last one.
bool draw_numbers(LessonRun& run, const AnswerStyle& style, const AnswerSizes& sizes, float room) {
    const Ask& ask = run.step().ask;
    const bool shows_model = style.shows_right && run.model() && !run.model()->numbers.empty();
    Answer model = shows_model ? *run.model() : Answer{};
    Answer& answer = shows_model ? model : run.answer();
    if (style.presents && !shows_model) {
        draw_unanswered(ask, sizes, room);
        return false;
    }
    answer.numbers.resize(static_cast<std::size_t>(ask.rows * ask.columns), 0.0);
    run.unread().resize(answer.numbers.size());
    std::string* const unread = style.is_open ? run.unread().data() : nullptr;
    const std::vector<double> before = answer.numbers;
    const bool are_whole = std::all_of(before.begin(), before.end(), [](double one) { return one == std::round(one); });
    if (ask.columns == 4) {
        glm::dmat4 matrix = matrix_of_rows(answer.numbers);
        // Keep the fields after the answer is shown, as for a vector: plain numbers take less height than fields.
        widgets::Matrix("answer", matrix, {.editable = !style.presents, .read = typed_number, .unread = unread},
                        std::min(room, widest_matrix * sizes.enlarged));
        if (shows_model) frame_right_answer();
        for (int i = 0; i < 16; ++i) answer.numbers[i] = matrix[i % 4][i / 4];
    } else {
        const std::size_t columns = numbers_in_a_row(ask);
        for (std::size_t row = 0; row * columns < answer.numbers.size(); ++row) {
            const std::size_t count = std::min(columns, answer.numbers.size() - row * columns);
            const std::string name = row == 0 ? "answer" : "answer " + std::to_string(row + 1);
            ImGui::SetNextItemWidth(number_width * sizes.enlarged * static_cast<float>(count));
            widgets::Numbers(("##" + name).c_str(), std::span(answer.numbers).subspan(row * columns, count),
                             {.decimals = shows_model && are_whole ? 0 : 3,
                              .read = typed_number,
                              .unread = unread ? unread + row * columns : nullptr});
            if (shows_model) frame_right_answer();
        }
    }
    if (shows_model) return false;
    if (!style.is_open) answer.numbers = before;
    if (answer.numbers != before) run.forget_verdict();
    return style.is_open && widgets::IsLastEntered();
}

bool draw_tile(const Paragraph& text, ImVec2 min, ImVec2 size, float text_x, const TileLook& look, bool is_open,
               const std::string& name) {
    const ImVec2 max(min.x + size.x, min.y + size.y);
    ImGui::SetCursorScreenPos(min);
    const bool pressed = ImGui::InvisibleButton(name.c_str(), size);
    widgets::Record(name.c_str());
    draw_ground(min, max, look, is_open && ImGui::IsItemHovered());
    const float y = std::floor((min.y + max.y - text.height) * 0.5F);
    draw_with_subscripts(ImGui::GetWindowDrawList(), text.font, {min.x + text_x, y}, palette().text, text.lines);
    return pressed && is_open;
}

/// Draws tiles that the student puts in order. The arrows at a tile's ends move it. A tile that is dragged onto another
/// moves to that tile's position, and the tiles in between shift.
void draw_order(LessonRun& run, const AnswerStyle& style, const AnswerSizes& sizes, float width) {
    const Ask& ask = run.step().ask;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const std::vector<int> order = style.shows_right ? ask.expected_items.front() : run.answer().items;
    std::optional<std::pair<int, int>> moved;
    int place = 0;
    const float end = lay_out_tiles(ask, order, width, sizes, [&](int item, float x, float y, ImVec2 tile) {
        const ImVec2 min(corner.x + x, corner.y + y);
        const float arrow = sizes.arrow();
        draw_tile(sizes.tile_text(ask.items[item], ask, width), min, tile, arrow + sizes.padding(),
                  {false, style.shows_right, false}, style.is_open, "item " + std::to_string(item + 1));
        if (style.is_open && ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoPreviewTooltip)) {
            ImGui::SetDragDropPayload("place", &place, sizeof place);
            ImGui::EndDragDropSource();
        }
        if (ImGui::BeginDragDropTarget()) {
            if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload("place"))
                moved = std::pair(*static_cast<const int*>(payload->Data), place);
            ImGui::EndDragDropTarget();
        }
        const auto arrow_button = [&](const char* sign, float at, int neighbor) {
            if (!style.is_open || neighbor < 0 || neighbor >= std::ssize(order)) return;
            ImGui::SetCursorScreenPos({at, min.y});
            const std::string id = std::string(sign) + " item " + std::to_string(item + 1);
            if (ImGui::InvisibleButton(id.c_str(), {arrow, tile.y})) moved = std::pair(place, neighbor);
            widgets::Record(id.c_str());
            const ImVec2 size = ImGui::CalcTextSize(sign);
            ImGui::GetWindowDrawList()->AddText({at + (arrow - size.x) * 0.5F, min.y + (tile.y - size.y) * 0.5F},
                                                ImGui::IsItemHovered() ? palette().accent : palette().quiet, sign);
        };
        ImGui::SetItemAllowOverlap();
        arrow_button("◂", min.x, place - 1);
        arrow_button("▸", min.x + tile.x - arrow, place + 1);
        ++place;
    });
    if (moved && moved->first != moved->second) {
        std::vector<int>& items = run.answer().items;
        const int item = items[moved->first];
        items.erase(items.begin() + moved->first);
        items.insert(items.begin() + moved->second, item);
        run.forget_verdict();
    }
    ImGui::SetCursorScreenPos({corner.x, corner.y + std::max(end, tiles_height(ask, width, sizes))});
    ImGui::Dummy({0.0F, 0.0F});
}

/// Draws tiles that the student chooses by clicking. In a sequence, the chosen tiles are numbered in the order of the
/// clicks.
void draw_chosen(LessonRun& run, const AnswerStyle& style, const AnswerSizes& sizes, float width) {
    const Ask& ask = run.step().ask;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    std::vector<int>& chosen = run.answer().items;
    const std::vector<int> shown = style.shows_right ? ask.expected_items.front() : chosen;
    const float end = lay_out_tiles(ask, as_written(ask), width, sizes, [&](int item, float x, float y, ImVec2 tile) {
        const auto at = std::find(shown.begin(), shown.end(), item);
        const bool is_chosen = at != shown.end();
        const ImVec2 min(corner.x + x, corner.y + y);
        const bool clicked = draw_tile(
            sizes.tile_text(ask.items[item], ask, width), min, tile, sizes.letter() + sizes.padding(),
            {is_chosen, is_chosen && style.shows_right, false}, style.is_open, "item " + std::to_string(item + 1));
        const std::string sign = !is_chosen                ? ""
                                 : kind_of(ask).is_ordered ? std::to_string(at - shown.begin() + 1)
                                                           : "✓";
        const float text_y = min.y + std::floor((tile.y - sizes.sign_font->FontSize) * 0.5F);
        ImGui::GetWindowDrawList()->AddText(sizes.sign_font, sizes.sign_font->FontSize,
                                            {min.x + sizes.padding(), text_y}, palette().accent, sign.c_str());
        if (!clicked) return;
        const auto mine = std::find(chosen.begin(), chosen.end(), item);
        if (mine != chosen.end())
            chosen.erase(mine);
        else
            chosen.push_back(item);
        run.forget_verdict();
    });
    ImGui::SetCursorScreenPos({corner.x, corner.y + end});
    ImGui::Dummy({0.0F, 0.0F});
}

float choices_height(const Ask& ask, float width, const widgets::Context& context, bool presents) {
    const AnswerSizes sizes(context, presents);
    float height = 0.0F;
    for (const float row : Choices(ask, width, context, presents).rows_px) height += row + sizes.gap();
    return height;
}

float fields_height(const Ask& ask, float, const widgets::Context& context, bool presents) {
    const AnswerSizes sizes(context, presents);
    const std::size_t count = static_cast<std::size_t>(ask.rows * ask.columns), in_a_row = numbers_in_a_row(ask);
    return static_cast<float>((count + in_a_row - 1) / in_a_row) * (sizes.frame_height() + sizes.gap());
}

constexpr AnswerInput number_fields{
    .height = fields_height,
    .draw =
        [](LessonRun& run, const AnswerStyle& style, float width) {
            return draw_numbers(run, style, {widgets::CurrentContext(), style.presents}, width);
        },
};

using DrawTiles = void (*)(LessonRun& run, const AnswerStyle& style, const AnswerSizes& sizes, float width);

template <DrawTiles draw_tiles>
constexpr AnswerInput tiles{
    .height =
        [](const Ask& ask, float width, const widgets::Context& context, bool presents) {
            return tiles_height(ask, width, {context, presents});
        },
    .draw =
        [](LessonRun& run, const AnswerStyle& style, float width) {
            draw_tiles(run, style, {widgets::CurrentContext(), style.presents}, width);
            return false;
        },
};

}  // namespace

namespace answer_inputs {

constexpr AnswerInput choice{choices_height, draw_choices};
constexpr AnswerInput number = number_fields, vector = number_fields, matrix = number_fields;
constexpr AnswerInput order = tiles<draw_order>, product = order;
constexpr AnswerInput sequence = tiles<draw_chosen>, subset = sequence;
/// The whole window is the input.
constexpr AnswerInput goal{[](const Ask&, float, const widgets::Context&, bool) { return 0.0F; },
                           [](LessonRun&, const AnswerStyle&, float) { return false; }};

static const AnswerInput& of(const Ask& ask) {
    static constexpr std::array all{VIEWING_QUESTION_KINDS(VIEWING_ADDRESS)};
    return *all[static_cast<std::size_t>(ask.kind)];
}

}  // namespace answer_inputs

float answers_height(const Ask& ask, float width, const widgets::Context& context, bool presents) {
    return answer_inputs::of(ask).height(ask, width, context, presents);
}

bool draw_answers(LessonRun& run, const AnswerStyle& style, float width) {
    const widgets::Group group("answers");
    widgets::Context& context = widgets::CurrentContext();
    ImFont* const number_font = context.fonts.number;
    if (style.presents) context.fonts.number = context.fonts.matrix;  // numbers as large as sentences
    ImGui::PushFont(AnswerSizes(context, style.presents).font);
    const bool is_given = answer_inputs::of(run.step().ask).draw(run, style, width);
    ImGui::PopFont();
    context.fonts.number = number_font;
    return is_given;
}

}  // namespace viewing
