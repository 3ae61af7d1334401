"""`./frazil report`: one page, one HTML file, about one run or several side by side. A module imports only those of earlier
lines; what a run can be asked is in the package diagnostics.

    figure            palette, units of axes, a figure as part of the page
    views             one cut through the axis, also for cases/tools/picture.py
    curves, cuts, cracks, sizes, scene, shares     figures, one function each
    tables            what was run, values, parameters
    section, sections what makes up the page
    page              the page; page.html and page.css are its template
"""
