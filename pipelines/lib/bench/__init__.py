"""The workbench (quadbench): a server on this machine alone, whose page edits names, sizes, layers and nodes of a mesh.

    state          what was done in the page, and the options of quadmesh that do it
    processes      commands of the newest run only
    work_folder    stage files, and which of them a change makes old
    workbench      the mesh of a state, and files to save of it
    saved_files    the command, the rule of a makefile and the nodes, for the folder of the shape
    page_server    addresses, what is answered, and when the server ends
"""
