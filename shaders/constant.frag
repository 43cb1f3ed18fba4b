// Outputs one value for every fragment; used to gather stencil bits.
uniform vec4 value;
out vec4 color;

void main() { color = value; }
