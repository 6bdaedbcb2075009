// For libraries of zig on Linux, which link none of the start files that gcc adds: runs the destructors of static objects when
// the engine unloads the library, instead of at the end of the process, when its code is no longer there.

#ifdef WITHOUT_START_FILES

extern "C" {

int __cxa_finalize(void *library);
extern void *__dso_handle __attribute__((visibility("hidden")));

__attribute__((destructor)) static void destroy_static_objects() {
	__cxa_finalize(&__dso_handle);
}
}

#endif
