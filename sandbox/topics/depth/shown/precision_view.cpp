#include "topics/depth/shown/precision_view.h"

#include <algorithm>
#include <cmath>

#include "state/fields.h"
#include "text/catalogue.h"
#include "topics/depth/numbers/depth_precision.h"
#include "topics/depth/numbers/near_advice.h"
#include "ui/parts/look.h"
#include "ui/parts/view_window.h"
#include "widgets/depth.h"

namespace viewing {
namespace {

ImU32 color_of(DepthMapping mapping) {
    switch (mapping) {
        case DepthMapping::standard:
            return palette().light;
        case DepthMapping::reversed:
            return palette().plane;
        default:
            return palette().mirror;
    }
}

constexpr double usual_min_distance = 1e-3;

/// The range over which near and far can be dragged. It is the same for all their usual values, so the axis never moves
/// under the pointer. A value typed outside that range widens it, and the range stays wide while the value is dragged
/// back.
widgets::ChartAxis distance_axis(const ProjectionParams& now, const ProjectionParams& before) {
    constexpr double usual_min = usual_min_distance, usual_max = 1e4;
    const auto decade = [](double z, bool is_upper) {
        return std::pow(10.0, is_upper ? std::ceil(std::log10(z)) : std::floor(std::log10(z)));
    };
    const auto positive = [](double near) { return near > 0.0 ? near : usual_min; };
    const auto finite = [](double far) { return std::isfinite(far) ? far : usual_max; };
    return {.title = marked("eye distance z"),
            .min = std::min(usual_min, decade(std::min(positive(now.near), positive(before.near)), false)),
            .max = std::max({usual_max, decade(finite(now.far), true), decade(finite(before.far), true)})};
}

/// How many curves there are besides the one for the current format.
enum class OtherCurves { none, few, all };

/// Twelve names are illegible from the back row. On stage, shows other curves only if the state lists the control of
/// the format or of the mapping, and then only a few.
OtherCurves other_curves(const LayoutParams& layout, bool is_small) {
    if (!widgets::CurrentContext().is_on_stage) return is_small ? OtherCurves::few : OtherCurves::all;
    const bool changes_format =
        std::any_of(layout.controls.begin(), layout.controls.end(),
                    [](const std::string& path) { return path == "depth.format" || path == "depth.mapping"; });
    return changes_format ? OtherCurves::few : OtherCurves::none;
}

/// Whether the chart shows this format and mapping even if there are few curves.
bool is_telling(const StepCurve& curve) {
    return curve.mapping == DepthMapping::standard ||
           (curve.mapping == DepthMapping::reversed ? curve.format == DepthFormat::d32f
                                                    : curve.format == DepthFormat::d24);
}

/// The curves in the form that the chart widget takes, together with the names that they point to.
class ChartCurves {
public:
    ChartCurves(PrecisionCurves curves, OtherCurves wanted) : curves_(std::move(curves)) {
        names_.reserve(curves_.others.size() + 1);
        add(curves_.current, true);
        for (const StepCurve& other : curves_.others)
            if (wanted == OtherCurves::all || (wanted == OtherCurves::few && is_telling(other))) add(other, false);
    }
    ChartCurves(const ChartCurves&) = delete;
    ChartCurves& operator=(const ChartCurves&) = delete;

    std::span<const widgets::ChartCurve> all() const { return shown_; }
    /// The terms of the step Δz, except covered ones.
    std::vector<widgets::ChartCurve> terms() const {
        std::vector<widgets::ChartCurve> terms;
        if (!widgets::IsCovered("chart:precision.quantization"))
            terms.push_back({.name = marked("quantization"), .color = palette().text, .points = curves_.quantization});
        if (!widgets::IsCovered("chart:precision.arithmetic"))
            terms.push_back({.name = marked("arithmetic"), .color = palette().quiet, .points = curves_.arithmetic});
        return terms;
    }

private:
    void add(const StepCurve& curve, bool is_current) {
        names_.push_back(say(short_name(curve.format, curve.mapping)));
        shown_.push_back({.name = names_.back().c_str(),
                          .color = color_of(curve.mapping),
                          .points = curve.points,
                          .emphasized = is_current});
    }

    PrecisionCurves curves_;
    std::vector<std::string> names_;
    std::vector<widgets::ChartCurve> shown_;
};

void draw_chart(Session& session, const Derived& derived, const std::vector<SeenThing>& seen, float height,
                double cursor_z) {
    Params& params = session.params;
    const float width = ImGui::GetContentRegionAvail().x;
    const bool is_small = height < px(240.0F);
    const bool is_on_stage = widgets::CurrentContext().is_on_stage;
    const ChartCurves curves(precision_curves(params, derived), other_curves(params.view.layout, is_small));
    const std::vector<widgets::ChartCurve> terms = curves.terms();
    // The names of the marks must fit into the upper half of the plot, side by side or stacked.
    const float most_marks = std::clamp(std::min(width / px(90.0F), height / px(45.0F)), 2.0F, 8.0F);
    const std::vector<DistanceMark> things = distance_marks(seen, static_cast<std::size_t>(most_marks));
    std::vector<widgets::DepthMark> marks;
    std::vector<std::string> labels;
    labels.reserve(things.size());
    for (const DistanceMark& thing : things) {
        labels.push_back(is_small || is_on_stage ? "" : say(thing.label));
        marks.push_back({labels.back().c_str(), thing.z, thing.is_plane ? palette().plane : 0});
    }
    const ProjectionParams defaults;
    ProjectionParams& projection = params.projection;
    double chart_near = projection.near > 0.0 ? projection.near : usual_min_distance;  // the axis has no place for 0
    if (widgets::PrecisionChart("precision", curves.all(), chart_near, projection.far,
                                {.x = distance_axis(projection, session.before_latest_edit().projection),
                                 .y = {.title = marked("safe gap")},
                                 .terms = terms,
                                 .marks = marks,
                                 .cursor_z = cursor_z,
                                 .default_near = defaults.near,
                                 .default_far = defaults.far,
                                 .target = "chart:precision",
                                 .size = {width, height}})) {
        if (projection.near > 0.0 || chart_near != usual_min_distance) projection.near = chart_near;
        clamp_to_ranges(params);
    }
}

/// A sentence of advice and its button, which is on the same line if both fit and below the sentence otherwise.
class AdviceLine {
public:
    explicit AdviceLine(const NearAdvice& advice)
        : advice_(advice), sentence_(say(advice.sentence)), room_(ImGui::GetContentRegionAvail().x) {
        if (!has_button()) return;
        const float width = ImGui::CalcTextSize(tr(button())).x + px(24.0F);
        if (room_ - width >= px(240.0F))
            button_width_ = width;
        else
            button_height_ = ImGui::GetTextLineHeight() + px(10.0F);
    }
    float height() const { return sentence_height() + button_height_ + ImGui::GetStyle().ItemSpacing.y; }

    void draw(Params& params) const {
        ImGui::BeginChild("advice", {room_ - button_width_, sentence_height()}, false, ImGuiWindowFlags_NoScrollbar);
        ImGui::PushFont(widgets::CurrentContext().fonts.note);
        widgets::Trouble(sentence_.c_str());
        ImGui::PopFont();
        ImGui::EndChild();
        widgets::MarkTarget("advice");
        if (!has_button()) return;
        if (button_width_ > 0.0F) ImGui::SameLine();
        if (!widgets::SmallButton(button())) return;
        params.projection.move_near(*advice_.near);
        clamp_to_ranges(params);
    }

private:
    bool has_button() const { return advice_.near && widgets::OffersButton(button()); }
    const char* button() const { return advice_.cuts ? marked("Lower near") : marked("Raise near"); }
    float sentence_height() const {
        ImGui::PushFont(widgets::CurrentContext().fonts.note);
        const float height = widgets::TroubleHeight(sentence_.c_str(), room_ - button_width_);
        ImGui::PopFont();
        return height + px(4.0F);
    }

    const NearAdvice& advice_;
    std::string sentence_;
    float room_;                                        ///< width available to the sentence and the button
    float button_width_ = 0.0F, button_height_ = 0.0F;  ///< width taken from the sentence, or height added below
};

}  // namespace

void draw_precision_view(Session& session, const Derived& derived, const Rect& rect, double cursor_z) {
    const ViewWindow view("precision view", rect);
    const std::vector<SeenThing> seen = seen_things(session.params, derived, session.scene());
    const std::optional<NearAdvice> advice = near_advice(session.params, derived, seen);
    const float room = ImGui::GetContentRegionAvail().y;
    if (!advice || widgets::IsCovered("advice"))
        return draw_chart(session, derived, seen, std::max(room, px(120.0F)), cursor_z);
    const AdviceLine line(*advice);
    // If the chart and the sentence do not both fit, the chart fills the view, and the user can scroll down to the
    // sentence. In a presentation, the sentence is omitted instead.
    const bool has_room = room - line.height() >= px(120.0F);
    const float height = has_room ? room - line.height() : std::max(room, px(120.0F));
    draw_chart(session, derived, seen, height, cursor_z);
    if (has_room || !widgets::HasPlainTitles()) line.draw(session.params);
}

}  // namespace viewing
