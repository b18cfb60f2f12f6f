"""Sieve tests as laboratories print them, each with what a careful reader would read.

sample.py has the test itself, words.py what is written beside its numbers, table.py the table, truth.py what it says,
kinds.py the kinds of sheets, printing.py the files. Nothing here knows how the program reads.
"""
