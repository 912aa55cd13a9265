#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever comes in at the port of the view: it is refused or served, and the SLAM goes on."""
import json
import os
import socket
import time
import unittest

import view_fixture
import web_socket
from web_socket import FOXGLOVE, PAGE


class ViewAbuseTest(view_fixture.ViewTestCase):
    def setUp(self):
        super().setUp()
        self.program = self.start("--view_keep")
        self.port = self.program.port
        # Begins the run, and looks at it to the end.
        self.page, status = web_socket.open_socket(self.port)
        self.addCleanup(self.page.close)
        self.assertEqual(status, 101)

    def open(self, *arguments, **options):
        connection, status = web_socket.open_socket(self.port, *arguments, **options)
        self.addCleanup(connection.close)
        return connection, status

    def status_of(self, *lines):
        connection, status, _ = web_socket.request(self.port, lines)
        connection.close()
        return status

    def expect_slam_finishes(self):
        end = time.monotonic() + 120
        while time.monotonic() < end:
            opcode, data = web_socket.receive(self.page)
            if opcode == web_socket.PING:
                web_socket.send(self.page, data, web_socket.PONG)
            if opcode == web_socket.TEXT and json.loads(data).get("phase") == "finished":
                return
        self.fail("the run has not finished")

    def test_requests_that_are_none_are_refused(self):
        host = f"Host: 127.0.0.1:{self.port}"
        self.assertEqual(self.status_of("GET / HTTP/1.1", host), 200)
        self.assertEqual(self.status_of("GET /main.js HTTP/1.1", host), 200)
        self.assertEqual(self.status_of("GET /../../etc/passwd HTTP/1.1", host), 404)
        self.assertEqual(self.status_of("POST / HTTP/1.1", host, "Content-Length: 0"), 405)
        self.assertEqual(self.status_of("GET / HTTP/1.1", "Host: evil.example"), 421)
        self.assertEqual(self.status_of("GET / HTTP/1.1"), 421)
        self.assertEqual(self.status_of("\x00\xff\x13garbage"), 400)
        self.assertEqual(self.status_of("GET / HTTP/1.1", host, "X: " + "x" * 100000), 400)
        self.expect_slam_finishes()

    def test_pages_of_other_origins_are_refused(self):
        own = f"http://127.0.0.1:{self.port}"
        for protocol, origin, expected in (
                (PAGE, own, 101), (PAGE, "http://evil.example", 403), (PAGE, "null", 403),
                (PAGE, f"http://localhost:{self.port}", 403), (PAGE, "https://app.foxglove.dev", 403),
                (FOXGLOVE, own, 101), (FOXGLOVE, "https://app.foxglove.dev", 101),
                (FOXGLOVE, "http://evil.example", 403), ("other", own, 400)):
            with self.subTest(protocol=protocol, origin=origin):
                self.assertEqual(self.open(protocol, origin)[1], expected)
        self.assertEqual(self.open(PAGE, host=f"evil.example:{self.port}")[1], 421)
        self.expect_slam_finishes()

    def test_garbage_and_long_messages_end_their_own_conversation(self):
        for data, opcode in ((b"{", web_socket.TEXT), (b"[]", web_socket.TEXT),
                             (b'{"op": "format_disk"}', web_socket.TEXT),
                             (b'{"op": 1}', web_socket.TEXT), (b"\xff\xfe", web_socket.TEXT),
                             (b"\x01" * 9, web_socket.BINARY), (b"x", 3),
                             (b" " * 5000, web_socket.TEXT), (b"", 15)):
            for protocol in (PAGE, FOXGLOVE):
                if protocol == FOXGLOVE and b"format" in data:
                    continue  # is answered by a status
                with self.subTest(data=data[:30], opcode=opcode, protocol=protocol):
                    connection, _ = self.open(protocol)
                    web_socket.send(connection, data, opcode)
                    self.assertTrue(web_socket.is_closed(connection))
        raw, _ = self.open()
        raw.sendall(os.urandom(10000))
        self.assertTrue(web_socket.is_closed(raw))
        huge, _ = self.open()
        huge.sendall(b"\x81\xff" + b"\x7f" + b"\xff" * 7 + b"mask")  # of 2^63 bytes
        self.assertTrue(web_socket.is_closed(huge))
        self.expect_slam_finishes()

    def test_foxglove_with_odd_subscriptions_is_answered(self):
        for message in ({"op": "subscribe", "subscriptions": [{"id": 1, "channelId": 10 ** 9}]},
                        {"op": "advertise", "channels": []}):
            connection, _ = self.open(FOXGLOVE)
            web_socket.send(connection, json.dumps(message).encode())
            answers = [json.loads(web_socket.receive(connection)[1])["op"] for _ in range(3)]
            self.assertEqual(answers, ["serverInfo", "advertise", "status"])
        for broken in ({"op": "subscribe"}, {"op": "subscribe", "subscriptions": [{"id": "x"}]},
                       {"op": "unsubscribe", "subscriptionIds": [{}]}):
            connection, _ = self.open(FOXGLOVE)
            web_socket.send(connection, json.dumps(broken).encode())
            self.assertTrue(web_socket.is_closed(connection))
        self.expect_slam_finishes()

    def test_a_hundred_clients_are_served_or_turned_away(self):
        statuses = [self.open()[1] for _ in range(100)]
        self.assertEqual(statuses.count(101), 31)  # with the page
        self.assertEqual(statuses.count(503), 69)
        self.expect_slam_finishes()

    def test_connections_that_say_nothing_do_no_harm(self):
        for _ in range(300):
            silent = socket.create_connection(("127.0.0.1", self.port))
            self.addCleanup(silent.close)
        self.expect_slam_finishes()

    def test_client_that_does_not_read_costs_bounded_memory(self):
        for _ in range(10):
            self.open()
        self.expect_slam_finishes()
        with open(f"/proc/{self.program.process.pid}/status", encoding="ascii") as status:
            peak_kb = next(int(line.split()[1]) for line in status if line.startswith("VmHWM"))
        self.assertLess(peak_kb, 300_000)

    def test_pause_ends_when_nobody_looks_any_more(self):
        web_socket.send(self.page, b'{"op": "pause"}')
        time.sleep(0.5)
        self.page.close()
        time.sleep(11)
        self.page, _ = self.open()
        self.expect_slam_finishes()


if __name__ == "__main__":
    unittest.main()
