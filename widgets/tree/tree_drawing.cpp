// Drawing of a tree diagram: only the visible part, with fewer details for smaller nodes. If too many nodes are visible
// to distinguish them, draws only every n-th node of each level.
#include <algorithm>
#include <cmath>
#include <string>

#include "widgets/inner.h"
#include "widgets/tree/tree_inner.h"

namespace widgets::inner {

bool HasShownChild(std::span<const TreeNode> nodes, int node, int shown_count) {
    const TreeChildren children = ChildrenOf(nodes, node);
    return (children.front >= 0 && children.front < shown_count) || (children.back >= 0 && children.back < shown_count);
}

namespace {

enum class Detail { dots, boxes, text };

constexpr float least_type = 9.0F;  ///< design pixels; smaller digits cannot be read

class TreePicture {
public:
    TreePicture(ImDrawList* draw, const TreeCamera& camera, std::span<const TreeNode> nodes,
                const TreeDiagramState& state, int selected, const TreeDiagramStyle& style)
        : draw_(draw),
          camera_(camera),
          nodes_(nodes),
          state_(state),
          selected_(selected),
          style_(style),
          palette_(CurrentContext().palette),
          current_(ShownAncestor(style.current)),
          lit_(ShownAncestor(style.lit)),
          half_(camera.HalfBox()),
          line_(Px(1.5F) * palette_.stroke) {
        const TreeLayout& layout = state.layout;
        const int levels = layout.LevelCount();
        // An edge belongs to its child, so the level below the view still has visible edges.
        first_level_ = static_cast<int>(std::clamp(std::floor(camera.LayoutLevel(camera.min.y)), 0.0, levels - 1.0));
        last_level_ = static_cast<int>(std::clamp(std::ceil(camera.LayoutLevel(camera.max.y)) + 1, 0.0, levels - 1.0));
        std::size_t count = 0;
        for (int level = first_level_; level <= last_level_; ++level) count += EdgesInView(level).size();
        ChooseDetail(count);
    }

    void Draw() {
        for (int level = first_level_; level <= last_level_; ++level) {
            ForEvery(EdgesInView(level), [this](int node) { DrawEdge(node); });
        }
        for (int level = first_level_; level <= last_level_; ++level) {
            ForEvery(NodesInView(level), [this](int node) { DrawNode(node); });
        }
        if (detail_ == Detail::text) return;
        // Draw these nodes last, on top; thinning never omits them.
        for (const int node : {lit_, selected_, current_, state_.hovered}) {
            if (IsShown(node)) DrawNode(node);
        }
    }

private:
    void ChooseDetail(std::size_t count) {
        // A draw list without vertex offsets holds 65,536 vertices. A node with text needs about 110, a dot with its
        // edge 10.
        const bool is_large = (draw_->Flags & ImDrawListFlags_AllowVtxOffset) != 0;
        const std::size_t most_with_text = is_large ? 4000 : 400, most = 5000;
        stride_ = (count + most - 1) / most;
        detail_ = camera_.ShowsText() && count <= most_with_text ? Detail::text
                  : half_.x >= 3.0F                              ? Detail::boxes
                                                                 : Detail::dots;
    }

    const TreeNode& At(int node) const { return nodes_[node]; }
    double X(int node) const { return state_.layout.x[node]; }
    int LevelOf(int node) const { return state_.layout.level[node]; }
    bool IsShown(int node) const {
        return node >= 0 && node < std::min(static_cast<int>(nodes_.size()), style_.shown_count) && LevelOf(node) >= 0;
    }

    /// Returns the node, or the folded one that hides it; −1 if the node is not in the tree.
    int ShownAncestor(int node) const {
        if (node >= std::ssize(nodes_)) return -1;
        while (node >= 0 && LevelOf(node) < 0) node = At(node).parent < node ? At(node).parent : -1;
        return node;
    }

    /// Returns the nodes of a level whose items overlap the view. An item extends from `first_x` to `last_x`, both of
    /// which must increase along the level.
    template <class First, class Last>
    std::span<const int> InView(int level, double margin, First first_x, Last last_x) const {
        const std::span<const int> all = state_.layout.Level(level);
        const double from = camera_.LayoutX(camera_.min.x) - margin, to = camera_.LayoutX(camera_.max.x) + margin;
        const auto begin = std::partition_point(all.begin(), all.end(), [&](int node) { return last_x(node) < from; });
        const auto end = std::partition_point(begin, all.end(), [&](int node) { return first_x(node) <= to; });
        return {begin, end};
    }
    std::span<const int> NodesInView(int level) const {
        const auto x = [this](int node) { return X(node); };
        return InView(level, 1.0, x, x);
    }
    std::span<const int> EdgesInView(int level) const {
        const auto parent_x = [this](int node) { return node > 0 ? X(At(node).parent) : X(node); };
        return InView(
            level, 1.0, [&](int node) { return std::min(X(node), parent_x(node)); },
            [&](int node) { return std::max(X(node), parent_x(node)); });
    }

    template <class Action>
    void ForEvery(std::span<const int> part, Action action) const {
        if (part.empty()) return;
        // Count from the level's start, so that the same nodes stay visible while the tree moves.
        const auto place = static_cast<std::size_t>(part.data() - state_.layout.Level(LevelOf(part[0])).data());
        for (std::size_t i = (stride_ - place % stride_) % stride_; i < part.size(); i += stride_) {
            if (IsShown(part[i])) action(part[i]);
        }
    }

    void DrawEdge(int node) {
        if (node == 0) return;
        const int parent = At(node).parent;
        const ImVec2 upper = camera_.At(state_.layout, parent), lower = camera_.At(state_.layout, node);
        const ImVec2 from(upper.x, upper.y + half_.y), to(lower.x, lower.y - half_.y);
        const bool is_front = At(parent).front == node;
        const bool is_eyes = At(parent).eye_side == (is_front ? 1 : -1);
        const ImU32 color = is_eyes ? palette_.camera : Mix(palette_.view_ground, palette_.quiet, 0.75F);
        draw_->AddLine(from, to, Shown(color), is_eyes ? 2.0F * line_ : detail_ == Detail::dots ? Px(1) : line_);
        if (detail_ == Detail::text) DrawSign(from, to, is_front, is_eyes ? palette_.camera : palette_.quiet);
    }

    /// Draws + or − in a gap of the edge.
    void DrawSign(ImVec2 from, ImVec2 to, bool plus, ImU32 color) {
        const ImVec2 middle(std::floor(from.x * 0.45F + to.x * 0.55F) + 0.5F,
                            std::floor(from.y * 0.45F + to.y * 0.55F) + 0.5F);
        const float reach = std::floor(static_cast<float>(3.5 * camera_.unit)), gap = reach + Px(2);
        draw_->AddRectFilled(ImVec2(middle.x - gap, middle.y - gap), ImVec2(middle.x + gap, middle.y + gap),
                             Shown(palette_.view_ground), gap);
        draw_->AddLine(ImVec2(middle.x - reach, middle.y), ImVec2(middle.x + reach, middle.y), Shown(color), line_);
        if (!plus) return;
        draw_->AddLine(ImVec2(middle.x, middle.y - reach), ImVec2(middle.x, middle.y + reach), Shown(color), line_);
    }

    void DrawNode(int node) {
        const ImVec2 center = camera_.At(state_.layout, node);
        const TreeNode& info = At(node);
        const ImU32 color = info.color ? info.color : palette_.quiet;
        if (detail_ == Detail::text) {
            DrawStub(node, center);
            DrawBox(node, center, color);
            DrawMark(node, center);
            DrawFold(node, center);
            if (CurrentContext().record) RecordNode(node, center);
            return;
        }
        const bool stands_out = node == current_ || node == selected_ || node == state_.hovered || node == lit_;
        const float least = stands_out ? Px(3.5F) : Px(1);
        const ImVec2 half(std::max(half_.x, least), std::max(half_.y, least));
        const ImU32 fill = node == current_ ? palette_.accent : stands_out ? palette_.text : color;
        draw_->AddRectFilled(ImVec2(center.x - half.x, center.y - half.y), ImVec2(center.x + half.x, center.y + half.y),
                             Shown(fill));
    }

    /// Marks the eye's side of a plane if the node has no child on that side.
    void DrawStub(int node, ImVec2 center) {
        const TreeNode& info = At(node);
        if (info.eye_side == 0 || (info.eye_side > 0 ? info.front : info.back) >= 0) return;
        const float side = info.eye_side > 0 ? -1.0F : 1.0F, reach = static_cast<float>(9.0 * camera_.unit);
        const ImVec2 from(center.x, center.y + half_.y);
        draw_->AddLine(from, ImVec2(from.x + side * reach, from.y + reach), Shown(palette_.camera), 2.0F * line_);
    }

    void DrawBox(int node, ImVec2 center, ImU32 color) {
        const ImVec2 min(std::floor(center.x - half_.x), std::floor(center.y - half_.y));
        const ImVec2 max(min.x + std::round(2.0F * half_.x), min.y + std::round(2.0F * half_.y));
        const bool is_current = node == current_;
        const bool is_lit = node == state_.hovered || node == lit_;
        const ImU32 ground = Mix(palette_.field, color, At(node).color ? 0.4F : 0.16F);
        const ImU32 fill = is_current ? palette_.accent : is_lit ? Mix(ground, palette_.accent, 0.3F) : ground;
        const float rounding = Px(4);
        draw_->AddRectFilled(min, max, Shown(fill), rounding);
        draw_->AddRect(min, max, Shown(is_lit && !is_current ? palette_.accent : color), rounding, 0, line_);
        if (node == selected_) {
            const float gap = Px(3);
            draw_->AddRect(ImVec2(min.x - gap, min.y - gap), ImVec2(max.x + gap, max.y + gap), Shown(palette_.text),
                           rounding + gap, 0, line_);
        }
        DrawLabel(At(node).label, ImVec2((min.x + max.x) * 0.5F, (min.y + max.y) * 0.5F),
                  is_current ? InkOn(fill) : palette_.text);
    }

    /// Draws the label in the middle of the box, smaller if it would not fit.
    void DrawLabel(std::string_view label, ImVec2 center, ImU32 color) {
        if (label.empty()) return;
        const Fonts& fonts = CurrentContext().fonts;
        ImFont* const large = CurrentContext().is_on_stage ? fonts.matrix : fonts.number;
        Face face = FaceOf(camera_.zoom >= 1.2 ? large : fonts.small_number);
        const float room = 2.0F * half_.x - Px(4), wanted = face.Measure(label).x;
        if (wanted > room) face.size = std::max(std::floor(face.size * room / wanted), Px(least_type));
        const float width = face.Measure(label).x;
        if (width > room + Px(3)) return;
        face.Draw(draw_, ImVec2(std::floor(center.x - 0.5F * width), std::floor(center.y - 0.5F * face.size)),
                  Shown(color), label);
    }

    /// Draws the traversal number on the side away from the edge to the parent: beside the box if it fits, otherwise
    /// above it. Off stage, a number above the box is smaller at a low zoom or if it would overlap a neighbor's. Omits
    /// a number that would still overlap.
    void DrawMark(int node, ImVec2 center) {
        if (At(node).mark < 0) return;
        Face face = FaceOf(CurrentContext().fonts.small_number);
        const std::string digits = std::to_string(At(node).mark);
        const bool leans_right = node > 0 && At(At(node).parent).back == node;
        const ImU32 color = Shown(node == current_ ? palette_.accent : palette_.quiet);
        const float width = face.Measure(digits).x, from_box = Px(4);
        if (camera_.HasRoomBeside() && width <= 0.5F * camera_.Pitch() - half_.x - 1.5F * from_box) {
            const float left = leans_right ? center.x + half_.x + from_box : center.x - half_.x - from_box - width;
            face.Draw(draw_, ImVec2(std::floor(left), std::floor(center.y - 0.5F * face.size)), color, digits);
            return;
        }
        const float gap = Px(3), room = 0.5F * camera_.Pitch() - gap - Px(1);
        if (!CurrentContext().is_on_stage) {
            const float small = static_cast<float>(std::min(camera_.zoom / 0.75, 1.0));
            face.size = std::max(std::floor(face.size * std::min(small, room / width)), Px(least_type));
        }
        if (face.Measure(digits).x > room + Px(1)) return;
        const float left = leans_right ? center.x + gap : center.x - gap - face.Measure(digits).x;
        const float above = std::floor(center.y - half_.y - face.size - Px(node == selected_ ? 4 : 1));
        const ImVec2 at(std::floor(left), std::max(above, draw_->GetClipRectMin().y - Px(2)));
        face.Draw(draw_, at, color, digits);
    }

    /// Draws the fold triangle of the hovered node. A folded node always has one, with the number of nodes it hides.
    void DrawFold(int node, ImVec2 center) {
        const bool is_folded = state_.collapsed.contains(node);
        if (!is_folded && node != state_.hovered) return;
        if (!HasShownChild(nodes_, node, style_.shown_count)) return;
        const ImVec2 triangle = camera_.TriangleCenter(center);
        const float radius = camera_.TriangleRadius();
        draw_->AddCircleFilled(triangle, radius, Shown(palette_.field), 12);
        draw_->AddCircle(triangle, radius, Shown(palette_.quiet), 12, Px(1));
        DrawTriangle(draw_, triangle, radius * 0.5F, !is_folded, Shown(palette_.text));
        if (!is_folded) return;
        const Face face = FaceOf(CurrentContext().fonts.small_number);
        const std::string hidden = std::to_string(state_.layout.subtree_size[node] - 1);
        face.Draw(draw_,
                  ImVec2(std::floor(triangle.x - 0.5F * face.Measure(hidden).x), std::floor(triangle.y + radius)),
                  Shown(palette_.quiet), hidden);
    }

    void RecordNode(int node, ImVec2 center) const {
        const std::string name = std::to_string(node);
        RecordRect(name.c_str(), ImVec2(center.x - half_.x, center.y - half_.y),
                   ImVec2(center.x + half_.x, center.y + half_.y), state_.collapsed.contains(node) ? "folded" : "open");
    }

    ImDrawList* draw_;
    const TreeCamera& camera_;
    std::span<const TreeNode> nodes_;
    const TreeDiagramState& state_;
    int selected_;
    const TreeDiagramStyle& style_;
    const Palette& palette_;
    int current_, lit_;
    ImVec2 half_;
    float line_;
    int first_level_ = 0, last_level_ = -1;
    std::size_t stride_ = 1;
    Detail detail_ = Detail::text;
};

}  // namespace

void DrawTree(ImDrawList* draw, const TreeCamera& camera, std::span<const TreeNode> nodes,
              const TreeDiagramState& state, int selected, const TreeDiagramStyle& style) {
    if (state.layout.order.empty()) return;
    TreePicture(draw, camera, nodes, state, selected, style).Draw();
}

}  // namespace widgets::inner
