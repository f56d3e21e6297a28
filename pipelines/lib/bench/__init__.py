"""The workbench (quadbench): a server on this machine alone, whose page edits names, sizes, layers and nodes of a mesh.

    state          what was done in the page, and the options of quadmesh that do it
    work_folder    stage files, and which of them a change makes old
    workbench      one run after another, the newest first; files to save
    saved_files    the command, the rule of a makefile and the nodes, for the folder of the shape
    page_server    addresses, what is answered, and when the server ends
"""
