"""`frazil sweep`: one case at many points, on Snakemake. A module imports only those of earlier lines:

    needs                    Debian's packages for it, only when they are wanted
    metrics                  what a run is asked
    loader, study, vary, reader, points     the study file; its points and their names
    study_folder, table      the files of a study folder; results as CSV and HDF5
    plots, page              figures and the HTML page
    estimate                 how long it will take
    lock, jobs, run          one sweep at a time; Snakemake's command line; the sweep as a whole
    point                    one point of it: what Snakemake starts (`python3 cases/tools/sweep FOLDER POINT`)
"""
