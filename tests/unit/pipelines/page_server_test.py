import contextlib
import http.client
import json
import threading
import time
import unittest
from unittest import mock

from bench import page_server
from bench.page_server import PageServer, Presence

PAGE = "<p>ü</p>"


class FakeBench:
    def run(self, number, state):
        return json.dumps({"number": number, "state": state})

    def save(self, state, what):
        return json.dumps({"what": what, "state": state})


class ServerTest(unittest.TestCase):
    def setUp(self):
        self.server = PageServer(0, "secret", PAGE, FakeBench())
        threading.Thread(target=self.server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True).start()
        self.addCleanup(self.server.server_close)
        self.addCleanup(self.server.shutdown)
        self.port = self.server.server_address[1]

    def ask(self, method, path, body=None, **headers):
        """Status and text. Names of headers with _ for -; None leaves a header out."""
        headers = {"Host": f"127.0.0.1:{self.port}"} | {key.replace("_", "-"): value for key, value in headers.items()}
        with contextlib.closing(http.client.HTTPConnection("127.0.0.1", self.port, timeout=10)) as connection:
            connection.putrequest(method, path, skip_host=True)
            for key, value in headers.items():
                for one in value if isinstance(value, list) else [value]:
                    if one is not None:
                        connection.putheader(key, one)
            connection.endheaders(body)
            answer = connection.getresponse()
            return answer.status, answer.read().decode()

    def post(self, name, content, **headers):
        body = content if isinstance(content, bytes) else json.dumps(content).encode()
        headers = {"Content_Type": "application/json", "Content_Length": str(len(body))} | headers
        return self.ask("POST", f"/secret/{name}", body, **headers)

    def test_the_page_and_the_answers(self):
        self.assertEqual(self.ask("GET", "/secret/"), (200, PAGE))
        self.assertEqual(self.post("run", {"number": 3, "state": {"size": 1}}), (200, '{"number": 3, "state": {"size": 1}}'))
        self.assertEqual(self.post("save", {"what": "nodes", "state": {}}), (200, '{"what": "nodes", "state": {}}'))

    def test_without_the_token_nothing_is_answered(self):
        for path in ("/", "/secre/", "/secrets/", "/secret", "/secret/x", "/secret/../secret/", "/%73ecret/",
                     "/secret/?x", "/Secret/", "http://127.0.0.1/secret/", "*",
                     "/secret/run", "/secret//etc/passwd", "/secret/../../etc/passwd"):
            self.assertEqual(self.ask("GET", path), (404, "404\n"), path)
        self.assertEqual(self.ask("POST", "/run", b"{}", Content_Length="2")[0], 404)
        self.assertEqual(self.post("page", {})[0], 404)
        for method in ("PUT", "DELETE", "HEAD", "OPTIONS"):
            self.assertEqual(self.ask(method, "/secret/")[0], 501)

    def test_only_this_host_by_its_own_names(self):
        own = f"localhost:{self.port}"
        self.assertEqual(self.ask("GET", "/secret/", Host=own)[0], 200)
        for host in ("evil.example", f"evil.example:{self.port}", "127.0.0.1", f"127.0.0.2:{self.port}", "", None,
                     f"127.0.0.1:{self.port + 1}", [own, own]):
            self.assertEqual(self.ask("GET", "/secret/", Host=host)[0], 403, host)

    def test_only_from_the_own_page(self):
        for origin in (f"http://127.0.0.1:{self.port}", f"http://localhost:{self.port}"):
            self.assertEqual(self.post("run", {"number": 1, "state": {}}, Origin=origin)[0], 200)
        for origin in ("null", "http://evil.example", f"https://127.0.0.1:{self.port}", "http://127.0.0.1", ""):
            self.assertEqual(self.post("run", {"number": 1, "state": {}}, Origin=origin)[0], 403, origin)

    def test_only_json_of_at_most_a_megabyte(self):
        for kind in ("text/plain", "application/x-www-form-urlencoded", "multipart/form-data", None):
            self.assertEqual(self.post("run", {"number": 1}, Content_Type=kind)[0], 415, kind)
        for body in (b"", b"{", b"[1]", b"\xff", b"[" * 100000, b'{"number": 0}', b'{"number": true}', b'{"number": NaN}', b"{}"):
            self.assertEqual(self.post("run", body)[0], 400, body[:20])
        self.assertEqual(self.post("save", {"what": "/etc/passwd", "state": {}})[0], 400)
        self.assertEqual(self.post("save", {"what": ["nodes"], "state": {}})[0], 400)
        self.assertEqual(self.post("run", b"", Content_Length="1048577")[0], 413)
        for length in (None, "-1", "1e3", "²"):
            self.assertIn(self.post("run", b"{}", Content_Length=length)[0], (400, 411), length)
        self.assertEqual(self.post("run", b"2\r\n{}\r\n0\r\n\r\n", Content_Length=None, Transfer_Encoding="chunked")[0], 411)

    def test_nothing_is_kept_by_the_browser_or_shown_in_a_frame(self):
        with contextlib.closing(http.client.HTTPConnection("127.0.0.1", self.port, timeout=10)) as connection:
            connection.request("GET", "/secret/")
            answer = connection.getresponse()
            self.assertEqual(answer.headers["Cache-Control"], "no-store")
            self.assertEqual(answer.headers["Content-Security-Policy"], "frame-ancestors 'none'")

    def test_the_end_follows_the_last_page(self):
        presence = self.server.presence
        with mock.patch.object(page_server, "BEAT", 0.05), mock.patch.object(page_server, "GRACE", 0.3):
            self.ask("GET", "/secret/")
            self.assertFalse(presence.is_over())
            connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=10)
            connection.request("GET", "/secret/alive")
            answer = connection.getresponse()
            self.assertEqual(answer.read(3), b"...")
            self.assertEqual(presence.open, 1)
            self.assertFalse(presence.is_over())
            answer.close()
            connection.close()
            start = time.monotonic()
            while not presence.is_over():
                self.assertLess(time.monotonic() - start, 10)
                time.sleep(0.01)
            self.assertGreater(time.monotonic() - start, 0.2)


class PresenceTest(unittest.TestCase):
    def test_a_page_that_is_loaded_again_keeps_the_server(self):
        presence = Presence()
        with mock.patch.object(time, "monotonic", side_effect=lambda: self.now):
            self.now = 0
            presence.change(0)
            self.now = 100
            self.assertFalse(presence.is_over())
            presence.change(1)
            presence.change(-1)
            self.now = 102
            presence.change(0)
            self.now = 104
            self.assertFalse(presence.is_over())
            self.now = 106
            self.assertTrue(presence.is_over())
