"""A Jupyter server that passes small messages on at once, so that live pictures do not arrive in bunches.

A frame of `toolkit.view.Controller` is a message of 1.6 kB. A server holds such a message back until the page has confirmed
the one before (Nagle's algorithm), which browsers do after 40 ms: frames come by twos and threes. The page shows them in
turn all the same; with this extension the picture follows a key in about 50 ms instead of 75. To use it, as
``make lab`` does: ``jupyter lab --ServerApp.jpserver_extensions="{'toolkit.view.server': True}"``.
"""

from jupyter_server.services.kernels.connection.channels import ZMQChannelsWebsocketConnection


class PromptConnection(ZMQChannelsWebsocketConnection):
    """The usual connection of a page to its kernel, without Nagle's algorithm."""

    def connect(self):
        """Connect; returns the future that the server waits for."""
        self.websocket_handler.set_nodelay(True)
        return super().connect()


def _jupyter_server_extension_points() -> list[dict[str, str]]:
    return [{"module": "toolkit.view.server"}]


def _load_jupyter_server_extension(server) -> None:
    """Use the connection, unless the server is set up with one of its own."""
    if server.web_app.settings["kernel_websocket_connection_class"] is ZMQChannelsWebsocketConnection:
        server.web_app.settings["kernel_websocket_connection_class"] = PromptConnection
