// Plays the engine's part for a library of the addon, where there is no engine: loads the file in the first argument, calls its
// entry point, and lets it register its classes. Prints "class NAME" for each and "functions N", the number of interface
// functions that the library asked for.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#if defined(_WIN32)
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace {

using Function = void (*)();
using FindFunction = Function (*)(const char *name);

// GDExtensionInitialization of gdextension_interface.h.
struct Initialization {
	int minimum_level;
	void *user_data;
	void (*initialize)(void *user_data, int level);
	void (*deinitialize)(void *user_data, int level);
};
using Entry = uint8_t (*)(FindFunction find_function, void *library, Initialization *initialization);

// The levels of gdextension_interface.h: core, servers, scene and editor.
constexpr int SCENE_LEVEL = 2;
constexpr int EDITOR_LEVEL = 3;

int classes = 0;
int help_pages = 0;

// An interface function that does nothing, whatever its parameters; its result is null, false or zero.
void *do_nothing() {
	return nullptr;
}

// For objects and methods of the engine, which may not be null.
void *find_something() {
	static char something[64];
	return something;
}

void *allocate(size_t size) {
	return std::calloc(1, size);
}

void *allocate_padded(size_t size, uint8_t) {
	return std::calloc(1, size);
}

void release(void *memory) {
	std::free(memory);
}

void release_padded(void *memory, uint8_t) {
	std::free(memory);
}

// A name is a pointer to its text; equal texts need no equal pointers here.
void make_name(void *name, const char *text, uint8_t) {
	*static_cast<const char **>(name) = text;
}

void copy_value(void *value, const void *const *arguments) {
	std::memcpy(value, arguments[0], sizeof(void *));
}

Function find_constructor(int, int32_t constructor) {
	return constructor == 1 ? reinterpret_cast<Function>(copy_value) : reinterpret_cast<Function>(do_nothing);
}

Function find_any() {
	return reinterpret_cast<Function>(do_nothing);
}

void register_class(void *, const void *name, const void *, const void *) {
	std::printf("class %s\n", *static_cast<const char *const *>(name));
	++classes;
}

void load_help(const char *xml) {
	help_pages += std::strstr(xml, "<class ") != nullptr;
}

std::map<std::string, Function> asked_for;

Function find_function(const char *name) {
	static const std::map<std::string, Function> FUNCTIONS = {
		{ "mem_alloc", reinterpret_cast<Function>(allocate) },
		{ "mem_alloc2", reinterpret_cast<Function>(allocate_padded) },
		{ "mem_free", reinterpret_cast<Function>(release) },
		{ "mem_free2", reinterpret_cast<Function>(release_padded) },
		{ "classdb_get_method_bind", reinterpret_cast<Function>(find_something) },
		{ "global_get_singleton", reinterpret_cast<Function>(find_something) },
		{ "object_get_instance_binding", reinterpret_cast<Function>(find_something) },
		{ "string_name_new_with_latin1_chars", reinterpret_cast<Function>(make_name) },
		{ "string_name_new_with_utf8_chars", reinterpret_cast<Function>(make_name) },
		{ "variant_get_ptr_constructor", reinterpret_cast<Function>(find_constructor) },
		{ "classdb_register_extension_class4", reinterpret_cast<Function>(register_class) },
		{ "classdb_register_extension_class5", reinterpret_cast<Function>(register_class) },
		{ "editor_help_load_xml_from_utf8_chars", reinterpret_cast<Function>(load_help) },
	};
	const auto found = FUNCTIONS.find(name);
	if (found != FUNCTIONS.end()) {
		return asked_for[name] = found->second;
	}
	const bool finds_function = std::strncmp(name, "variant_get_ptr_", 16) == 0 || std::strncmp(name, "get_variant_", 12) == 0;
	return asked_for[name] = reinterpret_cast<Function>(finds_function ? find_any : reinterpret_cast<Function (*)()>(do_nothing));
}

Function find_nothing(const char *) {
	return nullptr;
}

#if defined(_WIN32)

void *open_library(const char *path) {
	return reinterpret_cast<void *>(LoadLibraryA(path));
}

Entry find_entry(void *library) {
	return reinterpret_cast<Entry>(GetProcAddress(static_cast<HMODULE>(library), "ga_godot_init"));
}

bool close_library(void *library) {
	return FreeLibrary(static_cast<HMODULE>(library)) != 0;
}

std::string last_error() {
	return "error " + std::to_string(GetLastError());
}

#else

void *open_library(const char *path) {
	return dlopen(path, RTLD_NOW | RTLD_LOCAL);
}

Entry find_entry(void *library) {
	return reinterpret_cast<Entry>(dlsym(library, "ga_godot_init"));
}

bool close_library(void *library) {
	return dlclose(library) == 0;
}

std::string last_error() {
	const char *text = dlerror();
	return text != nullptr ? text : "unknown error";
}

#endif

int fail(const std::string &message) {
	std::fprintf(stderr, "library_host: %s\n", message.c_str());
	return 1;
}

} // namespace

int main(int count, char **arguments) {
	if (count != 2) {
		return fail("usage: library_host LIBRARY");
	}
	void *library = open_library(arguments[1]);
	if (library == nullptr) {
		return fail(std::string(arguments[1]) + " cannot be loaded: " + last_error());
	}
	const Entry entry = find_entry(library);
	if (entry == nullptr) {
		return fail("no symbol ga_godot_init: " + last_error());
	}
	Initialization initialization = {};
	if (entry(find_nothing, library, &initialization)) {
		return fail("the library accepts an engine without any function");
	}
	if (!entry(find_function, library, &initialization)) {
		return fail("the library rejects the engine");
	}
	for (int level = 0; level <= EDITOR_LEVEL; ++level) {
		if (level >= initialization.minimum_level) {
			initialization.initialize(initialization.user_data, level);
		}
	}
	for (int level = EDITOR_LEVEL; level >= initialization.minimum_level; --level) {
		initialization.deinitialize(initialization.user_data, level);
	}
	std::printf("minimum level %d\nfunctions %d\nhelp pages %d\n", initialization.minimum_level, int(asked_for.size()), help_pages);
	if (initialization.minimum_level != SCENE_LEVEL || classes == 0 || help_pages != classes) {
		return fail("the library does not register its classes at the level of scenes, each with a page of help");
	}
	return close_library(library) ? 0 : fail("the library cannot be unloaded: " + last_error());
}
