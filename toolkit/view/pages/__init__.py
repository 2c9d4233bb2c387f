"""Web pages that need no server.

Clips that play, and a character whose network runs in the browser.
"""

from toolkit import registry

__getattr__, __dir__, __all__ = registry.modules(__name__, __path__)
