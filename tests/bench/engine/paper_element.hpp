#pragma once

#include "cga/algebra/product_table.hpp"

#include <cstddef>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

// The multivectors of the GA-Unity paper, 32 floats on the heap each, and the two ways to allocate the result of an operation.

namespace bench::paper {

struct Element {
	float coefficients[cga::BLADE_COUNT] = {};

	float operator[](size_t index) const { return coefficients[index]; }
	float &operator[](size_t index) { return coefficients[index]; }
};

/// The paper's baseline: a new multivector for each operation.
class Allocating {
public:
	Element *acquire() { return new Element; }
	void release(Element *element) { delete element; }
};

/// The paper's pool: a queue of multivectors, which are zeroed when released.
class Pool {
public:
	Element *acquire();
	void release(Element *element);
	[[nodiscard]] size_t acquired() const { return _acquired; }

private:
	std::vector<std::unique_ptr<Element>> _elements;
	std::deque<Element *> _free;
	size_t _acquired = 0;
};

/// Acquires an element for the lifetime of this object.
template <class Store>
class Held {
public:
	explicit Held(Store &store) :
			_store(store), _element(store.acquire()) {}
	~Held() { _store.release(_element); }
	Held(const Held &) = delete;
	Held &operator=(const Held &) = delete;

	Element &operator*() const { return *_element; }
	Element *operator->() const { return _element; }

private:
	Store &_store;
	Element *_element;
};

/// result = left right with each of its 1,024 terms written out, like the generated code of the paper.
void geometric_product(const Element &left, const Element &right, Element &result);
/// The inner product called fat dot, with its 454 terms written out.
void inner_product(const Element &left, const Element &right, Element &result);
/// The Clifford conjugate. The signs of grades 0 to 5 are + - - + + -.
void conjugate(const Element &element, Element &result);
void scale(const Element &element, float factor, Element &result);

/// The number of terms of a product.
[[nodiscard]] int term_count(cga::Product product);

} // namespace bench::paper
