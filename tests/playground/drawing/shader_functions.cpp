#include "shader_functions.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace playground::drawing::shader_functions {

using glm::abs;
using glm::asin;
using glm::atan;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::exp2;
using glm::floor;
using glm::length;
using glm::log2;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::sin;
using glm::sqrt;

#include "playground/drawing/shaders/round_positions.gdshaderinc"
#include "playground/drawing/shaders/unbounded_positions.gdshaderinc"

} // namespace playground::drawing::shader_functions
