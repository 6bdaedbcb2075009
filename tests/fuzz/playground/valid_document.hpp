#pragma once

#include "../input.hpp"

#include "playground/document/describe_entry.hpp"
#include "playground/document/document.hpp"

namespace fuzz {

/// Requires that each entry has a finite value or an error, and a description.
inline void require_valid(const playground::Document &document, const std::string &text) {
	for (size_t index = 0; index < document.size(); ++index) {
		const playground::Entry &entry = document.at(index);
		require(entry.value || !entry.value.error().message.empty(), "neither a value nor an error", text);
		require(!entry.value || entry.value->is_finite(), "a value is not finite", text);
		require(!playground::describe(entry).empty(), "no description", text);
	}
}

} // namespace fuzz
