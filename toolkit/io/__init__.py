"""Motion files and model files: read and written whole or not at all."""
