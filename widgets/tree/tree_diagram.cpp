// Mouse interaction with a tree diagram. tree_camera.cpp moves the diagram, tree_drawing.cpp draws it, and
// tree_layout.cpp places its nodes.
#include <algorithm>
#include <cmath>
#include <string>

#include "widgets/area.h"
#include "widgets/inner.h"
#include "widgets/tree/tree_inner.h"

namespace widgets {

namespace {

using inner::Px;
using inner::TreeCamera;

bool Contains(const TreeDiagramState& state, int node) {
    return node >= 0 && node < std::ssize(state.layout.level);
}
int LevelOf(const TreeDiagramState& state, int node) {
    return Contains(state, node) ? state.layout.level[node] : -1;
}

/// Computes a new layout if the links or folds changed. The pressed node keeps its position.
void Update(std::span<const TreeNode> nodes, std::uint64_t revision, TreeDiagramState& state) {
    const bool is_new =
        !state.is_laid_out || state.laid_out_revision != revision || state.layout.level.size() != nodes.size();
    if (is_new && state.is_laid_out) state.collapsed.clear();
    if (is_new) state.fold_next = state.collapsed.empty();
    if (!is_new && state.collapsed == state.laid_out_collapsed) return;
    const int anchor = !is_new && LevelOf(state, state.pressed) >= 0 ? state.pressed : -1;
    const double x_before = anchor >= 0 ? state.layout.x[anchor] : 0.0;
    state.layout = LayOutTree(nodes, state.collapsed);
    state.laid_out_collapsed = state.collapsed;
    state.laid_out_revision = revision;
    if (LevelOf(state, anchor) >= 0) {
        state.pan.x += (x_before - state.layout.x[anchor]) * TreeCamera::pitch * state.stretch * state.zoom;
    }
    if (!is_new) return;
    state.is_laid_out = true;
    state.fit_next = true;
    state.pressed = state.hovered = -1;
}

/// Unfolds a node: its whole subtree or, if that is large, only the next levels.
void Unfold(std::span<const TreeNode> nodes, int node, TreeDiagramState& state) {
    constexpr int at_once = 63, levels = 4;
    const auto& sizes = state.layout.subtree_size;
    state.collapsed.erase(node);
    if (sizes[node] <= at_once) return;
    std::vector<int> row{node};
    for (int level = 0; level < levels; ++level) {
        std::vector<int> below;
        for (const int parent : row) {
            const inner::TreeChildren children = inner::ChildrenOf(nodes, parent);
            for (const int child : {children.front, children.back}) {
                if (child >= 0) below.push_back(child);
            }
        }
        row = std::move(below);
    }
    for (const int folded : row) {
        if (sizes[folded] > 1) state.collapsed.insert(folded);
    }
}

/// Unfolds the ancestors that hide a node.
void UnfoldTo(std::span<const TreeNode> nodes, int node, TreeDiagramState& state) {
    if (!Contains(state, node)) return;
    std::vector<int> ancestors;
    // A parent comes before its children, so this loop ends.
    for (int child = node; child > 0;) {
        const int parent = nodes[child].parent;
        if (parent < 0 || parent >= child) return;
        ancestors.push_back(parent);
        child = parent;
    }
    for (auto ancestor = ancestors.rbegin(); ancestor != ancestors.rend(); ++ancestor) {
        if (state.collapsed.contains(*ancestor)) Unfold(nodes, *ancestor, state);
    }
}

struct PointedNode {
    int node = -1;
    bool on_triangle = false;
};

PointedNode NodeAt(const TreeCamera& camera, std::span<const TreeNode> nodes, const TreeDiagramState& state,
                   ImVec2 pointer, int shown_count) {
    const TreeLayout& layout = state.layout;
    const double row = std::round(camera.LayoutLevel(pointer.y));
    if (row < 0.0 || row >= layout.LevelCount()) return {};
    const std::span<const int> level = layout.Level(static_cast<int>(row));
    const double x = camera.LayoutX(pointer.x);
    const auto right = std::partition_point(level.begin(), level.end(), [&](int node) { return layout.x[node] < x; });
    const ImVec2 half = camera.HalfBox();
    const float least = Px(5);
    for (auto near = right == level.begin() ? right : right - 1; near != level.end() && near <= right; ++near) {
        if (*near >= shown_count) continue;
        const ImVec2 center = camera.At(layout, *near);
        const float dx = std::abs(pointer.x - center.x), dy = std::abs(pointer.y - center.y);
        if (dx <= std::max(half.x, least) && dy <= std::max(half.y, least)) return {*near, false};
        const ImVec2 triangle = camera.TriangleCenter(center);
        const float away = std::hypot(pointer.x - triangle.x, pointer.y - triangle.y);
        const bool has_triangle = camera.ShowsText() && (*near == state.hovered || state.collapsed.contains(*near)) &&
                                  inner::HasShownChild(nodes, *near, shown_count);
        if (has_triangle && away <= camera.TriangleRadius() + Px(2)) return {*near, true};
    }
    return {};
}

/// Handles the mouse over the view, which must be the last item. Returns whether `selected` changed.
bool UseMouse(const TreeCamera& camera, std::span<const TreeNode> nodes, TreeDiagramState& state, int& selected,
              const TreeDiagramStyle& style) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered();
    const PointedNode pointed =
        hovered || ImGui::IsItemActive() ? NodeAt(camera, nodes, state, io.MousePos, style.shown_count) : PointedNode{};
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) state.hovered = pointed.node;

    if (hovered && io.MouseWheel != 0.0F && !ImGui::IsItemActive()) {
        inner::ZoomAbout(camera, io.MousePos, std::pow(1.2, io.MouseWheel), state);
        inner::KeepInView(camera, state);
    }
    if (ImGui::IsItemActivated()) {
        state.drag_distance_px = 0.0F;
        state.pan_pressed = state.pan;
        state.pressed = pointed.node;
        state.pressed_triangle = pointed.on_triangle;
    }
    const bool doubled = hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (doubled && pointed.node < 0) state.fit_whole_next = true;
    const bool folds = (doubled && !pointed.on_triangle) || (ImGui::IsItemActivated() && pointed.on_triangle);
    if (folds && pointed.node >= 0 && inner::HasShownChild(nodes, pointed.node, style.shown_count)) {
        if (state.collapsed.contains(pointed.node)) {
            Unfold(nodes, pointed.node, state);
        } else {
            state.collapsed.insert(pointed.node);
        }
    }

    const float click_distance = Px(4);
    if (ImGui::IsItemActive()) {
        const ImVec2 from = io.MouseClickedPos[ImGuiMouseButton_Left];
        const glm::dvec2 dragged(io.MousePos.x - from.x, io.MousePos.y - from.y);
        state.drag_distance_px = std::max(state.drag_distance_px, static_cast<float>(glm::length(dragged)));
        if (state.drag_distance_px >= click_distance) {
            state.pan = state.pan_pressed + dragged / camera.unit;
            inner::KeepInView(camera, state);
            ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
        }
    }
    const bool clicked = ImGui::IsItemDeactivated() && state.drag_distance_px < click_distance;
    if (!clicked || state.pressed_triangle || state.pressed == selected) return false;
    selected = state.pressed;
    return true;
}

/// Draws the four corners of a frame, as an icon for "fit everything".
void DrawFitButton(ImDrawList* draw, ImVec2 min, float side, bool hovered) {
    const Palette& palette = CurrentContext().palette;
    const ImVec2 max(min.x + side, min.y + side);
    inner::DrawField(draw, min, max, hovered, false, false, Role::none);
    const ImU32 color = inner::Shown(hovered ? palette.text : palette.quiet);
    const float inset = std::round(side * 0.27F), arm = std::round(side * 0.16F), line = Px(1.5F) * palette.stroke;
    for (const float sx : {-1.0F, 1.0F}) {
        for (const float sy : {-1.0F, 1.0F}) {
            const ImVec2 corner(sx < 0.0F ? min.x + inset : max.x - inset, sy < 0.0F ? min.y + inset : max.y - inset);
            const ImVec2 points[] = {ImVec2(corner.x - sx * arm, corner.y), corner,
                                     ImVec2(corner.x, corner.y - sy * arm)};
            draw->AddPolyline(points, 3, color, 0, line);
        }
    }
}

void NodeTooltip(const TreeCamera& camera, std::span<const TreeNode> nodes, const TreeDiagramState& state) {
    if (LevelOf(state, state.hovered) < 0) return;
    const TreeNode& node = nodes[state.hovered];
    const ImVec2 center = camera.At(state.layout, state.hovered), half = camera.HalfBox();
    if (!inner::TooltipDue(ImGui::IsItemHovered(), ImVec2(center.x - half.x, center.y - half.y),
                           ImVec2(center.x + half.x, center.y + half.y))) {
        return;
    }
    const auto size_of = [&](int child) {
        return child > state.hovered && Contains(state, child) ? state.layout.subtree_size[child] : 0;
    };
    inner::BeginTooltipWindow();
    if (!node.label.empty()) {
        const inner::FontScope font(CurrentContext().fonts.heading);
        ImGui::TextUnformatted(node.label.data(), node.label.data() + node.label.size());
    }
    const std::string text =
        say("Nodes in front: {front}, behind: {back}.", "front"_a = size_of(node.front), "back"_a = size_of(node.back));
    ImGui::TextUnformatted(text.c_str());
    const ImVec2 min = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    inner::RecordRect("tooltip", min, ImVec2(min.x + size.x, min.y + size.y), text);
    inner::EndTooltipWindow();
}

}  // namespace

bool TreeDiagram(const char* id, std::span<const TreeNode> nodes, std::uint64_t revision, TreeDiagramState& state,
                 int& selected, const TreeDiagramStyle& style) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 size(std::max(style.size.x > 0.0F ? style.size.x : room.x, Px(40)),
                      std::max(style.size.y > 0.0F ? style.size.y : room.y, Px(40)));
    const Palette& palette = CurrentContext().palette;
    const inner::WheelArea area(id, size);
    const Group group(id);
    const ImVec2 min = area.min, max = area.max;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(min, max, inner::Shown(palette.view_ground), Px(4));

    if (CurrentContext().printed) {  // a printed figure fits all unfolded nodes into the area
        state.fit_whole_next = true;
        state.reveal_next = -1;
    }
    Update(nodes, revision, state);
    UnfoldTo(nodes, state.reveal_next, state);
    Update(nodes, revision, state);
    if (state.fold_next && inner::FoldWide(TreeCamera(min, max, state), nodes, state)) Update(nodes, revision, state);
    state.fold_next = false;
    if (state.fit_next || state.fit_whole_next) inner::Fit(TreeCamera(min, max, state), state, state.fit_whole_next);
    if (LevelOf(state, state.reveal_next) >= 0)
        inner::MoveIntoView(TreeCamera(min, max, state), state.reveal_next, state);
    state.fit_next = state.fit_whole_next = false;
    state.reveal_next = -1;

    // The button must come before the view around it, so that it gets the mouse.
    const float side = ImGui::GetFrameHeight();
    const ImVec2 button_min(max.x - side - Px(5), min.y + Px(5));
    const bool has_button = Offers("button:fit");
    bool button_hovered = false;
    if (has_button) {
        ImGui::SetCursorScreenPos(button_min);
        if (ImGui::InvisibleButton("fit", ImVec2(side, side))) state.fit_whole_next = true;
        Record("fit");
        button_hovered = ImGui::IsItemHovered();
        Tooltip("Fit",
                "Fits the whole tree into the view; a double-click on the background does the same. Drag to move, turn "
                "the wheel to zoom, double-click a node to collapse its subtree.");
    }

    ImGui::SetCursorScreenPos(min);
    ImGui::InvisibleButton("view", size);
    Record("view");
    const bool changed = UseMouse(TreeCamera(min, max, state), nodes, state, selected, style);
    Update(nodes, revision, state);
    const TreeCamera camera(min, max, state);
    if (nodes.empty() || style.shown_count <= 0) {
        inner::DrawHint(draw, min, max, "No tree yet.");
    } else {
        inner::DrawTree(draw, camera, nodes, state, selected, style);
        if (!button_hovered) NodeTooltip(camera, nodes, state);
    }
    if (has_button) DrawFitButton(draw, button_min, side, button_hovered);
    return changed;
}

}  // namespace widgets
