#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives the page of js/page in Chromium as a reader does, for answering_page.py."""
import base64
import contextlib
import functools
import http.server
import json
import subprocess
import threading

# Waits until the page has answered the question that it shows.
SETTLED = """(async () => {
  const settled = () => document.querySelector('#answers')?.getAttribute('aria-busy') === 'false';
  for (let waited = 0; waited < 1000 && !settled(); ++waited) await new Promise(resolve => setTimeout(resolve, 20));
})()"""
TRUTH = "[...document.querySelectorAll('[data-part=truth] .exact code')].at(-1)?.textContent"


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@contextlib.contextmanager
def served(folder):
    handler = functools.partial(Quiet, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()


class Reader:
    """A reader, who uses the page and sees what it shows."""

    def __init__(self, browser, address, program):
        self.browser, self.address, self.program = browser, address, program

    def run(self, expression):
        said = self.browser.ask("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in said, said["exceptionDetails"]
        return said["result"].get("value")

    def load(self, page):
        # A fragment alone loads nothing, so another page comes between.
        for address in ("about:blank", self.address + page):
            self.browser.ask("Page.navigate", url=address)
            while self.browser.next().get("method") != "Page.loadEventFired":
                pass

    def open(self, fragment=""):
        self.load(fragment)
        self.settle()

    def follow(self, fragment):
        """Follows a link within the page."""
        self.run(f"""new Promise(resolve => {{
          addEventListener('hashchange', () => setTimeout(resolve), {{once: true}});
          location.hash = {json.dumps(fragment)};
        }})""")
        self.settle()

    def settle(self):
        self.run(SETTLED)

    def ask(self, operation, text):
        fields = "".join(f"%{byte:02x}" for byte in text.encode())
        self.open(f"#op={operation}&q={fields}")

    def click(self, selector):
        self.run(f"document.querySelector({json.dumps(selector)}).click()")
        self.settle()

    def until(self, expression):
        """The first value of an expression that holds, within ten seconds."""
        return self.run(f"""(async () => {{
          for (let waited = 0; waited < 500; ++waited) {{
            const value = {expression};
            if (value) return value;
            await new Promise(resolve => setTimeout(resolve, 20));
          }}
        }})()""")

    def text(self, selector="#text"):
        return self.run(f"(one => one.value ?? one.textContent)(document.querySelector({json.dumps(selector)}))")

    def paste(self, text):
        self.run(f"""(() => {{
          const box = document.querySelector('#text');
          box.value = {json.dumps(text)};
          box.dispatchEvent(new Event('change', {{bubbles: true}}));
        }})()""")
        self.settle()

    def type(self, selector, text):
        self.run(f"""(() => {{
          const box = document.querySelector({json.dumps(selector)});
          box.value = {json.dumps(text)};
          box.dispatchEvent(new Event('input', {{bubbles: true}}));
        }})()""")

    def press(self, key, code):
        for kind in ("keyDown", "keyUp"):
            self.browser.ask("Input.dispatchKeyEvent", type=kind, key=key, windowsVirtualKeyCode=code)
        self.settle()

    def drag(self, handle, right, down):
        box = f"document.querySelector('[data-handle=\"{handle}\"] .mark').getBoundingClientRect().toJSON()"
        self.run(f"document.querySelector('#picture').scrollIntoView({{block: 'center'}})")
        at = self.run(box)
        x, y = at["x"] + at["width"] / 2, at["y"] + at["height"] / 2
        mouse = functools.partial(self.browser.ask, "Input.dispatchMouseEvent", button="left")
        mouse(type="mousePressed", x=x, y=y, clickCount=1)
        for i in range(1, 9):
            mouse(type="mouseMoved", x=x + right * i / 8, y=y + down * i / 8, buttons=1)
        mouse(type="mouseReleased", x=x + right, y=y + down, clickCount=1)
        self.settle()

    def picture(self):
        return base64.b64decode(self.browser.ask("Page.captureScreenshot", captureBeyondViewport=True)["data"])

    def dark(self, is_dark):
        scheme = {"name": "prefers-color-scheme", "value": "dark" if is_dark else "light"}
        self.browser.ask("Emulation.setEmulatedMedia", features=[scheme])

    def told(self, *arguments, text=""):
        done = subprocess.run([self.program, *arguments], input=text, stdout=subprocess.PIPE, text=True, check=False)
        return done.stdout

    def answered(self, operation, question=None):
        """Holds what the page shows against what the program says of the question in its text."""
        shown = self.text()
        if question is not None:
            assert json.loads(shown) == json.loads(question), (shown, question)
        name = self.run("document.querySelector('#operation').textContent")
        assert name == operation.replace("_", " "), name
        wanted = json.loads(self.told("ask", operation, text=shown))
        said = self.run(TRUTH)
        assert said and json.loads(said) == wanted["truth"], (shown, said, wanted)
        return wanted
