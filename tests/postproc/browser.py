"""A report's page in headless Chromium: what a script on it does to its elements, and what it looks like."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
SKIPPED = 77


def skip_without_chromium():
    if CHROMIUM is None:
        print("skipped: chromium is not installed; tools/install-deps --test")
        sys.exit(SKIPPED)


def browse(page, *arguments):
    """Loads a file with everything but local files out of reach; returns what Chromium prints."""
    return chromium(page, *arguments).stdout


def chromium(page, *arguments):
    with tempfile.TemporaryDirectory() as profile:
        command = [CHROMIUM, "--headless", "--no-sandbox", "--hide-scrollbars", "--disable-dev-shm-usage",
                   "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--host-resolver-rules=MAP * ~NOTFOUND",
                   f"--user-data-dir={profile}", "--virtual-time-budget=20000", *arguments,
                   pathlib.Path(page).resolve().as_uri()]
        return subprocess.run(command, check=True, capture_output=True, text=True, timeout=240)


def console(page):
    """What the page's scripts and the browser say on the page's console: warnings and errors, too."""
    said = chromium(page, "--enable-logging=stderr", "--dump-dom").stderr
    return [line for line in said.splitlines() if ":CONSOLE" in line]


def print_pdf(page, pdf):
    browse(page, "--no-pdf-header-footer", f"--print-to-pdf={pathlib.Path(pdf).resolve()}")


def dom(page, script="", width=1100):
    """The page's elements after its scripts, and one more, have run."""
    if not script:
        return browse(page, "--dump-dom")
    page = pathlib.Path(page)
    probe = page.with_name("probe.html")
    text = page.read_text().replace("</body>", f"<script>addEventListener('load', () => {{{script}}});</script></body>")
    try:
        probe.write_text(text)
        return browse(probe, "--dump-dom", f"--window-size={width},3000")
    finally:
        probe.unlink(missing_ok=True)


def screenshot(page, picture, width, height):
    browse(page, f"--screenshot={pathlib.Path(picture).resolve()}", f"--window-size={width},{height}")
