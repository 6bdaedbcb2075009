/* An extension between the engine and GA-Godot that hides what an older engine lacks.
 *
 * OLDER_ENGINE_LIBRARY is the path of GA-Godot's library. OLDER_ENGINE_LACKS are the names of interface functions, and
 * CLASS.METHOD of methods, separated by spaces. Prints "[lacks] NAME" when the library asks for one of them. */

#include <gdextension_interface.h>

#include <dlfcn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_HIDDEN 4096

typedef void *Name; /* A StringName: equal names have equal pointers. */

static char *hidden_names[MAX_HIDDEN];
static Name hidden_methods[MAX_HIDDEN];
static int hidden_count = 0;
static Name object_class, has_method;
static GDExtensionMethodBindPtr has_method_bind = NULL;

static GDExtensionInterfaceGetProcAddress get_proc_address;
static GDExtensionInterfaceStringNameNewWithLatin1Chars make_name;
static GDExtensionInterfaceClassdbGetMethodBind get_method_bind;
static GDExtensionInterfaceObjectMethodBindPtrcall method_bind_ptrcall;

static Name name_of(const void *string_name) {
	return *(const Name *)string_name;
}

/* Whether a method of this name is hidden, in this class or, without a class, in any. */
static int hides_method(const Name *class_name, Name method) {
	for (int i = 0; i < hidden_count; i++) {
		const char *dot = strchr(hidden_names[i], '.');
		if (dot == NULL || hidden_methods[i] != method) {
			continue;
		}
		if (class_name != NULL) {
			char text[256];
			Name hidden_class;
			snprintf(text, sizeof(text), "%.*s", (int)(dot - hidden_names[i]), hidden_names[i]);
			make_name(&hidden_class, text, true);
			if (hidden_class != *class_name) {
				continue;
			}
		}
		fprintf(stderr, "[lacks] %s\n", hidden_names[i]);
		return 1;
	}
	return 0;
}

static GDExtensionMethodBindPtr find_method_bind(GDExtensionConstStringNamePtr class_name, GDExtensionConstStringNamePtr method, GDExtensionInt hash) {
	const Name owner = name_of(class_name);
	if (hides_method(&owner, name_of(method))) {
		return NULL;
	}
	const GDExtensionMethodBindPtr found = get_method_bind(class_name, method, hash);
	if (owner == object_class && name_of(method) == has_method) {
		has_method_bind = found;
	}
	return found;
}

static void call_method_bind(GDExtensionMethodBindPtr method, GDExtensionObjectPtr object, const GDExtensionConstTypePtr *arguments, GDExtensionTypePtr result) {
	if (method == has_method_bind && method != NULL && hides_method(NULL, name_of(arguments[0]))) {
		*(GDExtensionBool *)result = false;
		return;
	}
	method_bind_ptrcall(method, object, arguments, result);
}

static GDExtensionInterfaceFunctionPtr find_function(const char *name) {
	if (strcmp(name, "classdb_get_method_bind") == 0) {
		return (GDExtensionInterfaceFunctionPtr)find_method_bind;
	}
	if (strcmp(name, "object_method_bind_ptrcall") == 0) {
		return (GDExtensionInterfaceFunctionPtr)call_method_bind;
	}
	for (int i = 0; i < hidden_count; i++) {
		if (strcmp(hidden_names[i], name) == 0) {
			fprintf(stderr, "[lacks] %s\n", name);
			return NULL;
		}
	}
	return get_proc_address(name);
}

GDExtensionBool older_engine_init(GDExtensionInterfaceGetProcAddress engine, GDExtensionClassLibraryPtr token, GDExtensionInitialization *initialization) {
	const char *lacks = getenv("OLDER_ENGINE_LACKS");
	const char *path = getenv("OLDER_ENGINE_LIBRARY");
	if (lacks == NULL || path == NULL) {
		fprintf(stderr, "ERROR: OLDER_ENGINE_LACKS and OLDER_ENGINE_LIBRARY must be set.\n");
		return false;
	}
	get_proc_address = engine;
	make_name = (GDExtensionInterfaceStringNameNewWithLatin1Chars)engine("string_name_new_with_latin1_chars");
	get_method_bind = (GDExtensionInterfaceClassdbGetMethodBind)engine("classdb_get_method_bind");
	method_bind_ptrcall = (GDExtensionInterfaceObjectMethodBindPtrcall)engine("object_method_bind_ptrcall");
	make_name(&object_class, "Object", true);
	make_name(&has_method, "has_method", true);
	for (char *name = strtok(strdup(lacks), " "); name != NULL && hidden_count < MAX_HIDDEN; name = strtok(NULL, " ")) {
		const char *dot = strchr(name, '.');
		if (dot != NULL) {
			make_name(&hidden_methods[hidden_count], dot + 1, true);
		}
		hidden_names[hidden_count++] = name;
	}
	void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
	const GDExtensionInitializationFunction initialize = library ? (GDExtensionInitializationFunction)dlsym(library, "ga_godot_init") : NULL;
	if (initialize == NULL) {
		fprintf(stderr, "ERROR: %s\n", dlerror());
		return false;
	}
	return initialize(find_function, token, initialization);
}
