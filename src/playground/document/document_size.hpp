#pragma once

#include "playground/document/attributes.hpp"
#include "playground/expression/error.hpp"

#include <cstddef>
#include <string_view>

// The size of a document and its limits. Every change keeps to them, so that every document can be saved, opened and undone.

namespace playground {

inline constexpr size_t MAX_DOCUMENT_LENGTH = 16 << 20; // bytes of JSON
inline constexpr size_t MAX_ENTRIES = 65536;
inline constexpr size_t MAX_ATTRIBUTES = 4 * MAX_ENTRIES; // of all entries and of the document itself
inline constexpr size_t MAX_OPERATIONS = 4 << 20;

struct DocumentSize {
	size_t bytes = 0; // at least the length of the JSON text, at most 16 bytes per entry more
	size_t attributes = 0;
	size_t operations = 0; // to evaluate all entries, as Expression::operations() counts them

	DocumentSize &operator+=(const DocumentSize &other);
	// Precondition: `other` has been added.
	DocumentSize &operator-=(const DocumentSize &other);
};

// The bytes of a document without entries and attributes.
[[nodiscard]] DocumentSize size_of_empty_document();
// The bytes that an entry without attributes adds; its operations are those of the expression.
[[nodiscard]] DocumentSize size_of_entry(std::string_view name, std::string_view text, size_t operations);
// What attributes add.
[[nodiscard]] DocumentSize size_of_attributes(const Attributes &attributes);
// What one attribute adds.
[[nodiscard]] DocumentSize size_of_attribute(std::string_view key, const AttributeValue &value);

[[nodiscard]] Error too_many_entries();
// Whether a document may have this size.
cga::Result<void, Error> check_size(const DocumentSize &size);

} // namespace playground
