"""The command line ``python -m toolkit VERB``: one module a verb."""
