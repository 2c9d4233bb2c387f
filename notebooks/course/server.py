"""A Jupyter server that sends small messages at once, so that live pictures do not arrive in
groups.

A frame of `toolkit.view.Controller` is a message of 1.6 kB. With Nagle's algorithm a server holds
such a message back until the browser has confirmed the one before, which takes up to 40 ms. With
this extension the picture follows a key in about 50 ms instead of 75. ``make lab`` uses it:
``jupyter lab --ServerApp.jpserver_extensions="{'course.server': True}"``.
"""

from jupyter_server.services.kernels.connection.channels import ZMQChannelsWebsocketConnection


class PromptConnection(ZMQChannelsWebsocketConnection):
    """The usual connection of a page to its kernel, without Nagle's algorithm."""

    def connect(self):
        """Connect; returns the future that the server waits for."""
        self.websocket_handler.set_nodelay(True)
        return super().connect()


def _jupyter_server_extension_points() -> list[dict[str, str]]:
    return [{"module": "course.server"}]


def _load_jupyter_server_extension(server) -> None:
    """Use the connection, unless the server is configured with another one."""
    settings = server.web_app.settings
    if settings["kernel_websocket_connection_class"] is ZMQChannelsWebsocketConnection:
        settings["kernel_websocket_connection_class"] = PromptConnection
