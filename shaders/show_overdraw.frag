// Shows in colors how often each pixel was drawn. The red channel holds the count, one level per draw.
in vec2 position_texture;

uniform sampler2D value_texture;
uniform vec3 colors[OVERDRAW_COLORS];  // sRGB: for counts of 0, 1, 2 …; the last color also for higher counts

out vec4 color;

void main() {
    int count = int(texture(value_texture, position_texture).r * 255.0 + 0.5);
    color = vec4(colors[min(count, OVERDRAW_COLORS - 1)], 1.0);
}
