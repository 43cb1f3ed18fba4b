// WebGL 2: the calls of OpenGL ES 3.0, with extensions enabled by name.
#include "gl/dialect.h"

#include <emscripten.h>

#include "gl/gl.h"

// Asks the browser's own context object for extensions that this compiler's headers do not have.
EM_JS(int, has_webgl_extension, (const char* name), { return GLctx.getExtension(UTF8ToString(name)) ? 1 : 0; });
EM_JS(void, set_webgl_clip_depths, (int from_zero), {
    const clip = GLctx.getExtension("EXT_clip_control");
    clip["clipControlEXT"](clip["LOWER_LEFT_EXT"], clip[from_zero ? "ZERO_TO_ONE_EXT" : "NEGATIVE_ONE_TO_ONE_EXT"]);
});

EM_JS(void, copy_webgl_pack_buffer, (void* place, int size),
      { GLctx.getBufferSubData(GLctx.PIXEL_PACK_BUFFER, 0, HEAPU8, place, size); });
// Defined in app/browser/page/page.js.
EM_JS(void, tell_webgl_renderer, (char* name, int size), { stringToUTF8(page.rendererName(GLctx), name, size); });

namespace viewing::gl {

const char* shader_version() {
    return "#version 300 es";
}

std::string_view shader_opening() {
    return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
}

void set_clear_depth(double depth) {
    glClearDepthf(static_cast<GLfloat>(depth));
}

void set_clip_depths_from_zero(bool from_zero) {
    set_webgl_clip_depths(from_zero ? 1 : 0);
}

void copy_pixel_pack_buffer(std::span<std::uint8_t> bytes) {
    copy_webgl_pack_buffer(bytes.data(), static_cast<int>(bytes.size()));
}

std::string driver_name() {
    char name[100] = "";
    tell_webgl_renderer(name, sizeof name);
    return std::string("WebGL 2 · ") + name;
}

bool has_clip_control() {
    static const bool has = has_webgl_extension("EXT_clip_control") != 0;
    return has;
}

// Only some browsers have WEBGL_clip_cull_distance; clipping with discard draws the same pixels in all of them.
bool has_clip_distance() {
    return false;
}

bool can_read_depth_stencil() {
    return false;
}

// The page reports each error on the console, and glGetError() also returns it.
bool has_debug_output() {
    return false;
}

bool has_shared_stages() {
    return false;
}

}  // namespace viewing::gl
