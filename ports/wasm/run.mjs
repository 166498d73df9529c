// run.mjs PROGRAM: runs a WebAssembly program under WASI and ends with its status, or with 123 if it traps. Called by
// ports/run.
import { readFileSync } from "node:fs";
import { WASI } from "node:wasi";

const wasi = new WASI({ version: "preview1", returnOnExit: true });
const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), {
  wasi_snapshot_preview1: wasi.wasiImport,
});
try {
  process.exitCode = wasi.start(instance);
} catch (trap) {
  console.log(`\n[port] fault: ${trap.message}`);
  process.exitCode = 123;
}
