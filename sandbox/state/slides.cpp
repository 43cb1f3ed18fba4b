#include "state/slides.h"

#include <array>

#include "text/catalogue.h"
#include "text/words.h"

namespace viewing {
namespace {

/// The subject of each slide, from slide 1 on.
constexpr std::array subjects{marked("Viewing"),
                              marked("Camera movement"),
                              marked("Camera position and yaw"),
                              marked("Fly and walk"),
                              marked("Occlusion"),
                              marked("Hidden surface removal"),
                              marked("Depth test and culling"),
                              marked("Color buffer and depth buffer"),
                              marked("Depth per pixel"),
                              marked("The z-buffer algorithm"),
                              marked("The depth buffer in OpenGL"),
                              marked("Depth fighting"),
                              marked("Planar shadow"),
                              marked("Planar shadow: the matrix"),
                              marked("Shadow on any plane"),
                              marked("Shadow on any plane: the matrix"),
                              marked("The shadow matrix"),
                              marked("ShadowMatrix"),
                              marked("Without and with shadow"),
                              marked("Reflection"),
                              marked("Planar reflection"),
                              marked("Planar reflection: the matrix"),
                              marked("R for the coordinate planes"),
                              marked("ReflectionMatrix")};

}  // namespace

std::string slide_heading(const std::vector<int>& slides) {
    if (slides.empty()) return "";
    const int slide = slides.front();
    const auto at = static_cast<std::size_t>(slide - 1);
    if (at >= subjects.size()) return say("Slide {slide}", "slide"_a = slide);
    return say("Slide {slide} · {subject}", "slide"_a = slide, "subject"_a = tr(subjects[at]));
}

std::optional<int> searched_slide(std::string_view search) {
    const std::string words = in_lower_case(std::string(search));
    std::string_view rest = words;
    if (rest.starts_with("slide"))
        rest.remove_prefix(5);
    else if (rest.starts_with("s"))
        rest.remove_prefix(1);
    else
        return std::nullopt;
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    if (rest.empty() || rest.size() > 3 || rest.find_first_not_of("0123456789") != std::string_view::npos)
        return std::nullopt;
    return std::stoi(std::string(rest));
}

}  // namespace viewing
