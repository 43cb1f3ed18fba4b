#include "render/heat.h"

#include <cmath>

#include "render/uniforms.h"

namespace viewing {

void set_heat(const SurfaceProgram& program, const FramePlan& plan, const Pass& pass) {
    set_matrix(program.heat_view_from_world, pass.view_from_world);
    set_colors(program.heat_colors, heat_colors);
    if (!plan.heat) return;
    glUniform2f(program.heat_near_far, static_cast<float>(plan.heat->near), static_cast<float>(plan.heat->far));
    std::array<float, HeatMap::entry_count> logarithms{};
    for (std::size_t entry = 0; entry < logarithms.size(); ++entry)
        logarithms[entry] = static_cast<float>(std::log(plan.heat->onsets[entry]));
    glUniform4fv(program.heat_onsets, static_cast<GLsizei>(logarithms.size() / 4), logarithms.data());
}

void set_heat_gap(const SurfaceProgram& program, const FramePlan& plan, std::size_t object) {
    const bool is_known = plan.heat && object < plan.heat->gap_of_object.size();
    const std::optional<FlatGap> flat = is_known ? plan.heat->gap_of_object[object] : std::nullopt;
    set_vector(program.heat_gap, flat ? glm::vec4(flat->normal_view, flat->gap) : glm::vec4(0.0F, 0.0F, 0.0F, -1.0F));
}

}  // namespace viewing
