"""A browser without a window, driven by the DevTools protocol over a WebSocket; standard library only."""

import base64
import json
import os
import re
import shutil
import socket
import struct
import subprocess
import tempfile
import urllib.request


class Browser:
    """A Chromium of this machine."""

    def __init__(self, program):
        self.profile = tempfile.mkdtemp(prefix="polhode-browser-")
        self.process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--allow-file-access-from-files",
             "--remote-debugging-port=0", f"--user-data-dir={self.profile}", "about:blank"],
            stderr=subprocess.PIPE, text=True)
        for line in self.process.stderr:
            found = re.search(r"ws://([^/]+)/", line)
            if found:
                self.place = found.group(1)
                break
        else:
            raise RuntimeError("the browser does not start")

    def page(self):
        """A new page."""
        request = urllib.request.Request(f"http://{self.place}/json/new?about:blank", method="PUT")
        with urllib.request.urlopen(request, timeout=30) as answer:
            return Page(json.load(answer)["webSocketDebuggerUrl"])

    def close(self):
        self.process.terminate()
        self.process.wait(timeout=30)
        shutil.rmtree(self.profile, ignore_errors=True)


class Page:
    """A page, its messages gathered."""

    def __init__(self, url):
        host, port, path = re.match(r"ws://([^:/]+):(\d+)(/.*)", url).groups()
        self.socket = socket.create_connection((host, int(port)), timeout=60)
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f"GET {path} HTTP/1.1\r\nHost: {host}:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                             f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n").encode())
        self.left = b""
        while b"\r\n\r\n" not in self.left:
            self.left += self.socket.recv(4096)
        self.left = self.left.split(b"\r\n\r\n", 1)[1]
        self.count = 0
        self.messages = []
        self.loaded = False
        for domain in ["Page", "Runtime", "Log"]:
            self.call(f"{domain}.enable")

    def _bytes(self, size):
        while len(self.left) < size:
            more = self.socket.recv(1 << 16)
            if not more:
                raise RuntimeError("the browser has gone")
            self.left += more
        taken, self.left = self.left[:size], self.left[size:]
        return taken

    def _receive(self):
        whole = b""
        while True:
            first, second = self._bytes(2)
            size = second & 127
            if size == 126:
                size = struct.unpack(">H", self._bytes(2))[0]
            elif size == 127:
                size = struct.unpack(">Q", self._bytes(8))[0]
            whole += self._bytes(size)
            if first & 128:
                return json.loads(whole)

    def _send(self, text):
        data = text.encode()
        mask = os.urandom(4)
        size = len(data)
        head = bytes([129]) + (bytes([128 | size]) if size < 126 else
                               bytes([128 | 126]) + struct.pack(">H", size) if size < 1 << 16 else
                               bytes([128 | 127]) + struct.pack(">Q", size))
        self.socket.sendall(head + mask + bytes(byte ^ mask[n % 4] for n, byte in enumerate(data)))

    def _take(self, event):
        method, values = event.get("method"), event.get("params", {})
        if method == "Page.loadEventFired":
            self.loaded = True
        elif method == "Runtime.consoleAPICalled":
            self.messages.append(" ".join(str(one.get("value", one.get("description"))) for one in values["args"]))
        elif method == "Runtime.exceptionThrown":
            details = values["exceptionDetails"]
            self.messages.append(details.get("exception", {}).get("description", details["text"]))
        elif method == "Log.entryAdded":
            self.messages.append(values["entry"]["text"] + " " + values["entry"].get("url", ""))

    def call(self, method, **values):
        self.count += 1
        self._send(json.dumps({"id": self.count, "method": method, "params": values}))
        while True:
            answer = self._receive()
            if answer.get("id") == self.count:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self._take(answer)

    def open(self, url):
        self.loaded = False
        self.messages = []
        self.call("Page.navigate", url=url)
        while not self.loaded:
            self._take(self._receive())

    def run(self, script):
        """The value of an expression; one that is a promise is awaited."""
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise RuntimeError(details.get("exception", {}).get("description", details["text"]))
        return answer["result"].get("value")

    def look(self, width, height=900, dark=False, scripts=True):
        """How the page is shown from now on."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 600)
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.call("Emulation.setScriptExecutionDisabled", value=not scripts)

    def press(self, key):
        for kind in ["keyDown", "keyUp"]:
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=key)

    def move(self, x, y):
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)

    def picture(self, path, whole=False):
        answer = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=whole)
        with open(path, "wb") as file:
            file.write(base64.b64decode(answer["data"]))
