// The view of a tree diagram: fitting, zooming, moving, and folding trees that are too wide to read.
#include <algorithm>
#include <cmath>

#include "widgets/inner.h"
#include "widgets/tree/tree_inner.h"

namespace widgets::inner {

namespace {

constexpr double smallest_zoom = 0.02, largest_zoom = 3.0;
constexpr double margin = 26.0;  ///< in design pixels, around the centers of a fitted tree's outer nodes

glm::dvec2 ViewSize(const TreeCamera& camera) {
    return glm::dvec2(camera.max.x - camera.min.x, camera.max.y - camera.min.y) / camera.unit;
}

/// Returns the nodes of a level that have children.
std::unordered_set<int> ParentsAt(const TreeLayout& layout, int level) {
    std::unordered_set<int> parents;
    for (const int node : layout.Level(level)) {
        if (layout.subtree_size[node] > 1) parents.insert(node);
    }
    return parents;
}

}  // namespace

TreeCamera::TreeCamera(ImVec2 view_min, ImVec2 view_max, const TreeDiagramState& state)
    : min(view_min),
      max(view_max),
      unit(Px(1) * CurrentContext().palette.type_scale),
      zoom(state.zoom),
      stretch(state.stretch),
      pan(state.pan) {}

ImVec2 TreeCamera::At(double x, int level) const {
    return ImVec2(min.x + static_cast<float>(unit * (pan.x + pitch * stretch * zoom * x)),
                  min.y + static_cast<float>(unit * (pan.y + row * zoom * level)));
}

ImVec2 TreeCamera::At(const TreeLayout& layout, int node) const {
    const auto index = static_cast<std::size_t>(node);
    return At(layout.x[index], layout.level[index]);
}

ImVec2 TreeCamera::HalfBox() const {
    const double size = std::min(zoom, 1.25) * unit;
    return ImVec2(static_cast<float>(18.0 * size), static_cast<float>(11.0 * size));
}

bool FoldWide(const TreeCamera& camera, std::span<const TreeNode> nodes, TreeDiagramState& state) {
    constexpr int least_levels = 3;
    const double room = ViewSize(camera).x - 2.0 * margin;
    // Viewers in the back row need fewer, larger nodes.
    const double zoom =
        CurrentContext().is_on_stage ? 2.0 * TreeCamera::comfortable_zoom : TreeCamera::comfortable_zoom;
    const auto fits = [room, zoom](const TreeLayout& layout) {
        return (layout.max_x - layout.min_x) * TreeCamera::pitch * zoom <= room;
    };
    if (fits(state.layout) || state.layout.LevelCount() <= least_levels) return false;
    // More levels never make a tree narrower, so bisection works.
    int fitting = least_levels, too_many = state.layout.LevelCount();
    while (too_many - fitting > 1) {
        const int levels = (fitting + too_many) / 2;
        (fits(LayOutTree(nodes, ParentsAt(state.layout, levels - 1))) ? fitting : too_many) = levels;
    }
    state.collapsed = ParentsAt(state.layout, fitting - 1);
    return true;
}

void Fit(const TreeCamera& camera, TreeDiagramState& state, bool whole) {
    const TreeLayout& layout = state.layout;
    glm::dvec2 size = ViewSize(camera);
    // Below the lowest boxes, folded nodes have a triangle and the number of nodes that they hide.
    if (!state.collapsed.empty())
        size.y = std::max(
            size.y - (2.0 * camera.TriangleRadius() + FaceOf(CurrentContext().fonts.small_number).size) / camera.unit,
            0.25 * size.y);
    const glm::dvec2 tree((layout.max_x - layout.min_x) * TreeCamera::pitch,
                          (layout.LevelCount() - 1) * TreeCamera::row);
    // The margin scales with the nodes.
    const glm::dvec2 fitting = size / (tree + 2.0 * margin);
    const double zoom = std::min(fitting.x, fitting.y);
    const bool fits = whole || zoom >= TreeCamera::readable_zoom;
    const double largest = CurrentContext().printed ? 2.0 : CurrentContext().is_on_stage ? 2.0 : 1.0;
    state.zoom = std::clamp(zoom, fits ? smallest_zoom : TreeCamera::comfortable_zoom, largest);
    const double edge = margin * state.zoom;
    const glm::dvec2 room = size - 2.0 * edge;
    glm::dvec2 zoomed = tree * state.zoom;
    state.stretch = 1.0;
    if (CurrentContext().is_on_stage && zoomed.x > 0.0 && zoomed.x < room.x) {
        constexpr double largest_stretch = 3.0, beside_box = 14.0;  // room for a number beside the outer boxes
        const double widest = room.x - 2.0 * beside_box;
        state.stretch = std::clamp(widest / zoomed.x, 1.0, largest_stretch);
        zoomed.x *= state.stretch;
    }
    const double to_left = -layout.min_x * TreeCamera::pitch * state.stretch * state.zoom;
    if (zoomed.x <= room.x) {
        state.pan.x = 0.5 * (size.x - zoomed.x) + to_left;
    } else {
        state.pan.x = std::clamp(0.5 * size.x, size.x - edge - (zoomed.x - to_left), edge + to_left);
    }
    state.pan.y = zoomed.y <= room.y ? 0.5 * (size.y - zoomed.y) : edge;
}

void KeepInView(const TreeCamera& camera, TreeDiagramState& state) {
    const TreeLayout& layout = state.layout;
    const glm::dvec2 step = glm::dvec2(TreeCamera::pitch * state.stretch, TreeCamera::row) * state.zoom;
    const glm::dvec2 size = ViewSize(camera),
                     edge = glm::min(glm::dvec2(margin * std::min(state.zoom, 1.0)), 0.5 * size);
    const glm::dvec2 first = glm::dvec2(layout.min_x, 0.0) * step;
    const glm::dvec2 last = glm::dvec2(layout.max_x, layout.LevelCount() - 1) * step;
    state.pan = glm::clamp(state.pan, edge - last, size - edge - first);
}

void ZoomAbout(const TreeCamera& camera, ImVec2 pointer, double factor, TreeDiagramState& state) {
    const double zoom = std::clamp(state.zoom * factor, smallest_zoom, largest_zoom);
    const glm::dvec2 at = glm::dvec2(pointer.x - camera.min.x, pointer.y - camera.min.y) / camera.unit;
    state.pan = at - (at - state.pan) * (zoom / state.zoom);
    state.zoom = zoom;
}

void MoveIntoView(const TreeCamera& camera, int node, TreeDiagramState& state) {
    const auto index = static_cast<std::size_t>(node);
    if (state.zoom < TreeCamera::readable_zoom) {
        ZoomAbout(camera, camera.At(state.layout, node), TreeCamera::comfortable_zoom / state.zoom, state);
    }
    const glm::dvec2 size = ViewSize(camera),
                     edge = glm::min(glm::dvec2(margin * std::min(state.zoom, 1.0)), 0.5 * size);
    const glm::dvec2 at(state.layout.x[index] * TreeCamera::pitch * state.stretch,
                        state.layout.level[index] * TreeCamera::row);
    const glm::dvec2 seen = state.pan + at * state.zoom;
    state.pan += glm::clamp(seen, edge, size - edge) - seen;
}

}  // namespace widgets::inner
