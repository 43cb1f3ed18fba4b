// A pass as the GL calls that it becomes, in the lecture's words: what the panel lists.
#include "frame/plan.h"

namespace viewing {
namespace {

std::string number(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text += '0';
    return text;
}

std::string bits(int value) {
    static constexpr const char* digits = "0123456789ABCDEF";
    return std::string("0x") + digits[value >> 4 & 15] + digits[value & 15];
}

}  // namespace

std::string gl_name(CompareFunc func) {
    static constexpr const char* names[] = {"GL_NEVER",   "GL_LESS",     "GL_EQUAL",  "GL_LEQUAL",
                                            "GL_GREATER", "GL_NOTEQUAL", "GL_GEQUAL", "GL_ALWAYS"};
    return names[static_cast<std::size_t>(func)];
}

std::string gl_name(CullFace face) {
    static constexpr const char* names[] = {"GL_FRONT", "GL_BACK", "GL_FRONT_AND_BACK"};
    return names[static_cast<std::size_t>(face)];
}

std::string gl_name(FrontFace front) {
    return front == FrontFace::ccw ? "GL_CCW" : "GL_CW";
}

std::vector<std::string> gl_calls(const Pass& pass) {
    std::vector<std::string> calls;
    if (pass.depth.test) {
        calls.push_back("glEnable(GL_DEPTH_TEST)");
        calls.push_back("glDepthFunc(" + gl_name(pass.depth.func) + ")");
        calls.push_back(pass.depth.write ? "glDepthMask(GL_TRUE)" : "glDepthMask(GL_FALSE)");
    } else {
        calls.push_back("glDisable(GL_DEPTH_TEST)");
    }
    if (pass.cull.enabled) {
        calls.push_back("glEnable(GL_CULL_FACE)");
        calls.push_back("glCullFace(" + gl_name(pass.cull.face) + ")");
        calls.push_back("glFrontFace(" + gl_name(pass.cull.front_face) + ")");
    }
    if (pass.stencil.test) {
        static constexpr const char* ops[] = {"GL_KEEP", "GL_REPLACE", "GL_INCR", "GL_DECR", "GL_INVERT", "GL_ZERO"};
        calls.push_back("glEnable(GL_STENCIL_TEST)");
        calls.push_back("glStencilFunc(" + gl_name(pass.stencil.func) + ", " +
                        (pass.marks_objects ? "mark of each object" : std::to_string(pass.stencil.reference)) + ", " +
                        bits(pass.stencil.read_bits) + ")");
        if (pass.stencil.write_bits != 0xFF) calls.push_back("glStencilMask(" + bits(pass.stencil.write_bits) + ")");
        calls.push_back(std::string("glStencilOp(GL_KEEP, GL_KEEP, ") + ops[static_cast<int>(pass.stencil.on_pass)] +
                        ")");
    }
    if (!pass.color_write) calls.push_back("glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE)");
    if (pass.blend != Blend::none) {
        calls.push_back("glEnable(GL_BLEND)");
        calls.push_back(pass.blend == Blend::alpha ? "glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)"
                                                   : "glBlendFunc(GL_ONE, GL_ONE)");
    }
    if (pass.offset && *pass.offset != DepthOffset{}) {
        calls.push_back("glEnable(GL_POLYGON_OFFSET_FILL)");
        calls.push_back("glPolygonOffset(" + number(pass.offset->factor) + ", " + number(pass.offset->units) + ")");
    }
    for (std::size_t plane = 0; plane < pass.clip_planes.size(); ++plane)
        calls.push_back("glEnable(GL_CLIP_DISTANCE" + std::to_string(plane) + ")");
    static constexpr const char* draws[] = {"drawObjects()", "drawPatch()",  "drawFarSquare()",
                                            "drawInOrder()", "drawPixels()", "drawDifference()"};
    calls.emplace_back(pass.chosen == Chosen::bases    ? "drawObjectsButDecals()"
                       : pass.chosen == Chosen::decals ? "drawDecals()"
                                                       : draws[static_cast<std::size_t>(pass.subject)]);
    return calls;
}

}  // namespace viewing
