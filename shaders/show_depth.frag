// Shows the depth buffer, from black (near) to white (far) or in bands of color. Pixels that were never written are
// tinted.
in vec2 position_texture;

uniform highp sampler2D depth_texture;
uniform int mapping;  // a DepthMapping
uniform bool linear_scale;
uniform bool orthographic;
uniform vec2 near_far;
uniform float shown_first;  // shown as black: an eye distance on the linear scale, otherwise a window depth
uniform float shown_slope;  // change of gray per unit
uniform bool shows_bands;
uniform vec3 bands[BANDS];  // sRGB, near first
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
    float value = linear_scale ? distance_of(depth) : depth;
    float grey = clamp((value - shown_first) * shown_slope, 0.0, 1.0);
    color = vec4(shows_bands ? bands[min(int(grey * float(BANDS)), BANDS - 1)] : vec3(grey), 1.0);
}
