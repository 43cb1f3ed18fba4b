// The depth buffer as a picture: black near, white far; pixels that were never written are tinted.
in vec2 position_texture;

// The values of DepthMapping in geometry/projection.h.
#define MAPPING_REVERSED 1
#define MAPPING_LOGARITHMIC 2

uniform sampler2D depth_texture;
uniform int mapping;
uniform bool linear_scale;
uniform bool orthographic;
uniform vec2 near_far;
uniform vec2 shown_range;  // eye distances shown as black and white on the linear scale
uniform float cleared;
uniform vec3 unwritten_color;  // sRGB

out vec4 color;

float distance_of(float depth) {
    float n = near_far.x;
    float f = near_far.y;
    if (mapping == MAPPING_LOGARITHMIC) return n * pow(f / n, depth);
    float d = mapping == MAPPING_REVERSED ? 1.0 - depth : depth;
    if (orthographic) return n + d * (f - n);
    return n * f / (f - d * (f - n));
}

void main() {
    float depth = texture(depth_texture, position_texture).r;
    if (depth == cleared) {
        color = vec4(unwritten_color, 1.0);
        return;
    }
    float grey = mapping == MAPPING_REVERSED ? 1.0 - depth : depth;
    if (linear_scale) grey = (distance_of(depth) - shown_range.x) / (shown_range.y - shown_range.x);
    color = vec4(vec3(clamp(grey, 0.0, 1.0)), 1.0);
}
