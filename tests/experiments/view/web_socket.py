# SPDX-License-Identifier: BSD-3-Clause
"""A WebSocket (RFC 6455) of a few lines, which can also do what it must not."""
import base64
import os
import socket
import struct

TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10
PAGE, FOXGLOVE = "gmapping_spa.view.v1", "foxglove.websocket.v1"


def request(port, lines, timeout_s=10):
    """Sends lines of a request; returns the open socket, the status and the head of the answer."""
    connection = socket.create_connection(("127.0.0.1", port), timeout=timeout_s)
    connection.sendall(("\r\n".join(lines) + "\r\n\r\n").encode("latin-1"))
    head = b""
    while b"\r\n\r\n" not in head:
        more = connection.recv(1)
        if not more:
            break
        head += more
    status = int(head.split(b" ", 2)[1]) if head.startswith(b"HTTP/1.") else None
    return connection, status, head.decode("latin-1")


def open_socket(port, protocol=PAGE, origin=None, host=None):
    """The socket and the status: 101 where it was accepted."""
    key = base64.b64encode(os.urandom(16)).decode()
    lines = ["GET / HTTP/1.1", f"Host: {host or f'127.0.0.1:{port}'}", "Upgrade: websocket",
             "Connection: Upgrade", f"Sec-WebSocket-Key: {key}", "Sec-WebSocket-Version: 13",
             f"Sec-WebSocket-Protocol: {protocol}"]
    connection, status, _ = request(port, lines + ([f"Origin: {origin}"] if origin else []))
    return connection, status


def send(connection, data, opcode=TEXT):
    mask = os.urandom(4)
    size = len(data)
    head = bytes([0x80 | opcode])
    if size < 126:
        head += bytes([0x80 | size])
    elif size < 1 << 16:
        head += bytes([0x80 | 126]) + struct.pack(">H", size)
    else:
        head += bytes([0x80 | 127]) + struct.pack(">Q", size)
    connection.sendall(head + mask + bytes(byte ^ mask[i % 4] for i, byte in enumerate(data)))


def read_exactly(connection, size):
    data = b""
    while len(data) < size:
        more = connection.recv(size - len(data))
        if not more:
            raise EOFError
        data += more
    return data


def receive(connection):
    """Opcode and data of the next frame; EOFError where the other end has gone."""
    first, second = read_exactly(connection, 2)
    size = second & 0x7f
    if size == 126:
        size, = struct.unpack(">H", read_exactly(connection, 2))
    elif size == 127:
        size, = struct.unpack(">Q", read_exactly(connection, 8))
    return first & 0x0f, read_exactly(connection, size)


def is_closed(connection):
    """Whether the other end closes it, after what it has sent before."""
    try:
        while receive(connection)[0] != CLOSE:
            pass
    except (EOFError, ConnectionError):
        pass
    except TimeoutError:
        return False
    return True
