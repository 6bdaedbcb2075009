#pragma once

#include "cga/algebra/multivector.hpp"

namespace cga {

// product = a b, bit for bit as multiply<Product::GEOMETRIC>(). Defined on x86-64 only; requires processor_features().avx2.
// All three arrays are in the coefficient order of Multivector; `product` must not alias `a` or `b`.
void geometric_product_avx2(const double *a, const double *b, double *product) noexcept;

} // namespace cga
