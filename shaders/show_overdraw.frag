// How often each pixel was drawn, as colours: the count arrives as red, one level for each time.
in vec2 position_texture;

uniform sampler2D value_texture;
uniform vec3 overdraw_colors[9];  // sRGB: 0, 1, 2, … 7, and 8 or more

out vec4 color;

void main() {
    int count = int(texture(value_texture, position_texture).r * 255.0 + 0.5);
    color = vec4(overdraw_colors[min(count, 8)], 1.0);
}
