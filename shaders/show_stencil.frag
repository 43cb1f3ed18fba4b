// The stencil buffer as a picture. The value arrives as red, gathered bit by bit (stencil cannot be sampled everywhere).
in vec2 position_texture;

uniform sampler2D value_texture;
uniform vec3 stencil_colors[4];  // sRGB: 0, 1, 2, 3; higher values repeat 1 … 3 darker

out vec4 color;

void main() {
    int value = int(texture(value_texture, position_texture).r * 255.0 + 0.5);
    int repeat = value > 0 ? (value - 1) / 3 : 0;
    int index = value > 0 ? 1 + (value - 1) % 3 : 0;
    color = vec4(stencil_colors[index] * pow(0.8, float(repeat)), 1.0);
}
