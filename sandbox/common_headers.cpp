// Contains no code: CMake compiles it to build the precompiled headers that all targets share.
