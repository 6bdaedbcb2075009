#pragma once

#include "cga/algebra/multivector.hpp"

namespace cga {

// product = a b, the same bits as multiply<Product::GEOMETRIC>(). Defined on x86-64 only, to be called where
// processor_features().avx2 is true. All three in the order of a Multivector's coefficients; `product` is neither factor.
void geometric_product_avx2(const double *a, const double *b, double *product) noexcept;

} // namespace cga
