// "Why this pixel?": explains a pixel's chain in sentences, in drawing order, with lines to draw in the views. Every
// sentence is computed from the replayed frame. Read pixel_chain.h first.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "frame/problems.h"
#include "topics/why/numbers/casters.h"

namespace viewing {

struct WhyRow {
    enum class Kind { ray, pass, mirror, light, fight, fault, samples, sum };
    Kind kind = Kind::ray;
    Message title = {};                   ///< "Pass 3, Mirror image"
    std::vector<Message> sentences = {};  ///< each begins a line in a view
    std::optional<Color> after = {};      ///< the pixel's color after this row
    int pass = -1;                        ///< index in FramePlan::passes; −1: no pass
    bool is_quiet = false;                ///< changes nothing
    std::string fix = "";                 ///< the setting that removes the problem; "" if none
};

/// A line of the explanation in world space, drawn in the views.
struct WhyLine {
    enum class Kind { sight, light, cut_light, image };
    Kind kind = Kind::sight;
    glm::dvec3 from_world{0.0}, to_world{0.0};
    Message label = {};   ///< at the line's end
    std::size_t row = 0;  ///< the row that it belongs to
};

struct Why {
    Message sentence;  ///< names what the pixel shows, in one or two sentences
    Message fault;     ///< the problem at the pixel; empty if no fix changes the pixel
    std::vector<WhyRow> rows;
    std::vector<WhyLine> lines;
    PixelChain chain;
    std::optional<Color> predicted;  ///< none: this picture's colors are not computed
    std::optional<Color> read_back;  ///< copied from the question
    std::string surface;             ///< scene name of the visible surface, "plane" for a patch; "" for the background
    std::vector<std::string> casters;             ///< names of the objects whose shadow is on the surface
    bool has_shadow = false, has_mirror = false;  ///< a shadow or a mirror image is part of the color
};

/// The input of an explanation. `plan` must be plan(params, derived), and the finder must hold the scene.
struct WhyQuestion {
    const Params& params;
    const Derived& derived;
    const FramePlan& plan;
    const FragmentFinder& finder;
    const Viewport& viewport;
    std::span<const Problem> problems;  ///< of this state: each fix is tried at the pixel
    glm::ivec2 pixel;                   ///< inside the picture
    std::optional<Color> read_back{};   ///< the color in the buffer, if it is known
    /// Runs the hidden-surface method for another state. If `solve` is empty, fixes whose state uses such a method are
    /// not tried.
    std::function<HiddenPictures(const Params&, const Derived&)> solve{};
};
Why why(const WhyQuestion& question);

/// Returns a line with the pixel, a line with the sentence and the fault, one line per row, and an empty line.
Message why_as_text(const Why& why);

// The parts of why(): why_rows.cpp and why_lights.cpp.

/// Returns "the plane", "plane 2", or the object's name.
Message surface_name(const WhyQuestion& question, int object_index);
std::string point_text(const glm::dvec3& point);
/// Returns the comparison and its outcome: "12 < 16, passes".
Message test_phrase(const WhyQuestion& question, const Fragment& fragment);
/// Returns "#5a575b".
std::string hex_of(const Color& color);

void add_ray_row(Why& made, const WhyQuestion& question);
void add_pass_rows(Why& made, const WhyQuestion& question);
void add_mirror_rows(Why& made, const WhyQuestion& question);
void add_light_rows(Why& made, const WhyQuestion& question);
void add_fight_row(Why& made, const WhyQuestion& question);
void add_sample_row(Why& made, const WhyQuestion& question);
void add_sum_row(Why& made, const WhyQuestion& question);

/// Fractions of the color below this, about one level of 255, are not mentioned.
inline constexpr double least_share = 0.004;

/// Returns the surfaces in mirrors that are part of the color, the largest contribution first.
std::vector<const Touch*> images_of(const Why& made, const FramePlan& plan);

}  // namespace viewing
