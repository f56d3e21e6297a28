// Empty: CMake needs a source beside the headers that it compiles ahead.
