// The matrices that `matrices` prints: all, or those chosen with --only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options.h"
#include "frame/derive.h"
#include "frame/matrix_symbols.h"

namespace viewing {

struct ChosenMatrix {
    std::string name;  ///< "shadow_from_world", or as chosen: "S", "S[2,1]"
    std::string key;   ///< in JSON: "shadow_from_world", "shadow_from_world[2,1]"
    glm::dmat4 matrix{1.0};
    std::optional<MatrixSymbols> symbols = {};  ///< empty for PV or a matrix entered by hand
    std::optional<double> sign = {};            ///< only for S: sign · S is uploaded
    std::string sign_name = {}, sign_key = {};  ///< "shadow_sign"
};

/// Returns the matrices in `only`, a list such as "V,S[2,1],R". The names are C, V, P, PV, S and R; S takes the indices
/// of a plane and a light, and R takes the index of a plane. Indices count from 1 and default to 1. Without `only`,
/// returns these six. Ends the command for an unknown name.
std::vector<ChosenMatrix> chosen_matrices(const Options& options, const std::optional<std::string>& only,
                                          const Params& params, const Derived& derived);

}  // namespace viewing
