"""Exercises of the notebooks: each module has some of them in ``EXERCISES``, name -> `toolkit.course.Exercise`."""
