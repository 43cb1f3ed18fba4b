// One value for every fragment: gathers stencil bits.
uniform vec4 value;
out vec4 color;

void main() { color = value; }
