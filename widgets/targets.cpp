// Covered and highlighted targets. Read targets.h first.
#include "widgets/targets.h"

#include <algorithm>
#include <cmath>

#include "widgets/inner.h"

namespace widgets {

namespace {

using inner::Px;

constexpr float frame_margin = 3.0F;  ///< around a target, in design pixels
constexpr int search_frames = 4;  ///< folded sections need a frame to open before their content can scroll into view

/// The width of a frame's line, in pixels.
float FrameStroke() {
    return std::max(std::round(Px(2) * CurrentContext().palette.stroke), 2.0F);
}

Targets& Current() {
    return CurrentContext().targets;
}

template <typename Test>
bool Any(const std::vector<std::string>& names, const Test& test) {
    return std::any_of(names.begin(), names.end(), test);
}

bool IsIn(const std::vector<std::string>& names, std::string_view name) {
    return Any(names, [name](const std::string& whole) { return Contains(whole, name); });
}

/// Scrolls the target to the middle of the window unless it is fully visible. Only the first target in each window
/// scrolls it.
void BringIntoView(Targets& targets, ImVec2 min, ImVec2 max) {
    const ImDrawList* window = ImGui::GetWindowDrawList();
    if (targets.frames_of_search <= 0 || ImGui::GetScrollMaxY() <= 0.0F) return;
    if (std::find(targets.scrolled.begin(), targets.scrolled.end(), window) != targets.scrolled.end()) return;
    targets.scrolled.push_back(window);
    const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
    if (min.y < top || max.y > bottom) ImGui::SetScrollFromPosY((min.y + max.y) * 0.5F - top, 0.5F);
}

}  // namespace

bool Contains(std::string_view whole, std::string_view part) {
    if (whole.empty() || !part.starts_with(whole)) return false;
    const std::string_view rest = part.substr(whole.size());
    return rest.empty() || rest[0] == '.' || rest[0] == '[' || rest[0] == ':';
}

bool IsCovered(std::string_view name) {
    return IsIn(Current().covered, name);
}

bool IsPartCovered(std::string_view name) {
    return Any(Current().covered,
               [name](const std::string& other) { return Contains(other, name) || Contains(name, other); });
}

bool IsHighlighted(std::string_view name) {
    return Any(Current().highlighted,
               [name](const std::string& other) { return Contains(other, name) || Contains(name, other); });
}

bool IsSought(std::span<const char* const> names) {
    const Targets& targets = Current();
    if (targets.frames_of_search <= 0) return false;
    return std::any_of(names.begin(), names.end(), [&](const char* name) {
        return Any(targets.highlighted, [name](const std::string& sought) { return Contains(name, sought); });
    });
}

bool IsListed(std::string_view name) {
    return !IsListing() || IsIn(Current().listed, name);
}

bool IsListing() {
    return !Current().listed.empty();
}

bool Offers(std::string_view name) {
    const Context& context = CurrentContext();
    return !context.printed && (!context.targets.offered || IsIn(*context.targets.offered, name));
}

bool HasPlainTitles() {
    return Current().offered.has_value();
}

void OpenNextSection() {
    Current().opens_next = true;
}

void MarkTarget(std::string_view name) {
    MarkTarget(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

void MarkTarget(std::string_view name, ImVec2 min, ImVec2 max) {
    Targets& targets = Current();
    for (const std::string& highlighted : targets.highlighted) {
        if (!Contains(highlighted, name)) continue;
        BringIntoView(targets, min, max);
        const ImDrawList* window = ImGui::GetWindowDrawList();
        const ImVec2 clip_min = window->GetClipRectMin(), clip_max = window->GetClipRectMax();
        const ImVec2 seen_min(std::max(min.x, clip_min.x), std::max(min.y, clip_min.y));
        const ImVec2 seen_max(std::min(max.x, clip_max.x), std::min(max.y, clip_max.y));
        if (seen_min.x >= seen_max.x || seen_min.y >= seen_max.y) continue;
        const auto before = std::find_if(targets.found.begin(), targets.found.end(), [&](const Targets::Found& found) {
            // Labels in two views, which have different clip edges, are two targets; the parts of a table are one.
            const bool is_apart =
                highlighted.starts_with("label:") && (found.clip_min.x != clip_min.x || found.clip_min.y != clip_min.y);
            return found.name == highlighted && found.window == window && !is_apart;
        });
        if (before == targets.found.end()) {
            targets.found.push_back({highlighted, window, seen_min, seen_max, clip_min});
            continue;
        }
        before->min = ImVec2(std::min(before->min.x, seen_min.x), std::min(before->min.y, seen_min.y));
        before->max = ImVec2(std::max(before->max.x, seen_max.x), std::max(before->max.y, seen_max.y));
    }
}

void MarkLine(std::string_view name) {
    MarkLine(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

void MarkLine(std::string_view name, ImVec2 min, ImVec2 max) {
    // The frame's stroke is just outside the line: thick strokes must not cover letters.
    const float inset = Px(frame_margin) - 0.5F * FrameStroke();
    MarkTarget(name, ImVec2(min.x, min.y + inset), ImVec2(max.x, max.y - inset));
}

void Plate(const char* label, ImVec2 size) {
    const ImVec2 min = ImGui::GetCursorScreenPos();
    size = ImVec2(std::max(size.x, 1.0F), std::max(size.y, 1.0F));
    ImGui::Dummy(size);
    const ImVec2 max(min.x + size.x, min.y + size.y);
    DrawPlate(ImGui::GetWindowDrawList(), min, max);
    inner::RecordRect(label, min, max, "?");
}

void CoveredControl(const char* label, float width) {
    if (width <= 0.0F) width = ImGui::CalcItemWidth();
    const inner::Labelled labelled(label, width);
    Plate(label, {width, ImGui::GetFrameHeight()});
}

void DrawPlate(ImDrawList* draw, ImVec2 min, ImVec2 max) {
    const Context& context = CurrentContext();
    const Palette& palette = context.palette;
    draw->AddRectFilled(min, max, palette.raised, Px(4));
    draw->AddRect(min, max, palette.border, Px(4), 0, Px(1) * palette.stroke);
    const inner::Face heading = inner::FaceOf(context.fonts.heading);
    const inner::Face face{heading.font, std::min(heading.size, (max.y - min.y) * 0.9F)};
    const ImVec2 size = face.Measure("?");
    face.Draw(draw, ImVec2(std::floor((min.x + max.x - size.x) * 0.5F), std::floor((min.y + max.y - size.y) * 0.5F)),
              palette.quiet, "?");
}

TargetScope::TargetScope(std::string_view name) {
    Current().scopes.push_back({std::string(name)});
}

TargetScope::TargetScope(std::span<const char* const> names) {
    Current().scopes.emplace_back(names.begin(), names.end());
}

TargetScope::~TargetScope() {
    Current().scopes.pop_back();
}

void DrawHighlights(float bottom) {
    const Targets& targets = Current();
    if (targets.found.empty()) return;
    const Palette& palette = CurrentContext().palette;
    const ImVec2 screen(ImGui::GetIO().DisplaySize.x, std::min(bottom, ImGui::GetIO().DisplaySize.y));
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(screen);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
    ImGui::Begin("highlights", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float margin = Px(frame_margin);
    draw->PushClipRectFullScreen();
    for (const Targets::Found& found : targets.found) {
        const ImVec2 min(std::floor(std::max(found.min.x - margin, 0.0F)),
                         std::floor(std::max(found.min.y - margin, 0.0F))),
            max(std::ceil(std::min(found.max.x + margin, screen.x)),
                std::ceil(std::min(found.max.y + margin, screen.y)));
        draw->AddRect(min, max, palette.accent, Px(3), 0, FrameStroke());
        inner::RecordRect("highlight", min, max);
    }
    draw->PopClipRect();
    ImGui::End();
    ImGui::PopStyleVar();
}

namespace inner {

void BeginTargets(Targets& targets) {
    targets.found.clear();
    targets.scrolled.clear();
    targets.scopes.clear();
    targets.opens_next = false;
    if (targets.sought != targets.highlighted) {
        targets.sought = targets.highlighted;
        targets.frames_of_search = targets.highlighted.empty() ? 0 : search_frames;
    } else if (targets.frames_of_search > 0) {
        --targets.frames_of_search;
    }
}

std::string TargetOfBox(int component) {
    const Targets& targets = Current();
    if (targets.empty() || targets.scopes.empty()) return {};
    const std::vector<std::string>& scope = targets.scopes.back();
    const auto index = static_cast<std::size_t>(std::max(component, 0));
    if (scope.size() > 1) return index < scope.size() ? scope[index] : std::string();
    if (scope.front().empty()) return {};
    return component < 0 ? scope.front() : scope.front() + "[" + std::to_string(component) + "]";
}

bool CoveredBox(const char* id_text, int component, ImVec2 size) {
    const std::string name = TargetOfBox(component);
    if (name.empty() || !IsCovered(name)) return false;
    Plate(id_text, size);
    MarkTarget(name);
    return true;
}

void MarkBox(int component) {
    if (const std::string name = TargetOfBox(component); !name.empty()) MarkTarget(name);
}

}  // namespace inner
}  // namespace widgets
