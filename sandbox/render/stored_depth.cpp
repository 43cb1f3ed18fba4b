#include "render/stored_depth.h"

#include <cmath>

#include "render/pass_state.h"

namespace viewing {
namespace {

constexpr int columns = 64;

/// Draws one rectangle for each column of pixels. Its four corners have the same depth, so that the depth is rounded in
/// the same way everywhere in the column before it is stored.
constexpr const char* vertex_source = R"(
uniform float first_ndc;
uniform float step_ndc;
void main() {
    int column = gl_VertexID / 6, corner = gl_VertexID % 6;
    float x = float(column) + (corner == 1 || corner == 2 || corner == 4 ? 1.0 : 0.0);
    float y = corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0;
    gl_Position = vec4(x / 32.0 - 1.0, y, first_ndc + float(column) * step_ndc, 1.0);
}
)";
constexpr const char* fragment_source = R"(
out vec4 color;
void main() { color = vec4(1.0); }
)";

class Rows {
public:
    Rows(const gl::Program& program, gl::DepthKind kind)
        : program_(program),
          target_({{columns, 1}, 0, kind}),
          vertices_(gl::make_vertex_array()),
          first_(glGetUniformLocation(program.name(), "first_ndc")),
          step_(glGetUniformLocation(program.name(), "step_ndc")) {}

    /// Draws a ramp of window depths that begins at `first`. Returns the number of columns whose stored depth differs
    /// from that of their right neighbor.
    int differing(double first, double step) const {
        begin();
        draw(GL_ALWAYS, first, step);
        begin_count();
        draw(GL_EQUAL, first + step, step);
        return columns - passed();
    }

    /// Returns how many steps, at most 64, `units` of polygon offset move a plane at window depth `depth`.
    int moved(double depth, double step, float units) const {
        begin();
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(0.0F, units);
        draw(GL_ALWAYS, depth, 0.0);
        glDisable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(0.0F, 0.0F);
        begin_count();
        draw(GL_LEQUAL, depth + step, step);
        return passed();
    }

private:
    void begin() const {
        glBindFramebuffer(GL_FRAMEBUFFER, target_.draw_framebuffer());
        glViewport(0, 0, columns, 1);
        glUseProgram(program_.name());
        glBindVertexArray(vertices_.name());
        glEnable(GL_DEPTH_TEST);
        glDepthMask(GL_TRUE);
    }
    /// From here on, fragments that pass draw white and write no depth.
    void begin_count() const {
        glClear(GL_COLOR_BUFFER_BIT);
        glDepthMask(GL_FALSE);
    }
    /// Draws a ramp. Window depths from 1/4 to 1 reach the buffer exactly if they are multiples of 2⁻²⁵, or of 2⁻²⁴
    /// above 1/2.
    void draw(GLenum func, double first, double step) const {
        glDepthFunc(func);
        glUniform1f(first_, static_cast<GLfloat>(2.0 * first - 1.0));
        glUniform1f(step_, static_cast<GLfloat>(2.0 * step));
        glDrawArrays(GL_TRIANGLES, 0, 6 * columns);
    }
    int passed() const {
        const std::vector<std::uint8_t> bytes = gl::read_pixels(target_.single_framebuffer(), {columns, 1});
        int count = 0;
        for (std::size_t i = 0; i < bytes.size(); i += 4) count += bytes[i] > 127 ? 1 : 0;
        return count;
    }

    const gl::Program& program_;
    gl::Target target_;
    gl::VertexArray vertices_;
    GLint first_, step_;
};

/// Whether all neighbors differ: they do if a ramp rises by one code per column, but if it rises by half a code, only
/// every other pair differs.
bool all_differ(int count) {
    return count > columns * 3 / 4;
}

DepthPrecision precision_of(const Rows& rows) {
    const int fine = rows.differing(0.75, std::exp2(-24));
    if (all_differ(fine)) {
        // Below 1/2, the steps of a float are half as wide.
        const bool is_float = all_differ(rows.differing(0.375, std::exp2(-25)));
        return is_float ? DepthPrecision{32, true} : DepthPrecision{24, false};
    }
    // A few differences may be due to a single boundary between two codes of a format with far fewer bits.
    const bool has_many = fine >= columns / 8;
    const int steps = has_many ? 24 : 16, differ = has_many ? fine : rows.differing(0.75, std::exp2(-16));
    return {steps + static_cast<int>(std::lround(std::log2(std::max(differ, 1) / static_cast<double>(columns)))),
            false};
}

StoredDepth measured(const gl::Program& program, gl::DepthKind kind) {
    const Rows rows(program, kind);
    constexpr float units = 4.0F;  // enough to detect a unit that is only a fraction of a code
    StoredDepth stored;
    stored.precision = precision_of(rows);
    const int codes = rows.moved(0.75, std::exp2(-std::min(stored.precision.bits, 24)), units);
    stored.unit_codes = static_cast<double>(codes) / units;
    return stored;
}

}  // namespace

Result<StoredDepth> measure_stored_depth(const gl::Capabilities& capabilities, gl::DepthKind kind) {
    const Result<gl::Program> program = gl::make_program(vertex_source, fragment_source);
    if (!program) return Error{program.error()};
    restore_defaults(capabilities);
    const StoredDepth stored = measured(*program, kind);
    restore_defaults(capabilities);
    return stored;
}

}  // namespace viewing
