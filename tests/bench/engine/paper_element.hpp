#pragma once

#include "cga/algebra/product_table.hpp"

#include <cstddef>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

// The multivectors of the GA-Unity paper: 32 floats on the heap, and the allocation of results.

namespace bench::paper {

struct Element {
	float coefficients[cga::BLADE_COUNT] = {};

	float operator[](size_t index) const { return coefficients[index]; }
	float &operator[](size_t index) { return coefficients[index]; }
};

/// The paper's baseline: allocates a multivector for every operation.
class Allocating {
public:
	Element *take() { return new Element; }
	void give_back(Element *element) { delete element; }
};

/// The paper's method: a pool of multivectors, which are zeroed when they are returned.
class Pool {
public:
	Element *take();
	void give_back(Element *element);
	[[nodiscard]] size_t taken() const { return _taken; }

private:
	std::vector<std::unique_ptr<Element>> _elements;
	std::deque<Element *> _free;
	size_t _taken = 0;
};

/// An element taken from a store and returned at the end of its scope.
template <class Store>
class Held {
public:
	explicit Held(Store &store) :
			_store(store), _element(store.take()) {}
	~Held() { _store.give_back(_element); }
	Held(const Held &) = delete;
	Held &operator=(const Held &) = delete;

	Element &operator*() const { return *_element; }
	Element *operator->() const { return _element; }

private:
	Store &_store;
	Element *_element;
};

/// result = left right, each of the 1,024 terms (fewer for other products) written out, as in the paper's generated code.
void geometric_product(const Element &left, const Element &right, Element &result);
/// The fat dot, 454 terms.
void inner_product(const Element &left, const Element &right, Element &result);
/// The signs of grades 0..5: + - - + + -.
void conjugate(const Element &element, Element &result);
void scale(const Element &element, float factor, Element &result);

/// The number of terms of a product.
[[nodiscard]] int term_count(cga::Product product);

} // namespace bench::paper
