// Emscripten's --pre-js.
//
// Only readers of other projects' formats may crash, of a damaged file; it is one that can't be
// read then.
const end = (what) => {
  const said = process.argv.slice(2).join(' ');
  require('fs').writeSync(2, `flashbvh: ${said}: can't be read: its reader crashed (${what}); export the mesh again, or as STL or PLY\n`);
  process.exit(2);
};
Module.onAbort = () => end('aborted');
// Emscripten takes all three for terminals: a pipe shows no progress.
Module.onRuntimeInitialized = () => {
  for (const fd of [0, 1, 2]) FS.streams[fd].tty = require('tty').isatty(fd);
};
process.on('uncaughtException', (error) => end(error.message));
