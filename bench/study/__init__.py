"""What the studies share: runs that can be stopped and go on, tables, particle files, pictures, and where it was measured."""
