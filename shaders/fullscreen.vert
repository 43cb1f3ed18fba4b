// One triangle over the whole target, without a vertex buffer.
out vec2 position_texture;

void main() {
    vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    position_texture = corner;
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
