// The stencil buffer as a picture. The value arrives as red, gathered bit by bit (stencil cannot be sampled everywhere).
// Its low four bits tell which patch, the high four which lights are missing there.
in vec2 position_texture;

uniform sampler2D value_texture;
uniform vec3 stencil_colors[4];  // sRGB: nothing, a patch, a light missing on it; the last one for missing beside a patch

out vec4 color;

void main() {
    int value = int(texture(value_texture, position_texture).r * 255.0 + 0.5);
    int region = value & 15, missing = value >> 4;
    int count = (missing & 1) + ((missing >> 1) & 1) + ((missing >> 2) & 1) + (missing >> 3);
    vec3 marked = missing == 0 ? stencil_colors[region == 0 ? 0 : 1] : stencil_colors[region == 0 ? 3 : 2];
    // The next patch and the next light are a little darker.
    color = vec4(marked * pow(0.82, float(max(region - 1, 0)) + 1.5 * float(max(count - 1, 0))), 1.0);
}
