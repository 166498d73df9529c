// Exists only to build its precompiled headers.
