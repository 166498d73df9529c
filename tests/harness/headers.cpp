// Only to have its precompiled headers made.
