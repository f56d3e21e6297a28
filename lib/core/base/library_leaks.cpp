// Leaks of libraries, which would hide leaks of the project: OpenCASCADE keeps tables until the process ends, CoinUtils
// (2.11) forgets its bounds of columns where it finds that a program has no solution.
// The list of what was suppressed is not printed, because stderr is reserved for messages of the tools.

#ifdef QUADRILLE_SANITIZE
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libTK\nleak:libCoinUtils\n"; }
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif
