"""painted.py OUTPUT COMMAND...: stores the output of painted.cpp's firmware if it succeeds."""
import subprocess
import sys
from pathlib import Path

output, *command = sys.argv[1:]
Path(output).unlink(missing_ok=True)
done = subprocess.run(command, stdout=subprocess.PIPE, text=True)
print(done.stdout, end="")
if done.returncode:
    sys.exit(1)
Path(output).write_text(done.stdout)
