"""everywhere.py QUERIES PERIODS PROGRAM PACKAGE [PYTHON MODULE]: compares the hash of these counts by the program
one_hash, by the npm package in node and Chromium, and by the Python package; fails if they differ. Leaves missing
programs out; PACKAGE may be empty. Exits with 77 if there is nothing to compare with."""
import functools
import http.server
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

OWN = Path(__file__).resolve().parent
PAGE = """<!DOCTYPE html><script type="module">
import { hash_of } from "./answers.mjs";
const read = async name => (await fetch(name)).arrayBuffer();
const report = body => fetch("report", { method: "POST", body });
try { await report(await hash_of(await import("./library/index.js"), read)); } catch (error) { await report(error.stack); }
</script>"""
CHROMIUM = ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"]


def printed(*command, **environment):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True,
                          env={**os.environ, **environment}).stdout.strip()


class Server(http.server.SimpleHTTPRequestHandler):
    found = []

    def do_POST(self):
        self.found.append(self.rfile.read(int(self.headers["Content-Length"])).decode())
        self.send_response(204)
        self.end_headers()

    def log_message(self, *_):
        pass


def in_chromium(folder, package):
    (folder / "library").symlink_to(package)
    (folder / "answers.mjs").symlink_to(OWN / "answers.mjs")
    (folder / "page.html").write_text(PAGE)
    with http.server.ThreadingHTTPServer(("localhost", 0), functools.partial(Server, directory=folder)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        url = f"http://localhost:{server.server_port}/page.html"
        with open(folder / "browser.log", "w") as log, subprocess.Popen(
                [*CHROMIUM, f"--user-data-dir={folder}/profile", url], stdout=log, stderr=log) as browser:
            began = time.monotonic()
            while not Server.found and browser.poll() is None and time.monotonic() < began + 300:
                time.sleep(0.05)
            browser.terminate()
        server.shutdown()
    return Server.found[0] if Server.found else f"no answer: {(folder / 'browser.log').read_text()[-500:]}"


def hashes(folder, queries, periods, program, package, python="", module=""):
    yield "C++", lambda: printed(program, queries, periods, folder)
    for name, command, run in (("node", "node", lambda: printed("node", OWN / "answers.mjs", package, folder)),
                               ("Chromium", "chromium", lambda: in_chromium(folder, package))):
        if package and shutil.which(command):
            yield name, run
        else:
            print(f"{name} is left out: {f'no {command}' if package else 'no npm package, for which clang is needed'}")
    if module:
        yield "CPython", lambda: printed(python, "-B", OWN / "answers.py", folder, PYTHONPATH=module)
    else:
        print("CPython is left out: no Python package, which cmake --preset native builds")


def main(*arguments):
    with tempfile.TemporaryDirectory() as folder:
        found = []
        for name, run in hashes(Path(folder), *arguments):
            began = time.monotonic()
            answer = run()
            found.append(answer)
            print(f"{answer} {name}, {time.monotonic() - began:.1f} s", flush=True)
    if len(found) < 2:
        print("SKIPPED: C++ has nothing to compare with")
        return 77
    return 1 if len(set(found)) != 1 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
