// Emscripten's --pre-js.
//
// Only readers of other projects' formats may crash on damaged files; the program then reports that it
// can't read the file.
const end = (what) => {
  const said = process.argv.slice(2).join(' ');
  require('fs').writeSync(2, `flashbvh: ${said}: can't be read: its reader crashed (${what}); export the mesh again, or as STL or PLY\n`);
  process.exit(2);
};
Module.onAbort = () => end('aborted');
// Emscripten treats all three as terminals, but a pipe must show no progress.
Module.onRuntimeInitialized = () => {
  for (const fd of [0, 1, 2]) FS.streams[fd].tty = require('tty').isatty(fd);
};
process.on('uncaughtException', (error) => end(error.message));
