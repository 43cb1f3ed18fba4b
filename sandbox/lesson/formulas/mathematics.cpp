#include "lesson/formulas/mathematics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "geometry/plane.h"
#include "lesson/formulas/lua.h"
#include "state/compare_func.h"
#include "state/fields.h"
#include "text/numbers.h"

namespace viewing {
namespace {

constexpr int largest_dimension = 4;

/// A table of up to 4 × 4 numbers: a single number (0 × 0), a vector (n × 0) or a matrix (n × m).
struct Tensor {
    int rows = 0, columns = 0;
    std::array<double, 16> at{};

    bool is_number() const { return rows == 0; }
    bool is_vector() const { return rows > 0 && columns == 0; }
    bool is_matrix() const { return columns > 0; }
    int size() const { return rows == 0 ? 1 : columns == 0 ? rows : rows * columns; }
    double& entry(int row, int column) { return at[row * columns + column]; }
    double entry(int row, int column) const { return at[row * columns + column]; }
    double operator[](int i) const { return at[i]; }
    double& operator[](int i) { return at[i]; }
    bool has_shape_of(const Tensor& other) const { return rows == other.rows && columns == other.columns; }
};

Tensor vector_of(int size) {
    return {size, 0, {}};
}

Tensor square(int size) {
    return {size, size, {}};
}

Tensor identity_of(int size) {
    Tensor result = square(size);
    for (int i = 0; i < size; ++i) result.entry(i, i) = 1.0;
    return result;
}

Tensor tensor_of(const glm::dmat4& matrix) {
    Tensor result = square(4);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) result.entry(row, column) = matrix[column][row];
    return result;
}

glm::dvec4 dvec4_of(const Tensor& vector) {
    return {vector[0], vector[1], vector[2], vector[3]};
}

// ---- Lua's stack ---------------------------------------------------------------------------------------------------

/// Returns the index of a list's first entry: 0 in lists from the state, 1 in lists that Lua's braces make.
int first_index(lua_State* lua, int table) {
    lua_rawgeti(lua, table, 0);
    const bool begins_at_zero = !lua_isnil(lua, -1);
    lua_pop(lua, 1);
    return begins_at_zero ? 0 : 1;
}

int count_of(lua_State* lua, int table) {
    return static_cast<int>(lua_rawlen(lua, table)) + (first_index(lua, table) == 0 ? 1 : 0);
}

double number_on_top(lua_State* lua, int argument) {
    if (lua_type(lua, -1) != LUA_TNUMBER) luaL_argerror(lua, argument, "its entries must be numbers");
    return lua_tonumber(lua, -1);
}

int size_at(lua_State* lua, int argument, int table) {
    const int size = count_of(lua, table);
    if (size < 1 || size > largest_dimension) luaL_argerror(lua, argument, "must have one to four entries");
    return size;
}

Tensor tensor_at(lua_State* lua, int argument) {
    Tensor result;
    if (lua_type(lua, argument) == LUA_TNUMBER) {
        result.at[0] = lua_tonumber(lua, argument);
        return result;
    }
    luaL_checktype(lua, argument, LUA_TTABLE);
    result.rows = size_at(lua, argument, argument);
    const int first = first_index(lua, argument);
    for (int row = 0; row < result.rows; ++row) {
        lua_rawgeti(lua, argument, first + row);
        const int inner = lua_gettop(lua);
        const int columns = lua_type(lua, inner) == LUA_TTABLE ? size_at(lua, argument, inner) : 0;
        if (row > 0 && columns != result.columns) luaL_argerror(lua, argument, "its rows differ in length");
        result.columns = columns;
        if (columns == 0) result[row] = number_on_top(lua, argument);
        for (int column = 0; column < columns; ++column) {
            lua_rawgeti(lua, inner, first_index(lua, inner) + column);
            result.entry(row, column) = number_on_top(lua, argument);
            lua_pop(lua, 1);
        }
        lua_pop(lua, 1);
    }
    return result;
}

/// Returns a vector, with as many entries as `size` says unless it is 0.
Tensor vector_at(lua_State* lua, int argument, int size = 0) {
    const Tensor vector = tensor_at(lua, argument);
    if (!vector.is_vector() || (size > 0 && vector.rows != size))
        luaL_argerror(lua, argument,
                      size == 0 ? "must be a vector" : lua_pushfstring(lua, "must have %d entries", size));
    return vector;
}

Tensor matrix_at(lua_State* lua, int argument) {
    const Tensor matrix = tensor_at(lua, argument);
    if (!matrix.is_matrix()) luaL_argerror(lua, argument, "must be a matrix");
    return matrix;
}

Tensor square_at(lua_State* lua, int argument) {
    const Tensor matrix = matrix_at(lua, argument);
    if (matrix.rows != matrix.columns) luaL_argerror(lua, argument, "must have as many rows as columns");
    return matrix;
}

void push_row(lua_State* lua, const double* numbers, int count) {
    lua_createtable(lua, count, 1);
    for (int i = 0; i < count; ++i) {
        lua_pushnumber(lua, numbers[i]);
        lua_rawseti(lua, -2, i);
    }
}

int push(lua_State* lua, double number) {
    lua_pushnumber(lua, number);
    return 1;
}

int push(lua_State* lua, const Tensor& tensor) {
    if (tensor.is_number()) return push(lua, tensor[0]);
    if (tensor.is_vector()) {
        push_row(lua, tensor.at.data(), tensor.rows);
        return 1;
    }
    lua_createtable(lua, tensor.rows, 1);
    for (int row = 0; row < tensor.rows; ++row) {
        push_row(lua, &tensor.at[row * tensor.columns], tensor.columns);
        lua_rawseti(lua, -2, row);
    }
    return 1;
}

int push_truth(lua_State* lua, bool truth) {
    lua_pushboolean(lua, truth ? 1 : 0);
    return 1;
}

// ---- products ------------------------------------------------------------------------------------------------------

Tensor product(lua_State* lua, const Tensor& a, const Tensor& b) {
    if (a.columns != b.rows) luaL_error(lua, "%d columns cannot be multiplied by %d rows", a.columns, b.rows);
    Tensor result = b.is_vector() ? vector_of(a.rows) : Tensor{a.rows, b.columns, {}};
    const int columns = std::max(b.columns, 1);
    for (int row = 0; row < a.rows; ++row)
        for (int column = 0; column < columns; ++column)
            for (int k = 0; k < a.columns; ++k)
                result[row * columns + column] += a.entry(row, k) * b[k * columns + column];
    return result;
}

int times(lua_State* lua) {
    const Tensor matrix = matrix_at(lua, 1), vector = vector_at(lua, 2);
    return push(lua, product(lua, matrix, vector));
}

/// Transforms a point by a matrix: appends w = 1 and divides by the resulting w. A 3 × 3 matrix has no w.
int apply(lua_State* lua) {
    const Tensor matrix = matrix_at(lua, 1), point = vector_at(lua, 2, 3);
    if (matrix.rows == 3) return push(lua, product(lua, matrix, point));
    Tensor homogeneous = vector_of(4);
    for (int i = 0; i < 3; ++i) homogeneous[i] = point[i];
    homogeneous[3] = 1.0;
    const Tensor sent = product(lua, matrix, homogeneous);
    Tensor result = vector_of(3);
    for (int i = 0; i < 3; ++i) result[i] = sent[i] / sent[3];
    return push(lua, result);
}

int mul(lua_State* lua) {
    const int count = lua_gettop(lua);
    Tensor result = matrix_at(lua, 1);
    for (int i = 2; i <= count; ++i) {
        const Tensor factor = tensor_at(lua, i);
        if (factor.is_number() || result.is_vector())
            luaL_argerror(lua, i, "must be a matrix or a vector that follows a matrix");
        result = product(lua, result, factor);
    }
    return push(lua, result);
}

int transpose(lua_State* lua) {
    const Tensor matrix = matrix_at(lua, 1);
    Tensor result{matrix.columns, matrix.rows, {}};
    for (int row = 0; row < matrix.rows; ++row)
        for (int column = 0; column < matrix.columns; ++column) result.entry(column, row) = matrix.entry(row, column);
    return push(lua, result);
}

struct Eliminated {
    Tensor inverse;
    double determinant = 1.0;
};

/// Gaussian elimination with partial pivoting on [M | I], which also yields the determinant.
Eliminated eliminated(const Tensor& matrix) {
    const int size = matrix.rows;
    std::array<std::array<double, 2 * largest_dimension>, largest_dimension> rows{};
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) rows[row][column] = matrix.entry(row, column);
        rows[row][size + row] = 1.0;
    }
    Eliminated result{square(size), 1.0};
    for (int column = 0; column < size; ++column) {
        int pivot = column;
        for (int row = column + 1; row < size; ++row)
            if (std::abs(rows[row][column]) > std::abs(rows[pivot][column])) pivot = row;
        const double value = rows[pivot][column];
        if (value == 0.0) return {{}, 0.0};
        std::swap(rows[pivot], rows[column]);
        result.determinant *= pivot == column ? value : -value;
        for (double& entry : rows[column]) entry /= value;
        for (int row = 0; row < size; ++row) {
            const double factor = rows[row][column];
            if (row == column || factor == 0.0) continue;
            for (int k = 0; k < 2 * size; ++k) rows[row][k] -= factor * rows[column][k];
        }
    }
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) result.inverse.entry(row, column) = rows[row][size + column];
    return result;
}

int inverse(lua_State* lua) {
    const Eliminated result = eliminated(square_at(lua, 1));
    if (result.determinant == 0.0) return luaL_error(lua, "the matrix has no inverse");
    return push(lua, result.inverse);
}

int det(lua_State* lua) {
    return push(lua, eliminated(square_at(lua, 1)).determinant);
}

// ---- the lecture's matrices ----------------------------------------------------------------------------------------

int translation(lua_State* lua) {
    const Tensor by = vector_at(lua, 1, 3);
    Tensor result = identity_of(4);
    for (int i = 0; i < 3; ++i) result.entry(i, 3) = by[i];
    return push(lua, result);
}

template <int axis>
int rotation(lua_State* lua) {
    glm::dvec3 about(0.0);
    about[axis] = 1.0;
    return push(lua, tensor_of(glm::rotate(glm::dmat4(1.0), glm::radians(luaL_checknumber(lua, 1)), about)));
}

int rotation_of(lua_State* lua) {
    const Tensor matrix = square_at(lua, 1);
    if (matrix.rows < 3) luaL_argerror(lua, 1, "must have three or four rows");
    Tensor result = square(3);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) result.entry(row, column) = matrix.entry(row, column);
    return push(lua, result);
}

int reflection_matrix(lua_State* lua) {
    return push(lua, tensor_of(mirror_matrix(dvec4_of(vector_at(lua, 1, 4)))));
}

int shadow_matrix_of(lua_State* lua) {
    const Tensor plane = vector_at(lua, 1, 4), light = vector_at(lua, 2, 4);
    return push(lua, tensor_of(shadow_matrix(dvec4_of(plane), dvec4_of(light))));
}

// ---- vectors -------------------------------------------------------------------------------------------------------

double length_of(const Tensor& tensor, int entries) {
    double sum = 0.0;
    for (int i = 0; i < entries; ++i) sum += tensor[i] * tensor[i];
    return std::sqrt(sum);
}

/// Divides a plane by the length of its normal, and any other vector by its own length.
int unit(lua_State* lua) {
    Tensor vector = vector_at(lua, 1);
    const double length = length_of(vector, std::min(vector.rows, 3));
    if (length == 0.0) return luaL_error(lua, "a vector of length 0 has no unit vector");
    for (int i = 0; i < vector.rows; ++i) vector[i] /= length;
    return push(lua, vector);
}

int norm(lua_State* lua) {
    const Tensor vector = tensor_at(lua, 1);
    return push(lua, length_of(vector, vector.size()));
}

/// Returns the two arguments, which must have the same shape.
std::pair<Tensor, Tensor> alike(lua_State* lua) {
    const Tensor a = tensor_at(lua, 1), b = tensor_at(lua, 2);
    if (!a.has_shape_of(b)) luaL_error(lua, "both must have the same number of entries");
    return {a, b};
}

int dot(lua_State* lua) {
    const auto [a, b] = alike(lua);
    double sum = 0.0;
    for (int i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return push(lua, sum);
}

int cross(lua_State* lua) {
    const Tensor a = vector_at(lua, 1, 3), b = vector_at(lua, 2, 3);
    Tensor result = vector_of(3);
    for (int i = 0; i < 3; ++i) result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    return push(lua, result);
}

template <int sign>
int sum(lua_State* lua) {
    auto [a, b] = alike(lua);
    for (int i = 0; i < a.size(); ++i) a[i] += sign * b[i];
    return push(lua, a);
}

int scale(lua_State* lua) {
    const double factor = luaL_checknumber(lua, 1);
    Tensor tensor = tensor_at(lua, 2);
    for (int i = 0; i < tensor.size(); ++i) tensor[i] *= factor;
    return push(lua, tensor);
}

// ---- comparisons ---------------------------------------------------------------------------------------------------

bool are_close(const Tensor& a, const Tensor& b, double tolerance) {
    if (!a.has_shape_of(b)) return false;
    for (int i = 0; i < a.size(); ++i)
        if (!(std::abs(a[i] - b[i]) <= tolerance)) return false;  // NaN is not close to anything
    return true;
}

int close(lua_State* lua) {
    const Tensor a = tensor_at(lua, 1), b = tensor_at(lua, 2);
    return push_truth(lua, are_close(a, b, luaL_checknumber(lua, 3)));
}

/// Compares two tensors up to a factor: finds the position of the first tensor's largest entry, and divides each tensor
/// by its own entry at that position, which becomes 1 in both.
int same_map(lua_State* lua) {
    Tensor a = tensor_at(lua, 1), b = tensor_at(lua, 2);
    const double tolerance = luaL_checknumber(lua, 3);
    if (!a.has_shape_of(b)) return push_truth(lua, false);
    int largest = 0;
    for (int i = 0; i < a.size(); ++i)
        if (std::abs(a[i]) > std::abs(a[largest])) largest = i;
    const double unit_a = a[largest], unit_b = b[largest];
    if (unit_a == 0.0 || unit_b == 0.0) return push_truth(lua, are_close(a, b, tolerance));
    for (int i = 0; i < a.size(); ++i) {
        a[i] /= unit_a;
        b[i] /= unit_b;
    }
    return push_truth(lua, are_close(a, b, tolerance));
}

// ---- numbers -------------------------------------------------------------------------------------------------------

template <double (*of)(double)>
int number_function(lua_State* lua) {
    return push(lua, of(luaL_checknumber(lua, 1)));
}

template <bool wants_largest>
int extreme(lua_State* lua) {
    double result = luaL_checknumber(lua, 1);
    for (int i = 2, count = lua_gettop(lua); i <= count; ++i) {
        const double number = luaL_checknumber(lua, i);
        result = wants_largest ? std::max(result, number) : std::min(result, number);
    }
    return push(lua, result);
}

int count(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    lua_pushinteger(lua, count_of(lua, 1));
    return 1;
}

// ---- lists ---------------------------------------------------------------------------------------------------------

/// Pushes a list with the value of `of()` for each entry of the list that is Lua's first argument, while the entry is
/// on top of the stack.
template <typename Of>
int push_list(lua_State* lua, const Of& of) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    lua_createtable(lua, 0, 0);
    const int result = lua_gettop(lua), first = first_index(lua, 1), size = count_of(lua, 1);
    for (int i = 0; i < size; ++i) {
        lua_rawgeti(lua, 1, first + i);
        lua_pushnumber(lua, of());
        lua_rawseti(lua, result, i);
        lua_settop(lua, result);
    }
    return 1;
}

/// Returns the stored code of the fragment on top of the stack.
double code_of(lua_State* lua) {
    if (lua_type(lua, -1) != LUA_TTABLE || lua_getfield(lua, -1, "stored") != LUA_TNUMBER)
        luaL_argerror(lua, 1, "must be the fragments of a pixel");
    return lua_tonumber(lua, -1);
}

int codes(lua_State* lua) {
    return push_list(lua, [&] { return code_of(lua); });
}

int trace(lua_State* lua) {
    const std::span<const char* const> names = names_of<CompareFunc>();
    const std::string wanted = luaL_checkstring(lua, 2);
    const auto at = std::find(names.begin(), names.end(), wanted);
    if (at == names.end()) luaL_argerror(lua, 2, "must be the name of a depth function, such as less");
    const auto func = static_cast<CompareFunc>(at - names.begin());
    double stored = luaL_optnumber(lua, 3, 255.0);
    return push_list(lua, [&] {
        const double code = code_of(lua);
        return compare(func, code, stored) ? stored = code : stored;
    });
}

int reversed(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    lua_createtable(lua, 0, 0);
    for (int i = 0, size = count_of(lua, 1), last = first_index(lua, 1) + size - 1; i < size; ++i) {
        lua_rawgeti(lua, 1, last - i);
        lua_rawseti(lua, -2, i);
    }
    return 1;
}

int places(lua_State* lua) {
    return push_list(lua, [&] { return number_on_top(lua, 1) - 1.0; });
}

int text_of_number(lua_State* lua) {
    if (lua_type(lua, 1) == LUA_TSTRING) {
        lua_pushvalue(lua, 1);
        return 1;
    }
    lua_pushstring(lua, shortest_number(luaL_checknumber(lua, 1)).c_str());
    return 1;
}

struct Function {
    MathematicsName name;
    lua_CFunction call;
};

constexpr Function functions[] = {
    {{"apply", "apply(M, p)", "point p transformed by M: w = 1 appended, divided by w"}, apply},
    {{"times", "times(M, v)", "M v, not divided by w"}, times},
    {{"mul", "mul(A, B, …)", "the product of matrices; the last factor may be a vector"}, mul},
    {{"transpose", "transpose(M)", "rows become columns"}, transpose},
    {{"inverse", "inverse(M)", "of a square matrix; an error if there is none"}, inverse},
    {{"det", "det(M)", "determinant"}, det},
    {{"translation", "translation(v)", "4 by 4"}, translation},
    {{"rotation_x", "rotation_x(degrees)", "4 by 4"}, rotation<0>},
    {{"rotation_y", "rotation_y(degrees)", "4 by 4"}, rotation<1>},
    {{"rotation_z", "rotation_z(degrees)", "4 by 4"}, rotation<2>},
    {{"rotation_of", "rotation_of(M)", "its upper left 3 by 3 part"}, rotation_of},
    {{"reflection_matrix", "reflection_matrix(plane)", "R of (a, b, c, d), whose normal must have length 1"},
     reflection_matrix},
    {{"shadow_matrix", "shadow_matrix(plane, light)", "S = (Π·L) I − L Πᵀ"}, shadow_matrix_of},
    {{"unit", "unit(v)", "v with length 1; a plane (a, b, c, d) with a unit normal"}, unit},
    {{"close", "close(a, b, tolerance)", "whether no entry differs by more; false if the shapes differ"}, close},
    {{"same_map", "same_map(A, B, tolerance)", "whether they are equal up to a factor"}, same_map},
    {{"norm", "norm(v)", "length"}, norm},
    {{"dot", "dot(a, b)", "a · b"}, dot},
    {{"cross", "cross(a, b)", "a × b"}, cross},
    {{"add", "add(a, b)", "a + b"}, sum<1>},
    {{"sub", "sub(a, b)", "a − b"}, sum<-1>},
    {{"scale", "scale(k, v)", "k v"}, scale},
    {{"abs", "abs(x)", "|x|"}, number_function<std::abs>},
    {{"min", "min(x, …)", "the smallest"}, extreme<false>},
    {{"max", "max(x, …)", "the largest"}, extreme<true>},
    {{"sqrt", "sqrt(x)", "√x"}, number_function<std::sqrt>},
    {{"sin", "sin(radians)", "sine"}, number_function<std::sin>},
    {{"cos", "cos(radians)", "cosine"}, number_function<std::cos>},
    {{"tan", "tan(radians)", "tangent"}, number_function<std::tan>},
    {{"atan", "atan(x)", "in radians"}, number_function<std::atan>},
    {{"radians", "radians(degrees)", "degrees times π ÷ 180"}, number_function<glm::radians>},
    {{"degrees", "degrees(radians)", "radians times 180 ÷ π"}, number_function<glm::degrees>},
    {{"round", "round(x)", "to a whole number, halves away from 0"}, number_function<std::round>},
    {{"text", "text(x)", "a number as a string: text(8) is '8'"}, text_of_number},
    {{"reversed", "reversed(list)", "the last entry first"}, reversed},
    {{"places", "places(list)", "every entry minus 1: places counted from 0"}, places},
    {{"codes", "codes(fragments)", "the codes of a pixel's fragments, in drawing order"}, codes},
    {{"trace", "trace(fragments, func)",
      "the stored depth after each fragment, if first cleared to 255 or to a third argument"},
     trace},
    {{"count", "count(list)", "the number of entries"}, count},
};

constexpr MathematicsName constants[] = {
    {"identity", "identity", "the 4 by 4 identity matrix"},
    {"pi", "pi", "3.14159…"},
};

std::vector<MathematicsName> all_mathematics_names() {
    std::vector<MathematicsName> names;
    for (const Function& function : functions) names.push_back(function.name);
    names.insert(names.end(), std::begin(constants), std::end(constants));
    return names;
}

}  // namespace

std::span<const MathematicsName> mathematics_names() {
    static const std::vector<MathematicsName> names = all_mathematics_names();
    return names;
}

void add_mathematics(lua_State* lua) {
    for (const Function& function : functions) {
        lua_pushcfunction(lua, function.call);
        lua_setfield(lua, -2, function.name.name.data());
    }
    push(lua, identity_of(4));
    lua_setfield(lua, -2, "identity");
    lua_pushnumber(lua, std::acos(-1.0));
    lua_setfield(lua, -2, "pi");
}

}  // namespace viewing
