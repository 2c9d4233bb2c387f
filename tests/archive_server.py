"""A server of one file that cuts, stalls, redirects and refuses as a test says."""

import collections
import http.server
import re
import threading
import time


class Server(http.server.ThreadingHTTPServer):
    """Serves ``content`` at any path; ``plan`` holds what to do with the next requests.

    It waits for ``pause`` seconds after every 64 kB.
    """

    daemon_threads = True

    def __init__(self, content: bytes, pause: float = 0.0):
        super().__init__(("127.0.0.1", 0), Handler)
        self.content, self.pause, self.plan = content, pause, collections.deque()
        self.requests, self.ranges, self.tag = [], True, '"first"'
        self.stop = threading.Event()

    def handle_error(self, *_):
        """A client hangs up when it has what it needs."""

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.server_port}/data.zip"


class Handler(http.server.BaseHTTPRequestHandler):
    def do_GET(self):
        """One of: whole, shifted, cut N, stall N, chunked N, unannounced, STATUS, 302 ADDRESS.

        ``changed``: it has another file from now on.
        """
        server = self.server
        server.requests.append(dict(self.headers))
        deed, *value = (server.plan.popleft() if server.plan else "whole").split()
        self.protocol_version = "HTTP/1.1" if deed == "chunked" else "HTTP/1.0"
        self.close_connection = True
        if deed.isdigit():
            return self.refuse(int(deed), {"Location": value[0]} if value else {})
        if deed == "changed":
            server.content, server.tag = server.content[::-1], '"second"'
        data = server.content
        asked = re.fullmatch(r"bytes=(\d+)-", self.headers["Range"])
        start = int(asked[1]) if server.ranges and deed != "shifted" else 0
        if start >= len(data):
            return self.refuse(416, {"Content-Range": f"bytes */{len(data)}"})
        self.send_response(206 if server.ranges else 200)
        self.send_header("ETag", server.tag)
        if server.ranges:
            self.send_header("Content-Range", f"bytes {start}-{len(data) - 1}/{len(data)}")
        if deed == "chunked":
            self.send_header("Transfer-Encoding", "chunked")
        elif deed != "unannounced":
            self.send_header("Content-Length", str(len(data) - start))
        self.end_headers()
        piece = data[start : start + int(value[0]) if value else len(data)]
        if deed == "chunked":
            piece = b"%x\r\n%s\r\n" % (len(piece), piece)
        for at in range(0, len(piece), 1 << 16):
            self.wfile.write(piece[at : at + (1 << 16)])
            time.sleep(self.server.pause)
        if deed == "stall":
            self.wfile.flush()
            server.stop.wait(20)
        return None

    def refuse(self, status, headers):
        self.send_response(status)
        for name, value in headers.items():
            self.send_header(name, value)
        self.send_header("Content-Length", "2")
        self.end_headers()
        self.wfile.write(b"no")

    def log_message(self, *_):
        pass
