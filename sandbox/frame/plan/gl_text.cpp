// Lists the GL calls that change the state from one pass to the next, in the lecture's words, for the panel.
#include <algorithm>

#include "frame/plan/plan.h"
#include "text/per_enum.h"

namespace viewing {
namespace {

std::string number(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text += '0';
    return text;
}

std::string mask_text(int value) {
    static constexpr const char* digits = "0123456789ABCDEF";
    return std::string("0x") + digits[value >> 4 & 15] + digits[value & 15];
}

}  // namespace

std::string gl_name(CompareFunc func) {
    static constexpr auto names = per_enum<CompareFunc>("GL_NEVER", "GL_LESS", "GL_EQUAL", "GL_LEQUAL", "GL_GREATER",
                                                        "GL_NOTEQUAL", "GL_GEQUAL", "GL_ALWAYS");
    return names[func];
}

std::string gl_name(CullFace face) {
    static constexpr auto names = per_enum<CullFace>("GL_FRONT", "GL_BACK", "GL_FRONT_AND_BACK");
    return names[face];
}

std::string gl_name(FrontFace front) {
    return front == FrontFace::ccw ? "GL_CCW" : "GL_CW";
}

namespace {

/// Collects calls, skipping those that change nothing.
class Calls {
public:
    std::vector<Message> list;

    void add(std::string call) { list.push_back(verbatim(std::move(call))); }
    void enable(const char* capability, bool on, bool was_on) {
        if (on != was_on) add((on ? "glEnable(" : "glDisable(") + std::string(capability) + ")");
    }
    /// `is_known`: GL already has the value in `before`; false if the test was disabled, because the parameters of a
    /// disabled test are not sent to GL.
    void change(const std::string& call, const std::string& before, bool is_known = true) {
        if (call != before || !is_known) add(call);
    }
};

std::string vector_text(const glm::dvec4& vector) {
    return number(vector.x) + ", " + number(vector.y) + ", " + number(vector.z) + ", " + number(vector.w);
}

std::string truth(bool is_true) {
    return is_true ? "GL_TRUE" : "GL_FALSE";
}

Message stencil_func(const Pass& pass) {
    return listed(
        {verbatim("glStencilFunc(" + gl_name(pass.stencil.func)),
         pass.marks_objects ? message("each object's mark") : verbatim(std::to_string(pass.stencil.reference)),
         verbatim(mask_text(pass.stencil.read_bits) + ")")});
}

std::string stencil_op(const Pass& pass) {
    static constexpr const char* ops[] = {"GL_KEEP", "GL_REPLACE", "GL_INCR", "GL_DECR", "GL_INVERT", "GL_ZERO"};
    return std::string("glStencilOp(GL_KEEP, GL_KEEP, ") + ops[static_cast<int>(pass.stencil.on_pass)] + ")";
}

std::string color_mask(const Pass& pass) {
    const std::string writes = truth(pass.color_write);
    return "glColorMask(" + writes + ", " + writes + ", " + writes + ", " + writes + ")";
}

void depth_calls(Calls& calls, const Pass& pass, const Pass& before) {
    calls.enable("GL_DEPTH_TEST", pass.depth.test, before.depth.test);
    if (!pass.depth.test) return;
    calls.change("glDepthFunc(" + gl_name(pass.depth.func) + ")", "glDepthFunc(" + gl_name(before.depth.func) + ")",
                 before.depth.test);
    calls.change("glDepthMask(" + truth(pass.depth.write) + ")", "glDepthMask(" + truth(before.depth.write) + ")",
                 before.depth.test);
}

void cull_calls(Calls& calls, const Pass& pass, const Pass& before) {
    calls.enable("GL_CULL_FACE", pass.cull.enabled, before.cull.enabled);
    if (!pass.cull.enabled) return;
    calls.change("glCullFace(" + gl_name(pass.cull.face) + ")", "glCullFace(" + gl_name(before.cull.face) + ")",
                 before.cull.enabled);
    calls.change("glFrontFace(" + gl_name(pass.cull.front_face) + ")",
                 "glFrontFace(" + gl_name(before.cull.front_face) + ")", before.cull.enabled);
}

void stencil_calls(Calls& calls, const Pass& pass, const Pass& before) {
    calls.enable("GL_STENCIL_TEST", pass.stencil.test, before.stencil.test);
    if (!pass.stencil.test) return;
    const bool is_known = before.stencil.test;
    if (Message func = stencil_func(pass); !is_known || !(func == stencil_func(before))) calls.list.push_back(func);
    calls.change(stencil_op(pass), stencil_op(before), is_known);
    calls.change("glStencilMask(" + mask_text(pass.stencil.write_bits) + ")",
                 "glStencilMask(" + mask_text(before.stencil.write_bits) + ")", is_known);
}

void blend_calls(Calls& calls, const Pass& pass, const Pass& before) {
    calls.change(color_mask(pass), color_mask(before));
    calls.enable("GL_BLEND", pass.blend != Blend::none, before.blend != Blend::none);
    if (pass.blend == Blend::none || pass.blend == before.blend) return;
    calls.add(pass.blend == Blend::alpha ? "glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)"
                                         : "glBlendFunc(GL_ONE, GL_ONE)");
}

Message remarked(const Message& call, const Message& remark) {
    return listed({call, remark}, "  // ");
}

/// Returns whether the shader adds the offset: GL ignores glPolygonOffset where the fragment shader writes the depth,
/// as it does for the logarithm.
bool adds_offset_in_shader(const FramePlan& frame) {
    return frame.depth_mapping == DepthMapping::logarithmic && !frame.logarithm_per_vertex;
}

Message offset_call(const FramePlan& frame, const DepthOffset& offset) {
    const std::string values = number(offset.factor) + ", " + number(offset.units) + ")";
    return adds_offset_in_shader(frame)
               ? remarked(verbatim("glUniform2f(depth_offset, " + values),
                          message("added to gl_FragDepth, which glPolygonOffset does not change"))
               : verbatim("glPolygonOffset(" + values);
}

void offset_calls(Calls& calls, const Pass& pass, const Pass& before, const FramePlan& frame) {
    const DepthOffset offset = pass.offset.value_or(DepthOffset{}),
                      offset_before = before.offset.value_or(DepthOffset{});
    if (!adds_offset_in_shader(frame))
        calls.enable("GL_POLYGON_OFFSET_FILL", offset != DepthOffset{}, offset_before != DepthOffset{});
    if (offset != DepthOffset{} && offset != offset_before) calls.list.push_back(offset_call(frame, offset));
    const bool draws_decals =
        frame.has_decals && pass.subject == Subject::objects && pass.chosen != Chosen::bases && !pass.offset;
    if (!draws_decals || frame.decal_offset == DepthOffset{}) return;
    const Message remark = message("for decals only");
    if (!adds_offset_in_shader(frame)) calls.list.push_back(remarked("glEnable(GL_POLYGON_OFFSET_FILL)", remark));
    calls.list.push_back(remarked(offset_call(frame, frame.decal_offset), remark));
}

void clip_calls(Calls& calls, const Pass& pass, const Pass& before) {
    for (std::size_t plane = 0; plane < std::max(pass.clip_planes.size(), before.clip_planes.size()); ++plane) {
        const bool on = plane < pass.clip_planes.size(), was_on = plane < before.clip_planes.size();
        calls.enable(("GL_CLIP_DISTANCE" + std::to_string(plane)).c_str(), on, was_on);
        if (on && !(was_on && pass.clip_planes[plane] == before.clip_planes[plane]))
            calls.add("glUniform4f(clip_plane" + std::to_string(plane) + ", " + vector_text(pass.clip_planes[plane]) +
                      ")");
    }
}

bool is_lit(const Pass& pass) {
    return pass.shading == Shading::lit && pass.color_write;
}

/// Adds the calls that set a pass's colors: the lights of a lit pass, the color of a shadow, the alpha of a patch.
void color_calls(Calls& calls, const Pass& pass, const Pass& before) {
    if (!pass.color_write) return;
    if (is_lit(pass))
        for (std::size_t light = 0; light < pass.lights_world.size(); ++light) {
            const bool is_known = is_lit(before) && light < before.lights_world.size() &&
                                  before.lights_world[light] == pass.lights_world[light];
            if (!is_known)
                calls.add("glUniform4f(light" + std::to_string(light + 1) + ", " +
                          vector_text(pass.lights_world[light]) + ")");
        }
    const bool has_color = before.color_write && before.shading == pass.shading && before.color == pass.color;
    if (pass.shading == Shading::flat && !has_color) calls.add("glUniform4f(color, " + vector_text(pass.color) + ")");
    const bool is_patch = pass.subject == Subject::patch, was_patch = before.subject == Subject::patch;
    if (is_patch && pass.shading != Shading::flat && !(was_patch && has_color))
        calls.add("glUniform1f(alpha, " + number(pass.color.a) + ")");
}

/// Resets the state that the previous frame left behind, above all the masks, which glClear obeys. The first frame
/// needs none of this.
void take_back(Calls& calls, const FramePlan& frame) {
    const std::vector<Pass>& passes = frame.passes;
    if (passes.empty()) return;
    const Pass first = first_gl_state(), &last = passes.back();
    depth_calls(calls, first, last);
    cull_calls(calls, first, last);
    stencil_calls(calls, first, last);
    blend_calls(calls, first, last);
    offset_calls(calls, first, last, frame);
    clip_calls(calls, first, last);
    const auto told_depth =
        std::find_if(passes.rbegin(), passes.rend(), [](const Pass& pass) { return pass.depth.test; });
    if (told_depth != passes.rend() && !told_depth->depth.write) calls.add("glDepthMask(GL_TRUE)");
    const auto told_stencil =
        std::find_if(passes.rbegin(), passes.rend(), [](const Pass& pass) { return pass.stencil.test; });
    if (told_stencil != passes.rend() && told_stencil->stencil.write_bits != StencilState{}.write_bits)
        calls.add("glStencilMask(" + mask_text(StencilState{}.write_bits) + ")");
}

}  // namespace

Pass first_gl_state() {
    Pass state;
    state.depth.test = false;
    state.matrices = "";
    return state;
}

std::vector<Message> clear_calls(const FramePlan& frame) {
    Calls calls;
    take_back(calls, frame);
    if (!frame.mask_on_while_clearing) calls.add("glDepthMask(GL_FALSE)");
    calls.add("glClearDepth(" + number(frame.clear_depth_value) + ")");
    calls.add(frame.clear_depth ? "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)"
                                : "glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)");
    if (!frame.mask_on_while_clearing) calls.add("glDepthMask(GL_TRUE)");
    return calls.list;
}

std::vector<Message> gl_calls(const FramePlan& frame, const Pass& pass, const Pass& before) {
    Calls calls;
    depth_calls(calls, pass, before);
    cull_calls(calls, pass, before);
    stencil_calls(calls, pass, before);
    blend_calls(calls, pass, before);
    offset_calls(calls, pass, before, frame);
    clip_calls(calls, pass, before);
    if (!pass.matrices.empty() && pass.matrices != before.matrices)
        calls.add("glUniformMatrix4fv(clip_from_world, " + pass.matrices + ")");
    color_calls(calls, pass, before);
    static constexpr auto draws = per_enum<Subject>("drawObjects()", "drawPatch()", "drawFarSquare()", "drawInOrder()",
                                                    "drawPixels()", "drawDifference()");
    calls.add(pass.chosen == Chosen::bases    ? "drawObjectsButDecals()"
              : pass.chosen == Chosen::decals ? "drawDecals()"
                                              : draws[pass.subject]);
    return calls.list;
}

}  // namespace viewing
