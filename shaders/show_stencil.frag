// Shows the stencil buffer. Its value is in the red channel, gathered bit by bit, since not every driver can sample
// stencil. Some of its bits identify the patch, the others the lights that are missing there.
in vec2 position_texture;

uniform sampler2D value_texture;
// sRGB, in this order: nothing, a patch, a light missing on a patch, a light missing outside the patches
uniform vec3 colors[STENCIL_COLORS];

out vec4 color;

void main() {
    int value = int(texture(value_texture, position_texture).r * 255.0 + 0.5);
    int region = value & STENCIL_REGION_BITS, missing = value & STENCIL_LIGHT_BITS;
    int count = 0;
    for (int bits = missing; bits > 0; bits >>= 1) count += bits & 1;
    vec3 marked = missing == 0 ? colors[region == 0 ? 0 : 1] : colors[region == 0 ? 3 : 2];
    // Each further patch and each further missing light is a little darker.
    color = vec4(marked * pow(0.82, float(max(region - 1, 0)) + 1.5 * float(max(count - 1, 0))), 1.0);
}
