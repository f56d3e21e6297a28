"""The server of the workbench: on 127.0.0.1 alone, under a random address, for its own page and no other.

    GET /TOKEN/          the page              POST /TOKEN/run      mesh of a state
    GET /TOKEN/alive     open as the page is   POST /TOKEN/save     a file in the folder of the shape

A request is refused unless it names this host (another name may be one that was made to mean this machine), comes from
this page or from none, and knows the token."""
import hmac
import http.server
import json
import select
import socketserver
import threading
import time

from bench.saved_files import ENDINGS

MOST_BYTES = 1 << 20  # of a request
BEAT = 2.0  # s between two bytes of "alive"
GRACE = 3.0  # s in which a page that is loaded again, or another one, may follow the last
HEADERS = {"Cache-Control": "no-store", "X-Content-Type-Options": "nosniff", "Referrer-Policy": "same-origin",
           "Cross-Origin-Resource-Policy": "same-origin", "Content-Security-Policy": "frame-ancestors 'none'"}
TEXT, HTML, JSON = "text/plain", "text/html", "application/json"


class Presence:
    """Which pages are open. Before the first one the server waits without end."""

    def __init__(self):
        self.lock, self.open, self.last = threading.Lock(), 0, None

    def change(self, by):
        """One page more or less; 0: a page was sent, which is about to open."""
        with self.lock:
            self.open += by
            if by or self.last is not None:
                self.last = time.monotonic()

    def is_over(self):
        with self.lock:
            return self.last is not None and not self.open and time.monotonic() - self.last > GRACE


class Refused(Exception):
    """A request is not answered but by this status."""

    def __init__(self, status):
        super().__init__(status)
        self.status = status


class PageServer(socketserver.ThreadingMixIn, http.server.HTTPServer):
    """`page`: HTML. `workbench`: its `run` and `save` answer requests."""

    daemon_threads = True
    block_on_close = False

    def __init__(self, port, token, page, workbench):
        self.token, self.page, self.workbench, self.presence = token, page, workbench, Presence()
        super().__init__(("127.0.0.1", port), Requests)
        self.hosts = [f"{name}:{self.server_address[1]}" for name in ("127.0.0.1", "localhost")]

    def server_bind(self):
        """Without the name of the host, which the base class would look up, maybe in the network."""
        socketserver.TCPServer.server_bind(self)
        self.server_name, self.server_port = self.server_address

    def handle_error(self, request, client_address):
        """Connections that break are no news."""

    @property
    def address(self):
        return f"http://{self.hosts[0]}/{self.token}/"


class Requests(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server_version, sys_version = "quadbench", ""
    timeout = 60  # s for a request to arrive

    def log_message(self, *_):
        """Nothing is printed: addresses hold the token."""

    def do_GET(self):
        self.answer({"": self.send_page, "alive": self.stay_open})

    def do_POST(self):
        self.answer({"run": self.run, "save": self.save})

    def answer(self, actions):
        try:
            self.require_own_page()
            action = actions.get(self.name())
            if action is None:
                raise Refused(404)
            action()
        except Refused as refused:
            self.close_connection = True
            self.send(refused.status, TEXT, f"{refused.status}\n")
        except (BrokenPipeError, ConnectionResetError):
            self.close_connection = True

    def require_own_page(self):
        """That host and origin are those of this server."""
        hosts, origins = self.headers.get_all("Host", []), self.headers.get_all("Origin", [])
        own = [f"http://{host}" for host in self.server.hosts]
        if len(hosts) != 1 or hosts[0] not in self.server.hosts or not all(origin in own for origin in origins):
            raise Refused(403)

    def name(self):
        """What follows the token; the comparison takes as long for any wrong token."""
        parts = self.path.split("/", 2)
        token = parts[1] if len(parts) == 3 and not parts[0] else ""
        if not hmac.compare_digest(token.encode(), self.server.token.encode()):
            raise Refused(404)
        return parts[2]

    def content(self):
        """The JSON object that was sent."""
        if self.headers.get_content_type() != JSON:
            raise Refused(415)
        length = self.headers.get("Content-Length", "")
        if "Transfer-Encoding" in self.headers or not length.isascii() or not length.isdigit():
            raise Refused(411)
        if int(length) > MOST_BYTES:
            raise Refused(413)
        try:
            content = json.loads(self.rfile.read(int(length)))
        except (ValueError, RecursionError):
            raise Refused(400) from None
        if not isinstance(content, dict):
            raise Refused(400)
        return content

    def send(self, status, kind, text):
        body = text.encode("utf-8", "replace")
        self.send_response(status)
        for header, value in (HEADERS | {"Content-Type": f"{kind}; charset=utf-8", "Content-Length": len(body)}).items():
            self.send_header(header, str(value))
        if self.close_connection:
            self.send_header("Connection", "close")
        self.end_headers()
        self.wfile.write(body)

    def send_page(self):
        self.server.presence.change(0)
        self.send(200, HTML, self.server.page)

    def stay_open(self):
        """A byte every two seconds, until the page closes."""
        self.close_connection = True
        self.server.presence.change(1)
        try:
            self.send_response(200)
            for header, value in (HEADERS | {"Content-Type": TEXT, "Connection": "close"}).items():
                self.send_header(header, value)
            self.end_headers()
            while True:
                self.wfile.write(b".")
                self.wfile.flush()
                if select.select([self.connection], [], [], BEAT)[0]:
                    return  # the page ended the connection
        finally:
            self.server.presence.change(-1)

    def run(self):
        content = self.content()
        number = content.get("number")
        if type(number) not in (int, float) or not 0 < number < 2**53:
            raise Refused(400)
        self.send(200, JSON, self.server.workbench.run(number, content.get("state")))

    def save(self):
        content = self.content()
        what = content.get("what")
        if not isinstance(what, str) or what not in ENDINGS:
            raise Refused(400)
        self.send(200, JSON, self.server.workbench.save(content.get("state"), what))
