# SPDX-License-Identifier: Apache-2.0
"""run_examples.py EXAMPLES OUT: runs every example, and the code of every notebook, in the folder OUT. Each must draw."""

import json
import pathlib
import subprocess
import sys


def code_of(notebook):
    cells = json.loads(notebook.read_text())["cells"]
    return "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")


def run(name, command, out):
    folder = out / name
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.png"):
        old.unlink()
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    print(f"--- {name}\n{done.stdout}{done.stderr}")
    pictures = [path for path in folder.glob("*.png") if path.stat().st_size > 5000]
    return done.returncode == 0 and done.stdout and pictures


def main():
    examples, out = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    scripts = {path.stem: [sys.executable, "-B", str(path)] for path in sorted(examples.glob("*.py"))}
    for path in sorted(examples.glob("*.ipynb")):
        code = code_of(path) + "\nimport matplotlib.pyplot as plt\nplt.savefig('notebook.png')\n"
        scripts[path.stem + "_notebook"] = [sys.executable, "-B", "-c", code]
    failed = [name for name, command in scripts.items() if not run(name, command, out)]
    if failed or len(scripts) < 3:
        sys.exit(f"failed: {failed}")


if __name__ == "__main__":
    main()
