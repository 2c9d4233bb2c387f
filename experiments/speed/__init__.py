"""Speed of each part of the package, compared with its alternatives."""
