"""Styles: the bank of style vectors and its blends (Mason et al. 2022, sections 4.4 and 5.3.2)."""

from toolkit.networks.bank import StyleBank

__all__ = ["StyleBank"]
